// The answer of one static contact, and the surface under it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <patchgrip/cli/press/answer.h>
#include <patchgrip/cli/press/press_scene.h>
#include <patchgrip/cli/table.h>
#include <patchgrip/contact/estimate.h>

namespace patchgrip::cli {

using contact::Estimate;

struct SurfacePoint {
  Estimate pressure;        // [Pa]
  Estimate displacement{};  // u_z [m]
  Estimate gap{};           // between the surfaces [m]; 0 in the contact
};

struct PressureBeside {
  std::string law;
  std::function<double(double x, double y)> pressure;  // [Pa]
};

struct Pressed {
  Answer answer;
  double extent;                                              // contact radius or major semi-axis [m]
  std::function<SurfacePoint(double x, double y)> surface{};  // empty where the law says nothing of it
  std::vector<PressureBeside> beside{};
  bool knows_displacement = true;  // else the surface has a pressure alone
  std::optional<Table> map{};      // the pressure of every cell of a grid
};

// One function per subject; press() calls the right one. Library errors (std::invalid_argument, std::runtime_error)
// pass.
Pressed press(const PressScene& scene);

}  // namespace patchgrip::cli
