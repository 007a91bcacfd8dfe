// Kinds about viscoelastic contact.
#include <fmt/format.h>

#include <array>
#include <string>

#include <patchgrip/cli/accuracy/contact_kinds.h>
#include <patchgrip/contact/creep/cycles.h>
#include <patchgrip/contact/creep/growing_ellipse.h>
#include <patchgrip/contact/creep/press_at_approach.h>
#include <patchgrip/contact/creep/press_under_force.h>
#include <patchgrip/contact/creep/rabotnov.h>
#include <patchgrip/contact/creep/seed_creep.h>
#include <patchgrip/contact/creep/standard_models.h>
#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/power_profile.h>

namespace patchgrip::cli {
namespace {

using contact::ContactCreep;
using contact::History;
using contact::Modes;
using contact::Paraboloid;
using contact::PressAtApproach;
using contact::PressUnderForce;
using contact::RelaxationModulus;
using contact::ViscoelasticMaterial;
using Outputs = std::vector<Output>;

Modes<double> modes_of(const EntryInputs& in, std::string_view strength, std::string_view time) {
  const auto strengths = in.series(strength);
  const auto times = in.series(time);
  Modes<double> modes;
  for (std::size_t i = 0; i < strengths.size() && i < times.size(); ++i) modes.push_back({strengths[i], times[i]});
  return modes;
}

RelaxationModulus prony_of(const EntryInputs& in) {
  return RelaxationModulus::of(in.has("E_inf") ? in["E_inf"] : 0, modes_of(in, "E", "tau"));
}

ContactCreep against_rigid(RelaxationModulus modulus, const EntryInputs& in) {
  return ContactCreep::against_rigid(ViscoelasticMaterial::of(std::move(modulus), in["nu"]));
}

ContactCreep poynting_thomson_contact(const EntryInputs& in) {
  return against_rigid(contact::PoyntingThomson::of(in["E1"], in["E2"], in["eta"]).modulus(), in);
}

Paraboloid stamp(const EntryInputs& in) { return Paraboloid::of_radius(in["R"]); }

// To t and a little beyond: a press ends after its start.
template <class P>
PressUnderForce<P> pressed(P profile, ContactCreep creep, History force, double t) {
  return PressUnderForce<P>::of(std::move(profile), std::move(creep), std::move(force), t + 1);
}

void add_modes(Outputs& outputs, const Modes<double>& modes, std::string_view strength, std::string_view time) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    outputs.push_back({fmt::format("{}_{}", strength, i + 1), modes[i].strength});
    outputs.push_back({fmt::format("{}_{}", time, i + 1), modes[i].time});
  }
}

Outputs poynting_thomson(const EntryInputs& in) {
  const auto solid = contact::PoyntingThomson::of(in["E1"], in["E2"], in["eta"]);
  const double t = in["t"];
  const auto creep = against_rigid(solid.modulus(), in);
  const auto elastic = stamp(in);
  return {{"K_E", solid.creep(t)},
          {"K_E_0", solid.creep(0)},
          {"K_E_inf", creep_compliance(solid.modulus()).equilibrium()},
          {"k_E", solid.creep_rate(t)},
          {"alpha", solid.retardation_rate()},
          {"C", elastic.approach(elastic.radius_of_force(creep.compliance(0)))},
          {"E_relax", solid.modulus()(t)}};
}

Outputs visco_step(const EntryInputs& in) {
  const auto creep = poynting_thomson_contact(in);
  const auto force = History::step(in["F0"]);
  const double t = in["t"];
  const auto press = pressed(stamp(in), creep, force, t);
  const double delta = press.approach(t).value;
  const double seed = seed_creep_approach(stamp(in), creep, force, t).value;
  return {{"delta_exact_LR", delta},
          {"a_exact_LR", press.radius(t)},
          {"p_centre_exact_LR", press.pressure(0, t).value},
          {"delta_thesis_428", seed},
          {"ratio_thesis_over_LR", seed / delta}};
}

Outputs visco_ramp(const EntryInputs& in) {
  const auto creep = poynting_thomson_contact(in);
  const auto force = History::ramp(in["rate"]);
  const double t = in["t"];
  const auto press = pressed(stamp(in), creep, force, t);
  const double delta = press.approach(t).value;
  const double seed = seed_creep_approach(stamp(in), creep, force, t).value;
  return {{"delta_exact_LR", delta},
          {"a_exact_LR", press.radius(t)},
          {"delta_thesis_428", seed},
          {"ratio_thesis_over_LR", seed / delta}};
}

