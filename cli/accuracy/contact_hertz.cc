// Kinds about Hertz contact of bodies of any curvature.
#include <array>
#include <cmath>

#include <patchgrip/cli/accuracy/contact_kinds.h>
#include <patchgrip/contact/dundurs.h>
#include <patchgrip/contact/hertz_ellipse.h>
#include <patchgrip/contact/material.h>
#include <patchgrip/contact/principal_curvatures.h>
#include <patchgrip/contact/stick_radius.h>

namespace patchgrip::cli {
namespace {

using contact::HertzEllipse;
using contact::Material;
using contact::RelativeRadii;

std::vector<Output> material_pair(const EntryInputs& in) {
  const auto p = Material::elastic(in["E_p"], in["nu_p"]), m = Material::elastic(in["E_m"], in["nu_m"]);
  const auto pair = contact::Dundurs::of(p, m);
  return {{"E_star", contact::contact_modulus(p, m)},
          {"beta_dundurs", std::fabs(pair.beta)},
          {"beta_thesis_printed", pair.seed_printed_beta()}};
}

RelativeRadii bodies(const EntryInputs& in) {
  return RelativeRadii::of_bodies({in["R1p"], in["R2p"]}, {in["R1m"], in["R2m"]}, in["alpha"]);
}

std::vector<Output> relative_radii(const EntryInputs& in) {
  const auto radii = bodies(in);
  return {{"R_small", radii.small}, {"R_large", radii.large}};
}

RelativeRadii radii_of_ratio(const EntryInputs& in) {
  return RelativeRadii::of(in["ratio"] * in["R_large"], in["R_large"]);
}

std::vector<Output> hertz_ellipse(const EntryInputs& in) {
  const auto radii = radii_of_ratio(in);
  const auto h = HertzEllipse::at_approach(in["delta"], radii, in["E_star"]);
  const auto shape = contact::shape_of(radii);
  const auto small = shape.against_small_radius(), large = shape.against_large_radius();
  std::vector<Output> outputs{{"e", h.eccentricity},
                              {"a", h.a},
                              {"b", h.b},
                              {"p0", h.peak_pressure},
                              {"F_N", h.normal_force},
                              {"R_e", std::sqrt(radii.small) * std::sqrt(radii.large)}};
  const auto give = [&](const char* name, long double value) { outputs.push_back({name, static_cast<double>(value)}); };
  give("b_over_a", shape.k);
  give("F1", shape.seed_F1());
  give("F2", shape.seed_F2());
  give("f_p_ref_Rsmall", small.pressure);
  give("f_FN_ref_Rsmall", small.force);
  give("f_a_ref_Rsmall", small.a);
  give("f_b_ref_Rsmall", small.b);
  give("f_p_ref_Rlarge", large.pressure);
  give("f_FN_ref_Rlarge", large.force);
  give("f_a_ref_Rlarge", large.a);
  give("f_b_ref_Rlarge", large.b);
  return outputs;
}

std::vector<Output> loaded(const HertzEllipse& h) {
  return {{"a", h.a},
          {"b", h.b},
          {"one_minus_b_over_a", h.one_minus_b_a},
          {"e", h.eccentricity},
          {"p0", h.peak_pressure},
          {"delta", h.approach},
          {"stiffness", h.stiffness}};
}

std::vector<Output> hertz_ellipse_from_load(const EntryInputs& in) {
  return loaded(HertzEllipse::under_force(in["F_N"], radii_of_ratio(in), in["E_star"]));
}

std::vector<Output> hertz_ellipse_near_circular(const EntryInputs& in) {
  const auto radii = RelativeRadii::of_one_minus_ratio(in["one_minus_ratio"], in["R_large"]);
  return loaded(HertzEllipse::under_force(in["F_N"], radii, in["E_star"]));
}

std::vector<Output> hertz_ellipse_field(const EntryInputs& in) {
  const auto pressure = contact::EllipticPressure::of(in["a"], in["b"], in["p0"]);
  return {{"u_z_at_xy", pressure.displacement(in["x"], in["y"], in["E_star"])}};
}

std::vector<Output> hertz_pair(const EntryInputs& in) {
  const double modulus =
      contact::contact_modulus(Material::elastic(in["E_p"], in["nu_p"]), Material::elastic(in["E_m"], in["nu_m"]));
  const auto radii = bodies(in);
  auto outputs = loaded(HertzEllipse::under_force(in["F_N"], radii, modulus));
  outputs.insert(
      outputs.end(),
      {{"E_star", modulus}, {"R_small", radii.small}, {"R_large", radii.large}, {"angle_a_from_R1p", radii.angle_a}});
  return outputs;
}

std::vector<Output> principal_curvatures_graph(const EntryInputs& in) {
  const auto k = contact::curvatures_of_graph(in["fx"], in["fy"], in["fxx"], in["fxy"], in["fyy"]);
  return {{"k_max", k.k_max}, {"k_min", k.k_min}, {"R_small", k.radii().R1}, {"R_large", k.radii().R2}};
}

std::vector<Output> ellipsoid_curvature(const EntryInputs& in) {
  const auto ellipsoid = contact::Ellipsoid::of_axes(in["ax"], in["ay"], in["az"]);
  const auto point = ellipsoid.point(in["u"], in["v"]);
  const auto k = ellipsoid.curvatures(in["u"], in["v"]);
  return {{"x", point[0]}, {"y", point[1]}, {"z", point[2]}, {"k_max", k.k_max}, {"k_min", k.k_min}};
}

std::vector<Output> stick_radius(const EntryInputs& in) {
  const auto ratio = contact::StickRatio::of(in["beta_over_mu"]);
  return {{"aS_over_aK", ratio.stick}, {"one_minus_aS_over_aK", ratio.slip}};
}

constexpr std::array<ContactKind, 10> kinds{{
    {"material_pair", material_pair},
    {"relative_radii", relative_radii},
    {"hertz_ellipse", hertz_ellipse},
    {"hertz_ellipse_from_load", hertz_ellipse_from_load},
    {"hertz_ellipse_near_circular", hertz_ellipse_near_circular},
    {"hertz_ellipse_field", hertz_ellipse_field},
    {"hertz_pair", hertz_pair},
    {"principal_curvatures_graph", principal_curvatures_graph},
    {"ellipsoid_curvature", ellipsoid_curvature},
    {"stick_radius", stick_radius},
}};

}  // namespace

std::span<const ContactKind> hertz_kinds() { return kinds; }

}  // namespace patchgrip::cli
