// The table [body] of a scene: what moves, and how it starts.
#pragma once

#include <array>
#include <limits>
#include <string_view>

#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/dynamics/bristle_metric.h>

namespace patchgrip::cli {

struct MovingBody {
  double mass;
  double inertia = std::numeric_limits<double>::quiet_NaN();  // none of a point
  dynamics::Vector3 place = dynamics::Vector3::Zero();
  dynamics::Vector3 twist = dynamics::Vector3::Zero();
  bool settled = false;           // bristles carry the load from the start
  double spring = 0, damper = 0;  // of a point, to the origin
  double support_speed = 0;       // of what a point rubs on
};

// All throw SceneError.
TomlReader body_table(const TomlReader& scene);  // [body], with all its keys
MovingBody read_body(const TomlReader& scene, bool point);

// A pair [x, y], with 0 as its third; 0 where it is not given.
dynamics::Vector3 read_pair(const TomlReader& table, std::string_view key, const Quantity& quantity,
                            std::string_view allowed);

}  // namespace patchgrip::cli
