// Scenes of `patchgrip limit` as text, and contacts of the reference table as scenes.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <patchgrip/cli/limit/limit_scene.h>
#include <patchgrip/cli/limit/load_answer.h>
#include <patchgrip/cli/limit/run_limit.h>

#include "scenes.h"

namespace patchgrip::cli::test {

inline const std::filesystem::path limit_folder = data_folder / "scenes" / "limit";

inline std::vector<std::string> committed_limit_scenes() { return scenes_in(limit_folder); }

inline const std::string good_limit = R"([contact]
patch = "hertz_disc"
radius = 0.005
normal_force = 10
[friction]
mu = 0.5
[[loads]]
force = [3, 0.5]
moment = 0.002
)";

inline LimitScene limit_scene(std::string text) {
  const TomlDocument document = TomlDocument::parse(std::move(text), (limit_folder / "scene.toml").string());
  return read_limit_scene(document, MaterialLibrary({data_folder / "materials"}));
}

// Points [["1", "2"], ...] of the table as they stand in a scene.
inline std::string points_of(const nlohmann::json& points) {
  std::string text;
  for (const auto& p : points) {
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", p[0].get<std::string>(), p[1].get<std::string>());
  }
  return "[" + text + "]";
}

// The keys of a patch, without its force.
inline std::string patch_keys(const nlohmann::json& contact) {
  const auto text = [&](const char* key) { return contact.at(key).get<std::string>(); };
  const std::string type = text("type");
  std::string keys;
  if (type == "hertz_disc" || type == "uniform_disc") {
    keys = fmt::format("patch = \"{}\"\nradius = {}\n", type, text("radius_m"));
  } else if (type == "rectangle_uniform") {
    keys = fmt::format("patch = \"rectangle\"\nsides = [{}, {}]\n", text("l_xi_m"), text("l_eta_m"));
  } else if (type == "hertz_ellipse") {
    keys = fmt::format("patch = \"hertz_ellipse\"\nsemi_axes = [{}, {}]\n", text("semi_axis_xi_m"),
                       text("semi_axis_eta_m"));
  } else if (type == "polygon_uniform") {
    keys = fmt::format("patch = \"polygon\"\nvertices = {}\n", points_of(contact.at("vertices_m")));
    if (contact.contains("holes_m")) {
      std::string holes;
      for (const auto& hole : contact.at("holes_m")) holes += (holes.empty() ? "" : ", ") + points_of(hole);
      keys += "holes = [" + holes + "]\n";
    }
  } else {
    throw std::logic_error("no scene for a " + type);
  }
  if (contact.contains("centre_m")) {
    keys += fmt::format("centre = [{}, {}]\n", contact["centre_m"][0].get<std::string>(),
                        contact["centre_m"][1].get<std::string>());
  }
  return keys;
}

// The table [contact]; F_N = 1 N unless the parts have their own.
inline std::string contact_table_of(const nlohmann::json& contact) {
  if (!contact.contains("parts")) return "[contact]\nnormal_force = 1\n" + patch_keys(contact);
  std::string text;
  for (const auto& part : contact["parts"]) {
    text += "[[contact.parts]]\n" + patch_keys(part) +
            "normal_force = " + part.at(part.contains("share") ? "share" : "F_N").get<std::string>() + "\n";
    if (part.contains("mu")) text += "mu = " + part["mu"].get<std::string>() + "\n";
  }
  return text;
}

inline std::string load_of(const nlohmann::json& t) {
  return fmt::format("[[loads]]\nforce = [{}, {}]\nmoment = {}\n", t[0].get<std::string>(), t[1].get<std::string>(),
                     t[2].get<std::string>());
}

}  // namespace patchgrip::cli::test
