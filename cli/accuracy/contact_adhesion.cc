// Kinds about adhesion and about soft fingertips.
#include <array>

#include <patchgrip/cli/accuracy/contact_kinds.h>
#include <patchgrip/contact/adhesion/dmt.h>
#include <patchgrip/contact/adhesion/jkr.h>
#include <patchgrip/contact/adhesion/maugis_dugdale.h>
#include <patchgrip/contact/adhesion/tabor.h>
#include <patchgrip/contact/fingertip/power_law.h>
#include <patchgrip/contact/fingertip/winkler.h>
#include <patchgrip/contact/fingertip/xydas_kao.h>

namespace patchgrip::cli {
namespace {

using contact::AdhesiveSphere;

AdhesiveSphere sphere(const EntryInputs& in) { return AdhesiveSphere::of(in["R"], in["E_star"], in["w"]); }

std::vector<Output> jkr(const EntryInputs& in) {
  const contact::Jkr model(AdhesiveSphere::of(in["R"], in["E_star"], 2 * in["gamma"]));
  const auto at = model.at_radius(in["a"]), loaded = model.under_force(in["F"]);
  const auto pull_off = model.load_pull_off(), no_load = model.no_load();
  return {{"F_N_of_a", at.normal_force},
          {"delta_of_a", at.approach},
          {"p_at_r", model.pressure(in["a"], in["r"])},
          {"F_pulloff", pull_off.normal_force},
          {"a_zero_load", no_load.contact_radius},
          {"delta_zero_load", no_load.approach},
          {"a_pulloff", pull_off.contact_radius},
          {"delta_pulloff", pull_off.approach},
          {"a_of_F", loaded.contact_radius},
          {"delta_of_F", loaded.approach}};
}

std::vector<Output> jkr_branches(const EntryInputs& in) {
  const contact::Jkr model(sphere(in));
  const auto stable = model.under_force(in["F"]), unstable = model.unstable_under_force(in["F"]);
  const auto torn = model.displacement_pull_off();
  return {{"a_stable", stable.contact_radius},    {"delta_stable", stable.approach},
          {"stiffness_stable", stable.stiffness}, {"a_unstable", unstable.contact_radius},
          {"delta_unstable", unstable.approach},  {"F_pulloff_load", model.load_pull_off().normal_force},
          {"F_pulloff_disp", torn.normal_force},  {"a_pulloff_disp", torn.contact_radius},
          {"delta_pulloff_disp", torn.approach}};
}

std::vector<Output> jkr_load(const EntryInputs& in) {
  const auto at = contact::Jkr(sphere(in)).under_force(in["F"]);
  return {{"a_K", at.contact_radius}, {"delta", at.approach}};
}

std::vector<Output> dmt(const EntryInputs& in) {
  const contact::Dmt model(sphere(in));
  const auto at = model.under_force(in["F"]);
  return {{"a_K", at.contact_radius},
          {"delta", at.approach},
          {"F_pulloff", model.pull_off().normal_force},
          {"a_zero_load", model.no_load().contact_radius}};
}

std::vector<Output> maugis_dugdale(const EntryInputs& in) {
  const auto model = contact::MaugisDugdale::of(sphere(in), in["sigma0"]);
  const auto at = model.at_radius(in["a"]);
  return {{"lam", model.maugis_parameter()},
          {"c_over_a", at.outer_radius / at.contact_radius},
          {"c_minus_a", at.ring_width},
          {"F_N", at.normal_force},
          {"delta", at.approach}};
}

std::vector<Output> maugis_pulloff(const EntryInputs& in) {
  const auto point = contact::MaugisCurve<long double>{in["lam"]}.pull_off();
  return {{"Fbar_pulloff", static_cast<double>(-point.force)},
          {"Abar_pulloff", static_cast<double>(point.A)},
          {"m_pulloff", static_cast<double>(1 + point.n)}};
}

std::vector<Output> tabor(const EntryInputs& in) {
  const double attraction = contact::lennard_jones_attraction(in["w"], in["z0"]);
  const double parameter = contact::tabor_parameter(sphere(in), in["z0"]);
  const double lambda = contact::maugis_parameter(sphere(in), attraction);
  return {{"mu_T", parameter},
          {"sigma0_LJ", attraction},
          {"lam", lambda},
          {"lam_over_mu", lambda / parameter},
          {"sigma0_dugdale_z0", contact::dugdale_attraction(in["w"], in["z0"])}};
}

std::vector<Output> power_law_fit(const EntryInputs& in) {
  const auto forces = in.series("F"), radii = in.series("a");
  std::vector<contact::MeasuredRadius> points;
  for (std::size_t i = 0; i < forces.size() && i < radii.size(); ++i) points.push_back({forces[i], radii[i]});
  const auto fit = contact::PowerLawFit::to(points);
  return {{"c", fit.law.c}, {"gamma", fit.law.gamma}, {"rms_log", fit.rms_log}};
}

std::vector<Output> xydas_kao_468(const EntryInputs& in) {
  const auto pressure = contact::XydasKaoPressure::of(in["F_N"], in["a_K"], in["alpha"]);
  return {{"p0", pressure.peak_pressure}, {"p_at_r", pressure.pressure(in["r"])}};
}

std::vector<Output> winkler_theta0_0(const EntryInputs& in) {
  const auto tip = contact::WinklerFingertip::of(in["R"], in["c"]);
  return {{"a_K", tip.contact_radius(in["delta"])},
          {"F_N", tip.normal_force(in["delta"])},
          {"p0", tip.peak_pressure(in["delta"])}};
}

constexpr std::array<ContactKind, 10> kinds{{
    {"jkr", jkr},
    {"jkr_branches", jkr_branches},
    {"jkr_load", jkr_load},
    {"dmt", dmt},
    {"maugis_dugdale", maugis_dugdale},
    {"maugis_pulloff", maugis_pulloff},
    {"tabor", tabor},
    {"power_law_fit", power_law_fit},
    {"xydas_kao_468", xydas_kao_468},
    {"winkler_theta0_0", winkler_theta0_0},
}};

}  // namespace

std::span<const ContactKind> adhesion_kinds() { return kinds; }

}  // namespace patchgrip::cli
