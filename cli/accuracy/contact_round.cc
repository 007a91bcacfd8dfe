// Kinds about round contacts.
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <patchgrip/cli/accuracy/contact_kinds.h>
#include <patchgrip/contact/cone.h>
#include <patchgrip/contact/elliptic_power_pressure.h>
#include <patchgrip/contact/flat_end_cone.h>
#include <patchgrip/contact/flat_end_paraboloid.h>
#include <patchgrip/contact/flat_punch.h>
#include <patchgrip/contact/hertz_axis_stress.h>
#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/point_profile.h>
#include <patchgrip/contact/power_profile.h>
#include <patchgrip/contact/power_sum.h>
#include <patchgrip/contact/rotational_pressure.h>
#include <patchgrip/contact/sphere.h>

namespace patchgrip::cli {
namespace {

using contact::AxisymmetricContact;

template <contact::Profile P>
AxisymmetricContact<P> at_radius(P profile, double radius, const EntryInputs& in) {
  return AxisymmetricContact<P>::at_radius(std::move(profile), radius, in["E_star"]);
}

template <contact::Profile P>
AxisymmetricContact<P> under_force(P profile, const EntryInputs& in) {
  return AxisymmetricContact<P>::under_force(std::move(profile), in["F_N"], in["E_star"]);
}

template <contact::Profile P>
AxisymmetricContact<P> at_approach(P profile, const EntryInputs& in) {
  return AxisymmetricContact<P>::at_approach(std::move(profile), in["delta"], in["E_star"]);
}

std::vector<Output> rotational_pressure(const EntryInputs& in) {
  const auto family = contact::RotationalPressure::of_curvature(in.integer("n"), in["a_K"], in["R"], in["E_star"]);
  return {{"p0", family.peak_pressure},
          {"p_at_r", family.pressure(in["r"])},
          {"F_N", family.force},
          {"delta", family.approach},
          {"f_at_r", family.height(in["r"])}};
}

std::vector<Output> elliptic_pressure(const EntryInputs& in) {
  const auto family = contact::EllipticPowerPressure::of(in.integer("n"), in["a"], in["b"], in["p0"], in["E_star"]);
  return {{"F_N", family.force},
          {"delta", family.approach},
          {"curvature_x", family.curvature_x},
          {"curvature_y", family.curvature_y},
          {"u_z_at_xy", family.displacement(in["x"], in["y"])}};
}

std::vector<Output> steuermann(const EntryInputs& in) {
  const auto zone = at_radius(contact::PowerProfile::through(in["c"], in["R"], 2 * in.integer("n")), in["a_K"], in);
  return {{"F_N", zone.force()},
          {"delta", zone.approach()},
          {"p_at_0", zone.pressure(0)},
          {"p_at_r", zone.pressure(in["r"])}};
}

std::vector<Output> power_profile(const EntryInputs& in) {
  const auto zone = at_radius(contact::PowerProfile::of_coefficient(in["A"], in["m"]), in["a"], in);
  return {{"F_N", zone.force()},
          {"delta", zone.approach()},
          {"p_at_r", zone.pressure(in["r"])},
          {"gamma_power_law", 1 / zone.growth_exponent()}};
}

std::vector<Output> power_profile_inverse(const EntryInputs& in) {
  const auto zone = under_force(contact::PowerProfile::of_coefficient(in["A"], in["m"]), in);
  return {{"a_K", zone.radius()},
          {"delta", zone.approach()},
          {"u_z_at_r_out", zone.displacement(in["r_out_over_a"] * zone.radius())},
          {"stiffness", zone.stiffness()}};
}

std::vector<Output> sphere(const EntryInputs& in) {
  const double a = in["a_over_R"] * in["R"];
  const auto zone = at_radius(contact::Sphere::of_radius(in["R"]), a, in);
  std::vector<Output> outputs{{"F_N", zone.force()},
                              {"delta", zone.approach()},
                              {"p_at_0", zone.pressure(0)},
                              {"p_at_half_a", zone.pressure(0.5 * a)},
                              {"p_at_0p9a", zone.pressure(0.9 * a)},
                              {"gamma_eff", 1 / zone.growth_exponent()}};
  for (const int n : {1, 2, 3, 4, 10}) {
    const auto series = at_radius(contact::PowerSum::sphere_series(in["R"], n), a, in);
    outputs.push_back({fmt::format("series{}_F_N", n), series.force()});
    outputs.push_back({fmt::format("series{}_delta", n), series.approach()});
    outputs.push_back({fmt::format("series{}_p_at_half_a", n), series.pressure(0.5 * a)});
  }
  return outputs;
}

std::vector<Output> sphere_inverse(const EntryInputs& in) {
  const auto zone = under_force(contact::Sphere::of_radius(in["R"]), in);
  const auto hertz = under_force(contact::Paraboloid::of_radius(in["R"]), in);
  return {{"a_over_R", std::tanh(zone.circle().s)},
          {"one_minus_a_over_R", zone.circle().one_minus_ratio()},
          {"delta", zone.approach()},
          {"delta_Hertz", hertz.approach()},
          {"stiffness", zone.stiffness()}};
}

std::vector<Output> sphere_from_approach(const EntryInputs& in) {
  const auto zone = at_approach(contact::Sphere::of_radius(in["R"]), in);
  const auto hertz = at_approach(contact::Paraboloid::of_radius(in["R"]), in);
  return {{"a_over_R", std::tanh(zone.circle().s)},
          {"one_minus_a_over_R", zone.circle().one_minus_ratio()},
          {"F_N", zone.force()},
          {"F_Hertz", hertz.force()}};
}

std::vector<Output> flat_punch(const EntryInputs& in) {
  const auto punch = contact::FlatPunch::under_force(in["R"], in["F_N"], in["E_star"]);
  return {{"delta", punch.approach}, {"p_at_r", punch.pressure(in["r"])}};
}

std::vector<Output> flat_punch_field(const EntryInputs& in) {
  const auto punch = contact::FlatPunch::under_force(in["R"], in["F_N"], in["E_star"]);
  return {{"u_z_at_r_out", punch.displacement(in["r_out"])},
          {"stiffness", punch.stiffness()},
          {"strain_energy", punch.strain_energy()}};
}

std::vector<Output> hertz_sphere(const EntryInputs& in) {
  const auto zone = at_approach(contact::Paraboloid::of_radius(in["R"]), in);
  return {{"a_K", zone.radius()}, {"F_N", zone.force()}, {"p_at_r", zone.pressure(in["r"])}, {"p0", zone.pressure(0)}};
}

std::vector<Output> hertz_sphere_field(const EntryInputs& in) {
  const auto zone = at_approach(contact::Paraboloid::of_radius(in["R"]), in);
  return {{"a_K", zone.radius()},
          {"u_z_at_r_out", zone.displacement(in["r_out"])},
          {"gap_at_r_out", zone.gap(in["r_out"])},
          {"stiffness", zone.stiffness()}};
}

std::vector<Output> hertz_sphere_inverse(const EntryInputs& in) {
  const auto zone = under_force(contact::Paraboloid::of_radius(in["R"]), in);
  return {
      {"a_K", zone.radius()}, {"delta", zone.approach()}, {"p0", zone.pressure(0)}, {"stiffness", zone.stiffness()}};
}

std::vector<Output> cone_inverse(const EntryInputs& in) {
  const auto zone = under_force(contact::Cone::of_slope(in["slope"]), in);
  return {{"a_K", zone.radius()},
          {"delta", zone.approach()},
          {"p_at_rho", zone.pressure(in["rho"] * zone.radius())},
          {"u_z_at_rho_out", zone.displacement(in["rho_out"] * zone.radius())},
          {"stiffness", zone.stiffness()}};
}

template <contact::Profile P>
std::vector<Output> flat_end(const P& profile, const EntryInputs& in) {
  const auto zone = at_radius(profile, in["a"], in);
  return {{"F_N", zone.force()},
          {"delta", zone.approach()},
          {"p_at_r", zone.pressure(in["r"])},
          {"stiffness", zone.stiffness()}};
}

std::vector<Output> flat_end_paraboloid(const EntryInputs& in) {
  return flat_end(contact::FlatEndParaboloid::of(in["b"], in["R"]), in);
}

std::vector<Output> flat_end_cone(const EntryInputs& in) {
  return flat_end(contact::FlatEndCone::of(in["b"], in["slope"]), in);
}

std::vector<Output> profile_points(const EntryInputs& in) {
  std::vector<contact::ProfilePoint> points{{0, 0}};
  const auto radii = in.series("r");
  for (std::size_t k = 0; k < radii.size(); ++k) points.push_back({radii[k], in[fmt::format("f_{}", k + 1)]});
  const auto zone = at_radius(contact::PointProfile::through(points), in["a"], in);
  return {{"F_N", zone.force()},
          {"delta", zone.approach()},
          {"p_at_r", zone.pressure(in["r"])},
          {"u_z_at_r_out", zone.displacement(in["r_out"])}};
}

std::vector<Output> axis_stress(const EntryInputs& in) {
  const auto stress = contact::HertzAxisStress::of(in["p0"], in["a"], in["nu"]);
  return {{"sigma_z", stress.axial(in["z"])},
          {"sigma_r", stress.radial(in["z"])},
          {"tau_max_at_z", stress.shear(in["z"])},
          {"z_of_max_tau", stress.depth_of_max_shear()},
          {"max_tau", stress.max_shear()}};
}

constexpr std::array<ContactKind, 18> kinds{{{"rot_sym_pressure_413", rotational_pressure},
                                             {"elliptic_pressure", elliptic_pressure},
                                             {"steuermann_414", steuermann},
                                             {"power_profile_sneddon", power_profile},
                                             {"power_profile_inverse", power_profile_inverse},
                                             {"sphere_exact_and_series", sphere},
                                             {"sphere_exact_inverse", sphere_inverse},
                                             {"sphere_exact_from_approach", sphere_from_approach},
                                             {"flat_punch", flat_punch},
                                             {"flat_punch_field", flat_punch_field},
                                             {"hertz_sphere", hertz_sphere},
                                             {"hertz_sphere_field", hertz_sphere_field},
                                             {"hertz_sphere_inverse", hertz_sphere_inverse},
                                             {"cone_inverse", cone_inverse},
                                             {"flat_end_paraboloid", flat_end_paraboloid},
                                             {"flat_end_cone", flat_end_cone},
                                             {"axisym_profile_points", profile_points},
                                             {"hertz_axis_stress", axis_stress}}};

}  // namespace

std::span<const ContactKind> round_kinds() { return kinds; }

}  // namespace patchgrip::cli
