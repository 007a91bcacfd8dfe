#include <patchgrip/grasp/grasp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <patchgrip/contact/require.h>

namespace patchgrip::grasp {
namespace {

// The largest share of the bound that a charge of first order may be.
constexpr double largest_charge = 1e-3;

double power_of_two_near(double x) { return x > 0 ? std::exp2(std::round(std::log2(x))) : 1; }

}  // namespace

Grasp::Grasp(std::vector<Contact> contacts, const GripSettings& settings)
    : contacts_(std::move(contacts)), settings_(settings), limits_(contacts_.size(), 1) {
  settings_.check();
  scaled_ = std::make_unique<const ScaledGrasp>(contacts_);
  solver_ = std::make_unique<GripSolver>(*scaled_, settings_);
  answer_.contacts.resize(contacts_.size());
}

Vector6 Grasp::scaled(const char* name, const Vector6& load) const {
  for (const double x : load) contact::require_finite(name, x);
  return scaled_->scaled_load(load);
}

void Grasp::set_limits(std::span<const double> limits, double scale) {
  if (limits.size() != contacts_.size())
    contact::refuse("number of limits", static_cast<double>(limits.size()), "must be that of the contacts");
  for (std::size_t i = 0; i < limits.size(); ++i) limits_[i] = contact::require_positive("limit", limits[i]) / scale;
}

const GripAnswer& Grasp::least_grip(const Vector6& load) {
  std::ranges::fill(limits_, 1);
  ask({scaled_.get(), Objective::max_force, scaled("load", load)}, settings_.force_limit, false);
  return answer_;
}

const GripAnswer& Grasp::next_least_grip(const Vector6& load) {
  std::ranges::fill(limits_, 1);
  ask({scaled_.get(), Objective::max_force, scaled("load", load)}, settings_.force_limit, true);
  return answer_;
}

const GripAnswer& Grasp::least_total_grip(const Vector6& load) {
  ask({scaled_.get(), Objective::total_force, scaled("load", load)}, settings_.force_limit, false);
  return answer_;
}

const GripAnswer& Grasp::holds_within(const Vector6& load, std::span<const double> limits) {
  const Vector6 w = scaled("load", load);
  if (limits.empty()) throw std::invalid_argument("limits = none is not allowed: one for each contact is expected");
  const double largest = *std::ranges::max_element(limits);
  set_limits(limits, largest);
  const double size = power_of_two_near(w.norm());
  GripProblem problem{scaled_.get(), Objective::max_force, w / size, Vector6::Zero(), limits_};
  solver_->solve(problem, false);
  report(problem, size, 1 / largest, 1);
  return answer_;
}

const GripAnswer& Grasp::load_factor(const Vector6& load, const Vector6& step, std::span<const double> limits) {
  const Vector6 w = scaled("load", load);
  const Vector6 w1 = scaled("step", step);
  contact::require_positive("size of the step", w1.norm());
  const double size = power_of_two_near(w1.norm());
  set_limits(limits, size);
  GripProblem problem{scaled_.get(), Objective::load_factor, w / size, w1 / size, limits_};
  solver_->solve(problem, false);
  report(problem, size, 1 / size, 0);
  return answer_;
}

const GripAnswer& Grasp::force_closure() {
  Vector6 load = Vector6::Zero();
  for (const ScaledGrasp::Part& part : scaled_->parts()) load += part.element.N();
  std::ranges::fill(limits_, 1);
  // Where the normals balance by themselves unit forces are the proof.
  ask({scaled_.get(), Objective::max_force, load}, settings_.force_limit, false);
  if (scaled_->rank() < 6) {
    answer_.verdict = Verdict::cannot_hold;
    Eigen::Index axis;
    scaled_->unresisted().diagonal().maxCoeff(&axis);
    answer_.escape_twist = scaled_->twist(scaled_->unresisted().col(axis));
  }
  return answer_;
}

void Grasp::ask(GripProblem problem, double limit, bool warm) {
  const double size = power_of_two_near(problem.load.norm());
  problem.load /= size;
  problem.limits = limits_;
  solver_->solve(problem, warm);
  report(problem, size, 1, limit * size);
}

// The load of the problem is 1 / size of that of the question, its twist 1 / pace; `limit` is in the units of the value.
void Grasp::report(const GripProblem& problem, double size, double pace, double limit) {
  const Bracket& bracket = solver_->bracket();
  const bool factor = problem.objective == Objective::load_factor;
  const double value_scale = size * pace;
  answer_.lower = value_scale * bracket.lower();
  answer_.upper = value_scale * bracket.upper();
  answer_.charged = bracket.charged();
  answer_.balance_residual = bracket.residual();
  answer_.effort = solver_->effort();
  if (factor) {
    answer_.verdict = std::isfinite(answer_.lower) ? Verdict::holds : Verdict::undecided;
    answer_.value = std::isfinite(answer_.lower) ? answer_.lower : answer_.upper;
  } else {
    const bool found = answer_.upper <= limit && answer_.charged <= largest_charge;
    answer_.verdict = found ? Verdict::holds : answer_.lower > limit ? Verdict::cannot_hold : Verdict::undecided;
    answer_.value = std::isfinite(answer_.upper) ? (answer_.lower + answer_.upper) / 2 : answer_.lower;
  }
  const Vector6& W = bracket.twist();
  answer_.escape_twist = pace * scaled_->twist(W);
  std::ranges::fill(answer_.contacts, ContactAnswer{});
  for (std::size_t i = 0; i < scaled_->parts().size(); ++i) {
    const ScaledGrasp::Part& part = scaled_->parts()[i];
    const PartForce& x = bracket.forces()[i];
    ContactAnswer& a = answer_.contacts[part.contact];
    a.normal_force += size * x.force;
    a.friction += size * Vector3(x.friction[0], x.friction[1], scaled_->length() * x.friction[2]);
    if (x.force > 0) a.state = std::max(a.state, x.on_surface ? ContactState::slips : ContactState::sticks);
    a.at_limit = solver_->polish().is_capped(part.contact);
    const double rho = pace * part.element.resistance(W, 0).value;
    a.resistance = i > 0 && scaled_->parts()[i - 1].contact == part.contact ? std::max(a.resistance, rho) : rho;
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    answer_.contacts[i].sliding = contacts_[i].sliding(answer_.escape_twist);
  }
}

}  // namespace patchgrip::grasp
