// One spring of the viscoelastic foundation that stands for a round contact, exact for a stamp that moves linearly.
//
//     touching   u = d(t) = delta(t) - g(x),   q = M_inf u + sum q_i,   q_i' = -q_i / tau_i + M_i u'
//     free       q = 0,   u = u_rest + sum U_j exp(-t / lambda_j),   U_j = -lambda_j C_j sum_i q_i/(lambda_j - tau_i),
//                q_i = -M_i tau_i sum_j U_j / (lambda_j - tau_i)
//
// It lets go when q would become negative and is met again when d reaches u. Under a given strain the modes tau_i live
// on their own, under no stress the modes lambda_j: both ways in closed form, and the times of change are roots.
// A jump of d is met at once, with M_0.
//
// Why springs: the Abel transform that turns a round contact into one dimension acts on the radius alone, so time may
// do what it likes (Popov and Hess 2015; formula of g in axisymmetric.h).
//
// Domain   M without a bare dashpot.
// Units    d, u [m], q [Pa m], t [s].
// Error    a few units of rounding (2^-53) of M_0 |u| a step; times of change to the last digit;
//          tests/contact/cycles_test.cc.
// Fails    where q neither falls nor rises all through a step, its least values are looked for between 28 times of the
//          step: of two dips between neighbours one may not be seen. A spring that has changed k times in a step stays
//          as it is for 2^(k-60) of the rest at least.
// Throws   std::runtime_error where a spring changes more than 64 times in a step.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/contact/creep/contact_creep.h>

namespace patchgrip::contact {

struct Spring {
  double depth = 0;  // u [m]: of the surface
  bool is_touching = false;
  bool was_touched = false;
  int changes = 0;  // of is_touching, so far
};

class SpringLaw {
 public:
  // Throws std::invalid_argument for a bare dashpot.
  explicit SpringLaw(ContactCreep creep);

  const ContactCreep& creep() const noexcept { return creep_; }
  std::size_t modes() const noexcept { return creep_.modulus.modes().size(); }  // numbers q_i beside each spring

  double stress(const Spring& spring, std::span<const double> relaxing) const;  // q

  // The stamp goes from depth d to d + rate duration.
  void advance(Spring& spring, std::span<double> relaxing, double d, double rate, double duration) const;
  // The stamp jumps to depth d.
  void jump(Spring& spring, std::span<double> relaxing, double d) const;

 private:
  void press(Spring& spring, std::span<double> relaxing, double rate, double duration) const;
  void recover(Spring& spring, std::span<double> relaxing, double duration) const;
  double lets_go(const Spring& spring, std::span<const double> relaxing, double rate, double duration,
                 bool starts_free) const;
  double is_met(const Spring& spring, std::span<const double> relaxing, double d, double rate, double duration) const;
  double creeping(std::span<const double> relaxing, std::size_t j) const;  // U_j

  ContactCreep creep_;
  double instantaneous_;                  // M_0
  std::vector<double> relaxation_rates_;  // 1 / tau_i
  std::vector<double> creep_rates_;       // 1 / lambda_j
};

}  // namespace patchgrip::contact
