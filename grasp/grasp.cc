#include <patchgrip/grasp/grasp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <patchgrip/contact/require.h>

namespace patchgrip::grasp {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double power_of_two_near(double x) { return x > 0 ? std::exp2(std::round(std::log2(x))) : 1; }

}  // namespace

Grasp::Grasp(std::vector<Contact> contacts, const GripSettings& settings)
    : contacts_(std::move(contacts)), settings_(settings), limits_(contacts_.size(), 1) {
  settings_.check();
  own_ = std::make_unique<Workspace>(contacts_, settings_, std::nullopt);
  answer_.contacts.resize(contacts_.size());
}

Vector6 Grasp::scaled(const char* name, const Vector6& load) const {
  for (const double x : load) contact::require_finite(name, x);
  return own_->scaled.scaled_load(load);
}

void Grasp::set_limits(std::span<const double> limits, double scale) {
  if (limits.size() != contacts_.size())
    contact::refuse("number of limits", static_cast<double>(limits.size()), "must be that of the contacts");
  for (std::size_t i = 0; i < limits.size(); ++i) limits_[i] = contact::require_positive("limit", limits[i]) / scale;
}

const GripAnswer& Grasp::least_grip(const Vector6& load) {
  std::ranges::fill(limits_, 1);
  ask({&own_->scaled, Objective::max_force, scaled("load", load)}, settings_.force_limit, false);
  return answer_;
}

const GripAnswer& Grasp::next_least_grip(const Vector6& load) {
  std::ranges::fill(limits_, 1);
  ask({&own_->scaled, Objective::max_force, scaled("load", load)}, settings_.force_limit, true);
  return answer_;
}

const GripAnswer& Grasp::least_total_grip(const Vector6& load) {
  ask({&own_->scaled, Objective::total_force, scaled("load", load)}, settings_.force_limit, false);
  return answer_;
}

const GripAnswer& Grasp::holds_within(const Vector6& load, std::span<const double> limits) {
  const Vector6 w = scaled("load", load);
  if (limits.empty()) throw std::invalid_argument("limits = none is not allowed: one for each contact is expected");
  const double largest = *std::ranges::max_element(limits);
  set_limits(limits, largest);
  const double size = power_of_two_near(w.norm());
  GripProblem problem{&own_->scaled, Objective::max_force, w / size, Vector6::Zero(), limits_};
  own_->solver.solve(problem, false);
  report(*own_, problem, size, 1 / largest, 1);
  return answer_;
}

const GripAnswer& Grasp::load_factor(const Vector6& load, const Vector6& step, std::span<const double> limits) {
  const Vector6 w = scaled("load", load);
  const Vector6 w1 = scaled("step", step);
  contact::require_positive("size of the step", w1.norm());
  const double size = power_of_two_near(w1.norm());
  set_limits(limits, size);
  GripProblem problem{&own_->scaled, Objective::load_factor, w / size, w1 / size, limits_};
  own_->solver.solve(problem, false);
  report(*own_, problem, size, 1 / size, 0);
  return answer_;
}

const GripAnswer& Grasp::force_closure() {
  Vector6 load = Vector6::Zero();
  for (const ScaledGrasp::Part& part : own_->scaled.parts()) load += part.element.N();
  std::ranges::fill(limits_, 1);
  // Where the normals balance by themselves unit forces are the proof.
  ask({&own_->scaled, Objective::max_force, load}, settings_.force_limit, false);
  if (own_->scaled.rank() < 6) {
    answer_.verdict = Verdict::cannot_hold;
    Eigen::Index axis;
    own_->scaled.unresisted().diagonal().maxCoeff(&axis);
    answer_.escape_twist = own_->scaled.twist(own_->scaled.unresisted().col(axis));
  }
  return answer_;
}

void Grasp::ask(GripProblem problem, double limit, bool warm) {
  const double size = power_of_two_near(problem.load.norm());
  problem.load /= size;
  problem.limits = limits_;
  own_->solver.solve(problem, warm);
  report(*own_, problem, size, 1, limit * size);
}

const GripAnswer& Grasp::distance(const Vector6& load, double length) {
  contact::require_positive("length", length);
  if (!about_origin_) about_origin_ = std::make_unique<Workspace>(contacts_, settings_, Vector3(Vector3::Zero()));
  for (const double x : load) contact::require_finite("load", x);
  const ScaledGrasp& grasp = about_origin_->scaled;
  const Vector6 w = grasp.scaled_load(load);
  const double size = power_of_two_near(w.norm());
  GripProblem problem{&grasp, Objective::distance, w / size};
  problem.metric = grasp.length() / length;
  about_origin_->solver.solve(problem, false);
  const Bracket& bracket = about_origin_->solver.bracket();
  // Rounding hides a distance of 0: that the load is held, other forces have to say.
  const bool none = bracket.lower() == 0 && bracket.upper() <= 1e-12;
  const bool held = none && least_grip(load).verdict == Verdict::holds;
  report(*about_origin_, problem, size, 1, 0);
  if (held) answer_.verdict = Verdict::holds;
  const double distance = answer_.value;
  report_contacts(grasp, bracket.forces(), bracket.twist(), size, distance);
  return answer_;
}

