// data/reference/grasp.json: its grasps and numbers.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/grasp/grasp.h>

namespace patchgrip::grasp {

using nlohmann::json;

inline const json& grasp_table() {
  static const json table = json::parse(std::ifstream(PATCHGRIP_DATA_DIR "/reference/grasp.json"));
  return table;
}

inline double number(const json& text) { return std::stod(text.get<std::string>()); }

inline Vector3 vector3(const json& list) {
  return {number(list[0]), number(list[1]), list.size() > 2 ? number(list[2]) : 0};
}

// Planar loads and twists are (fx, fy, mz).
inline Vector6 vector6(const json& list) {
  Vector6 w = Vector6::Zero();
  if (list.size() == 6) {
    for (int i = 0; i < 6; ++i) w[i] = number(list[static_cast<std::size_t>(i)]);
  } else {
    w << number(list[0]), number(list[1]), 0, 0, 0, number(list[2]);
  }
  return w;
}

inline FrictionCone cone(const json& c) {
  const std::string model = c["model"];
  const auto value = [&](const char* name) { return number(c[name]); };
  if (model == "frictionless") return FrictionCone::frictionless();
  const double mu = value("mu");
  using namespace friction;
  if (model == "point") return FrictionCone::point(mu);
  if (model == "soft_elliptic") return FrictionCone::soft_elliptic(mu, value("e_m"));
  if (model == "soft_linear") return FrictionCone::soft_linear(mu, value("e_m"));
  if (model == "hertz_disc") return FrictionCone::patch(mu, HertzDisc::of_radius(value("a")));
  if (model == "uniform_disc") return FrictionCone::patch(mu, UniformDisc::of_radius(value("a")));
  if (model == "flat_punch_disc") return FrictionCone::patch(mu, FlatPunchDisc::of_radius(value("a")));
  if (model == "hertz_ellipse") return FrictionCone::patch(mu, HertzEllipse::of_semi_axes(value("a"), value("b")));
  if (model == "uniform_rectangle") return FrictionCone::patch(mu, Rectangle::of_sides(value("l_u"), value("l_v")));
  throw std::runtime_error("no such model: " + model);
}

inline std::vector<Contact> contacts(const std::string& id) {
  std::vector<Contact> all;
  for (const json& grasp : grasp_table()["grasps"]) {
    if (grasp["id"] != id) continue;
    for (const json& c : grasp["contacts"]) {
      all.emplace_back(ContactFrame{vector3(c["position"]), vector3(c["normal_out"]), vector3(c["u"])}, cone(c));
    }
  }
  return all;
}

inline std::vector<json> cases_of(const std::string& problem) {
  std::vector<json> found;
  for (const json& c : grasp_table()["cases"]) {
    if (c["problem"] == problem) found.push_back(c);
  }
  return found;
}

}  // namespace patchgrip::grasp
