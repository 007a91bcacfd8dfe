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

constexpr double relaxed_modulus = 100, fading_modulus = 300;            // E_2, E_1 [Pa]
constexpr double fading_time = 1, end = 3;                               // [s]
constexpr double sphere_radius = 1000;                                   // R [m]
constexpr double peak_force = 4. / 3 * relaxed_modulus / sphere_radius;  // about a = 1 m when relaxed [N]
constexpr double poisson_ratio = 0.3;

ContactCreep creep() {
  return ContactCreep::against_rigid(contact::ViscoelasticMaterial::of(
      contact::RelaxationModulus::of(relaxed_modulus, {{fading_modulus, fading_time}}), poisson_ratio));
}

CreepingPress press(History force, std::vector<double> times, double tolerance, std::string reason) {
  const auto profile = contact::Paraboloid::of_radius(sphere_radius);
  const auto pressed = contact::PressUnderForce<contact::Paraboloid>::of(profile, creep(), force, end);
  std::vector<double> library, seed;
  double scale = 0;
  for (const double t : times) {
    library.push_back(pressed.approach(t).value);
    seed.push_back(contact::seed_creep_approach(profile, creep(), force, t).value);
    scale = std::max(scale, library.back());
  }
  return {contact::Material::elastic(relaxed_modulus + fading_modulus, poisson_ratio),
          fading_modulus / (relaxed_modulus + fading_modulus),
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

double elastic_force(const CreepingPress& press, double t) {
  return creep().modulus.instantaneous() * contact::load_integral(creep().compliance, press.force, t);
}

CreepingPress held() { return press(History::step(peak_force), graded_times(), 3e-3, growing_reason); }

CreepingPress ramped() { return press(History::ramp(peak_force / end), graded_times(), 3e-3, growing_reason); }

CreepingPress released() {
  return press(History::triangle(peak_force / (end / 2), end / 2), {0.5, 1, 1.5, 2, 2.5, 2.75}, 3e-3,
               "0.3 % of the deepest; the contact shrinks from a little after the peak on");
}

}  // namespace patchgrip::verification