const GripAnswer& Grasp::least_quadratic_grip(const Vector6& load, double epsilon, double length) {
  const Vector6 w = scaled("load", load);
  contact::require_positive("epsilon", epsilon);
  const double own_length = contact::require_positive("length", length) / own_->scaled.length();
  if (!quadratic_) quadratic_ = std::make_unique<QuadraticGrip>(own_->scaled);
  const double size = power_of_two_near(w.norm());
  const bool balanced =
      quadratic_->solve(w / size, {epsilon, own_length}, settings_.max_iterations, settings_.force_limit);
  if (!balanced && least_grip(load).verdict == Verdict::cannot_hold) return answer_;
  const QuadraticGrip& q = *quadratic_;
  answer_.lower = size * size * q.lower();
  answer_.upper = balanced ? size * size * q.upper() : infinity;
  answer_.value = balanced ? (answer_.lower + answer_.upper) / 2 : answer_.lower;
  answer_.balance_residual = q.residual();
  answer_.charged = balanced && q.upper() > 0 ? q.residual() * q.twist().norm() / q.upper() : 0;
  const bool found =
      balanced && answer_.charged <= GripSolver::largest_charge &&
      std::ranges::all_of(q.forces(), [&](const PartForce& x) { return x.force <= settings_.force_limit; });
  answer_.verdict = found ? Verdict::holds : Verdict::undecided;
  answer_.effort = {Route::quadratic, 0, q.iterations(), 0};
  report_contacts(own_->scaled, q.forces(), q.twist(), size, size);
  return answer_;
}

// The load of the problem is 1 / size of that of the question, its twist 1 / pace; `limit` is in the units of the value.
void Grasp::report(const Workspace& from, const GripProblem& problem, double size, double pace, double limit) {
  const Bracket& bracket = from.solver.bracket();
  const bool factor = problem.objective == Objective::load_factor;
  const double value_scale = size * pace;
  answer_.lower = value_scale * bracket.lower();
  answer_.upper = value_scale * bracket.upper();
  answer_.charged = bracket.charged();
  answer_.balance_residual = bracket.residual();
  if (factor && std::isfinite(bracket.lower())) {
    answer_.balance_residual /= problem.load.norm() + std::fabs(bracket.lower()) * problem.step.norm();
  }
  answer_.effort = from.solver.effort();
  if (factor) {
    answer_.verdict = std::isfinite(answer_.lower) ? Verdict::holds : Verdict::undecided;
    answer_.value = std::isfinite(answer_.lower) ? answer_.lower : answer_.upper;
  } else {
    const bool found = answer_.upper <= limit && answer_.charged <= GripSolver::largest_charge;
    answer_.verdict = found ? Verdict::holds : answer_.lower > limit ? Verdict::cannot_hold : Verdict::undecided;
    answer_.value = std::isfinite(answer_.upper) ? (answer_.lower + answer_.upper) / 2 : answer_.lower;
  }
  report_contacts(from.scaled, bracket.forces(), bracket.twist(), size, pace);
  for (std::size_t i = 0; i < contacts_.size(); ++i) answer_.contacts[i].at_limit = from.solver.polish().is_capped(i);
}

void Grasp::report_contacts(const ScaledGrasp& grasp, std::span<const PartForce> forces, const Vector6& W, double size,
                            double pace) {
  answer_.escape_twist = pace * grasp.twist(W);
  std::ranges::fill(answer_.contacts, ContactAnswer{});
  for (std::size_t i = 0; i < grasp.parts().size(); ++i) {
    const ScaledGrasp::Part& part = grasp.parts()[i];
    const PartForce& x = forces[i];
    const bool first = i == 0 || grasp.parts()[i - 1].contact != part.contact;
    ContactAnswer& a = answer_.contacts[part.contact];
    a.normal_force += size * x.force;
    a.friction += size * Vector3(x.friction[0], x.friction[1], grasp.length() * x.friction[2]);
    if (x.force > 0) a.state = std::max(a.state, x.on_surface ? ContactState::slips : ContactState::sticks);
    const double D = part.element.dissipation(part.element.sliding(W)).value;
    a.dissipation = std::max(a.dissipation, pace * D);
    const double rho = pace * (part.element.mu() * D - part.element.N().dot(W));
    a.resistance = first ? rho : std::max(a.resistance, rho);
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    answer_.contacts[i].sliding = contacts_[i].sliding(answer_.escape_twist);
  }
}

}  // namespace patchgrip::grasp