Outputs visco_halfsine(const EntryInputs& in) {
  const auto creep = poynting_thomson_contact(in);
  const auto force = History::half_sine(in["F0"], in["omega"]);
  const double t = in["t"];
  const auto press = pressed(stamp(in), creep, force, t);
  const double delta = press.approach(t).value;
  const double seed = seed_creep_approach(stamp(in), creep, force, t).value;
  const auto elastic = stamp(in);
  return {{"t_max_radius", press.grows_until()},
          {"delta_exact_Ting", delta},
          {"a_exact_Ting", press.radius(t)},
          {"delta_LR_formula", elastic.approach(elastic.radius_of_force(load_integral(creep.compliance, force, t)))},
          {"delta_thesis_428", seed},
          {"ratio_thesis_over_exact", seed / delta}};
}

Outputs visco_sine(const EntryInputs& in) {
  const auto creep = poynting_thomson_contact(in);
  const auto force = History::sine(in["F0"], in["m"], in["omega"]);
  const double t = in["t"];
  const auto press = pressed(stamp(in), creep, force, t);
  const bool is_monotone = press.grows_until() >= t;
  Outputs outputs{{"delta_thesis_428", seed_creep_approach(stamp(in), creep, force, t).value},
                  {"radius_monotone_up_to_t", is_monotone ? 1. : 0.}};
  if (is_monotone) outputs.push_back({"delta_exact_LR", press.approach(t).value});
  return outputs;
}

Outputs visco_step_power_profile(const EntryInputs& in) {
  (void)in.has("R");  // stated, but f = A r^d has no radius
  const auto creep = poynting_thomson_contact(in);
  const auto force = History::step(in["F0"]);
  const auto profile = contact::PowerProfile::of_coefficient(in["A"], in["d"]);
  const double t = in["t"];
  const auto press = pressed(profile, creep, force, t);
  return {{"a_exact_LR", press.radius(t)},
          {"delta_exact_LR", press.approach(t).value},
          {"delta_thesis_428", seed_creep_approach(profile, creep, force, t).value}};
}

Outputs rabotnov_elastic_ex43(const EntryInputs& in) {
  const auto model = contact::RabotnovModel::of(in["mu"], in["d"], in["w1"], in["F1"], in["c"], in["E"]);
  const double delta = in["delta"];
  return {{"C", model.compliance}, {"F_N", model.force(delta)}, {"a_K", model.radius(delta)}, {"gamma", model.gamma}};
}

Outputs prony_conversion(const EntryInputs& in) {
  const auto modulus = prony_of(in);
  const auto compliance = creep_compliance(modulus);
  const double t = in["t"];
  Outputs outputs{{"J_0", compliance.instantaneous()},
                  {"J_inf", compliance.equilibrium()},
                  {"J_at_t", compliance(t)},
                  {"E_at_t", modulus(t)}};
  add_modes(outputs, compliance.modes(), "J", "lambda");
  return outputs;
}

Outputs prony_conversion_fluid(const EntryInputs& in) {
  Outputs outputs = prony_conversion(in);
  const auto compliance = creep_compliance(prony_of(in));
  outputs.push_back({"viscosity", 1 / compliance.fluidity()});
  outputs.push_back({"J_e0", compliance.equilibrium()});
  return outputs;
}

Outputs prony_creep_to_relax(const EntryInputs& in) {
  const auto modulus = relaxation_modulus(contact::CreepCompliance::of(in["J_0"], modes_of(in, "J", "lam")));
  Outputs outputs{{"E_inf", modulus.equilibrium()}, {"E_at_t", modulus(in["t"])}};
  add_modes(outputs, modulus.modes(), "E", "tau");
  return outputs;
}

Outputs prony_piecewise_load(const EntryInputs& in) {
  const auto modulus = prony_of(in);
  std::vector<contact::HistoryPoint<double>> points{{0, in["F_0"]}};
  const auto times = in.series("t");
  const auto forces = in.series("F");
  for (std::size_t k = 0; k < times.size(); ++k) points.push_back({times[k], forces[k]});
  const auto force = History::points(points);
  const double t = in["t"];
  const auto press = pressed(stamp(in), against_rigid(modulus, in), force, t);
  return {{"int_J_dF", load_integral(creep_compliance(modulus), force, t)},
          {"a_K", press.radius(t)},
          {"delta", press.approach(t).value}};
}

Outputs prony_approach_ramp_hold(const EntryInputs& in) {
  const double until = in["t_1"], t = in["t"];
  const auto approach = History::points({{0, 0}, {until, in["v"] * until}});
  const auto press = PressAtApproach<Paraboloid>::of(stamp(in), against_rigid(prony_of(in), in), approach, t + 1);
  return {{"F_N", press.force(t).value}, {"a_K", press.radius(t)}};
}

Outputs ting_approach_triangle(const EntryInputs& in) {
  const auto approach = History::triangle(in["v"], in["t_m"]);
  const double t = in["t"];
  const auto press =
      PressAtApproach<Paraboloid>::of(stamp(in), against_rigid(prony_of(in), in), approach, 2 * in["t_m"]);
  return {{"t1", press.earlier_time(t)},
          {"a_K", press.radius(t)},
          {"F_N", press.force(t).value},
          {"delta", approach(t)},
          {"t_contact_lost", press.contact_lost()}};
}

