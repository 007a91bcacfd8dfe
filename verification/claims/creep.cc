#include <patchgrip/verification/claims/creep.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <patchgrip/contact/creep/load_integral.h>
#include <patchgrip/contact/creep/press_under_force.h>
#include <patchgrip/contact/creep/seed_creep.h>
#include <patchgrip/contact/paraboloid.h>

namespace patchgrip::verification {
namespace {

using contact::ContactCreep;
using contact::History;

constexpr double relaxed_modulus = 100, fading_modulus = 300;  // E_2, E_1 [Pa]
constexpr double fading_share = fading_modulus / (relaxed_modulus + fading_modulus);
constexpr double fading_time = 1, end = 3;                               // [s]
constexpr double sphere_radius = 1000;                                   // R [m]
constexpr double peak_force = 4. / 3 * relaxed_modulus / sphere_radius;  // about a = 1 m when relaxed [N]
constexpr double poisson_ratio = 0.3;                                    // of the glassy body
constexpr double shear = (relaxed_modulus + fading_modulus) / (2 * (1 + poisson_ratio));     // G(0) [Pa]
constexpr double bulk = (relaxed_modulus + fading_modulus) / (3 * (1 - 2 * poisson_ratio));  // K [Pa]

ContactCreep even_creep() {  // every modulus fades alike
  return ContactCreep::against_rigid(contact::ViscoelasticMaterial::of(
      contact::RelaxationModulus::of(relaxed_modulus, {{fading_modulus, fading_time}}), poisson_ratio));
}

// Compliance of a modulus of which a part fades.
contact::CreepCompliance compliance_of(double constant, double fading) {
  const double glassy = constant + fading, relaxed = glassy - fading_share * fading;
  return contact::CreepCompliance::of(1 / glassy, {{1 / relaxed - 1 / glassy, fading_time * glassy / relaxed}});
}

// 1 / E* = (3 K + 4 G) / (4 G (3 K + G)) = (1 / G + 3 / (3 K + G)) / 4, of the transforms.
ContactCreep shear_creep() {
  const auto of_shear = compliance_of(0, shear), of_both = compliance_of(3 * bulk, shear);
  const auto [strength, time] = of_shear.modes().front();
  const auto [strength_of_both, time_of_both] = of_both.modes().front();
  return ContactCreep::against_rigid(contact::ViscoelasticMaterial::of(
      contact::CreepCompliance::of((of_shear.instantaneous() + 3 * of_both.instantaneous()) / 4,
                                   {{strength / 4, time}, {0.75 * strength_of_both, time_of_both}}),
      0));  // (1 - nu^2) J = C
}

CreepingPress press(History force, std::vector<double> times, double tolerance, std::string reason,
                    bool bulk_fades = true) {
  const ContactCreep creep = bulk_fades ? even_creep() : shear_creep();
  const auto profile = contact::Paraboloid::of_radius(sphere_radius);
  const auto pressed = contact::PressUnderForce<contact::Paraboloid>::of(profile, creep, force, end);
  std::vector<double> library, seed;
  double scale = 0;
  for (const double t : times) {
    library.push_back(pressed.approach(t).value);
    seed.push_back(contact::seed_creep_approach(profile, creep, force, t).value);
    scale = std::max(scale, library.back());
  }
  return {contact::Material::elastic(relaxed_modulus + fading_modulus, poisson_ratio),
          fading_share,
          bulk_fades,
          fading_time,
          sphere_radius,
          std::move(force),
          end,
          std::move(times),
          {{"approach", "m", library, scale, tolerance, std::move(reason)},
           {"approach of seed 4.72", "m", seed, scale, 0, "linear in F^(2/3), where contact is linear in F",
            Claim::differs}}};
}

std::vector<double> graded_times() {  // closer to each other at the start, where the approach changes fastest
  std::vector<double> times;
  for (int k = 1; k <= 6; ++k) times.push_back(end * std::pow(k / 6., 1.5));
  return times;
}

const std::string growing_reason = "0.3 % over the history: the step in time and the edge of the contact, both O(h^2)";

}  // namespace

FarField far_field(const CreepingPress& press, double t) {
  const auto of_both = press.bulk_fades ? compliance_of(0, 3 * bulk + shear) : compliance_of(3 * bulk, shear);
  const double in_shear = contact::load_integral(compliance_of(0, shear), press.force, t);
  const double in_both = contact::load_integral(of_both, press.force, t);
  const double nu = in_shear > 0 ? (1 - 3 * in_both / in_shear) / 2 : poisson_ratio;
  return {shear * in_shear, contact::Material::elastic(2 * shear * (1 + nu), nu)};
}

CreepingPress held() { return press(History::step(peak_force), graded_times(), 3e-3, growing_reason); }

CreepingPress shear_held() { return press(History::step(peak_force), graded_times(), 3e-3, growing_reason, false); }

CreepingPress shear_held_by_calculix() {
  return press(History::step(peak_force), graded_times(), 5e-3,
               "0.5 % over the history: CalculiX takes first-order steps in time, n^2 / 4 of them between two times",
               false);
}

CreepingPress ramped() { return press(History::ramp(peak_force / end), graded_times(), 3e-3, growing_reason); }

CreepingPress released() {
  return press(History::triangle(peak_force / (end / 2), end / 2), {0.5, 1, 1.5, 2, 2.5, 2.75}, 3e-3,
               "0.3 % of the deepest; the contact shrinks from a little after the peak on");
}

}  // namespace patchgrip::verification