Outputs ting_force_triangle(const EntryInputs& in) {
  const double t = in["t"];
  const auto press = pressed(stamp(in), against_rigid(prony_of(in), in), History::triangle(in["rate"], in["t_p"]), t);
  return {{"t_max_radius", press.grows_until()},
          {"a_max", press.radius(press.grows_until())},
          {"t1", press.earlier_time(t)},
          {"a_K", press.radius(t)},
          {"delta", press.approach(t).value}};
}

Outputs step_of(const EntryInputs& in, const RelaxationModulus& modulus) {
  const double t = in["t"];
  const auto press = pressed(stamp(in), against_rigid(modulus, in), History::step(in["F0"]), t);
  return {{"J_at_t", creep_compliance(modulus)(t)}, {"delta", press.approach(t).value}, {"a_K", press.radius(t)}};
}

Outputs kelvin_voigt_step(const EntryInputs& in) { return step_of(in, contact::kelvin_voigt(in["E_2"], in["eta"])); }

Outputs maxwell_step(const EntryInputs& in) { return step_of(in, contact::maxwell(in["E_1"], in["eta"])); }

Outputs visco_two_bodies_step(const EntryInputs& in) {
  const auto upper =
      ViscoelasticMaterial::of(contact::PoyntingThomson::of(in["E1_p"], in["E2_p"], in["eta_p"]).modulus(), in["nu_p"]);
  const auto lower =
      ViscoelasticMaterial::of(contact::PoyntingThomson::of(in["E1_m"], in["E2_m"], in["eta_m"]).modulus(), in["nu_m"]);
  const auto creep = ContactCreep::between(upper, lower);
  const double t = in["t"];
  const auto press = pressed(stamp(in), creep, History::step(in["F0"]), t);
  return {{"delta", press.approach(t).value},
          {"a_K", press.radius(t)},
          {"E_star_0", creep.secant_modulus(0)},
          {"E_star_eff", creep.secant_modulus(t)}};
}

Outputs visco_two_cycles(const EntryInputs& in) {
  const auto modulus = RelaxationModulus::of(in["E_inf"], modes_of(in, "E", "tau"));
  const auto approach =
      History::points({{0, 0}, {in["t_1"], in["d_1"]}, {in["t_2"], in["d_2"]}, {in["t_3"], in["d_3"]}});
  const auto cycles = contact::Cycles<Paraboloid>::of(stamp(in), against_rigid(modulus, in), approach);
  const double t = in["t"];
  const auto zone = cycles.zone(t);
  return {{"a_min", cycles.radius(in["t_2"])}, {"a_K", zone.radius}, {"F_N", zone.force.value}, {"delta", approach(t)}};
}

Outputs visco_ellipse_step(const EntryInputs& in) {
  const double large = in["R_large"];
  const auto radii = contact::RelativeRadii::of(in["ratio"] * large, large);
  const auto ellipse =
      contact::GrowingEllipse::under_force(radii, poynting_thomson_contact(in), History::step(in["F0"]), in["t"]);
  return {{"a", ellipse.a}, {"b", ellipse.b}, {"delta", ellipse.approach}};
}

constexpr std::array kinds{
    ContactKind{"poynting_thomson", poynting_thomson},
    ContactKind{"visco_step", visco_step},
    ContactKind{"visco_ramp", visco_ramp},
    ContactKind{"visco_halfsine", visco_halfsine},
    ContactKind{"visco_sine", visco_sine},
    ContactKind{"visco_step_power_profile", visco_step_power_profile},
    ContactKind{"rabotnov_elastic_ex43", rabotnov_elastic_ex43},
    ContactKind{"prony_conversion", prony_conversion},
    ContactKind{"prony_conversion_fluid", prony_conversion_fluid},
    ContactKind{"prony_creep_to_relax", prony_creep_to_relax},
    ContactKind{"prony_piecewise_load", prony_piecewise_load},
    ContactKind{"prony_approach_ramp_hold", prony_approach_ramp_hold},
    ContactKind{"ting_approach_triangle", ting_approach_triangle},
    ContactKind{"ting_force_triangle", ting_force_triangle},
    ContactKind{"kelvin_voigt_step", kelvin_voigt_step},
    ContactKind{"maxwell_step", maxwell_step},
    ContactKind{"visco_two_bodies_step", visco_two_bodies_step},
    ContactKind{"visco_two_cycles", visco_two_cycles},
    ContactKind{"visco_ellipse_step", visco_ellipse_step},
};

}  // namespace

std::span<const ContactKind> creep_kinds() { return kinds; }

}  // namespace patchgrip::cli
