#include <patchgrip/grasp/polish.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::grasp {
namespace {

bool slides(const Element& element) { return element.kind() != Element::Kind::normal; }

// How far apart eigenvalues of x and z must be to call one of them zero.
double signed_ratio(double x, double z) { return x / (x + z); }

}  // namespace

Polish::Polish(const ScaledGrasp& grasp)
    : grasp_(&grasp),
      parts_(grasp.parts().size()),
      work_(grasp.parts().size()),
      capped_(grasp.contacts()),
      sum_(grasp.contacts()) {}

void Polish::identify(const GripProblem& problem, const InteriorPoint& point) noexcept {
  steps_ = repairs_ = 0;
  reusable_ = false;
  W_ = point.twist();
  s_ = point.value();
  double x = 0, z = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const InteriorPoint::PartPoint p = point.part(i);
    x = std::max(x, p.x_most);
    z = std::max(z, p.z_most);
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const InteriorPoint::PartPoint p = point.part(i);
    PartState& state = parts_[i];
    const Element& element = grasp_->parts()[i].element;
    state.active = signed_ratio(p.x_most / x, p.z_least / z) > 0.5;
    const bool inside = signed_ratio(p.x_least / p.x_most, p.slip) > 0.5;
    state.slide = inside ? Slide::sticks : Slide::slips;
    state.force = p.force;
    state.friction = p.friction;
    state.v = element.sliding(W_);
  }
  for (std::size_t i = 0; i < capped_.size(); ++i) {
    const InteriorPoint::CapPoint c = point.cap(i);
    capped_[i] = problem.limited() && c.multiplier / z > c.slack / x;
  }
  double size = 1;
  if (problem.objective == Objective::load_factor) {
    size = problem.step.dot(W_);
  }
  if (size > 0 && size != 1) {
    W_ /= size;
    for (PartState& state : parts_) state.v /= size;
  }
}

void Polish::solution(Eigen::Ref<Eigen::VectorXd> x) const noexcept {
  x.head<7>() << W_, s_;
  Eigen::Index at = 7;
  for (const PartState& state : parts_) {
    x.segment<4>(at) << state.force, state.friction;
    at += 4;
  }
}

void Polish::restart(const Eigen::VectorXd& x) noexcept {
  steps_ = repairs_ = 0;
  reusable_ = false;
  W_ = x.head<6>();
  s_ = x[6];
  Eigen::Index at = 7;
  for (std::size_t i = 0; i < parts_.size(); ++i, at += 4) {
    parts_[i].force = x[at];
    parts_[i].friction = x.segment<3>(at + 1);
    parts_[i].v = grasp_->parts()[i].element.sliding(W_);
  }
}

double Polish::cap(const GripProblem& problem, std::size_t contact) const noexcept {
  if (!problem.limited()) return std::numeric_limits<double>::infinity();
  return problem.objective == Objective::max_force ? problem.limits[contact] * s_ : problem.limits[contact];
}

// Of the active parts of a capped contact the last one takes what the others leave.
void Polish::pin_forces(const GripProblem& problem) noexcept {
  std::ranges::fill(sum_, 0);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const std::size_t contact = grasp_->parts()[i].contact;
    const bool last = i + 1 == parts_.size() || grasp_->parts()[i + 1].contact != contact || !parts_[i + 1].active;
    work_[i].pinned = parts_[i].active && capped_[contact] != 0 && last;
    if (work_[i].pinned) parts_[i].force = cap(problem, contact) - sum_[contact];
    if (parts_[i].active) sum_[contact] += parts_[i].force;
  }
}

// Where each unknown stands; false if there are too many.
bool Polish::arrange(const GripProblem& problem) noexcept {
  pin_forces(problem);
  count_ = problem.limited() ? 7 : 6;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Element& element = grasp_->parts()[i].element;
    work_[i].unknown = count_;
    if (!parts_[i].active) continue;
    if (!work_[i].pinned) ++count_;
    if (slides(element) && parts_[i].slide == Slide::sticks) count_ += element.size();
    if (count_ > capacity) return false;
  }
  return true;
}

// The residual of what arrange() laid out, and K if asked for; false where a Hessian is infinite.
bool Polish::assemble(const GripProblem& problem, bool with_matrix) noexcept {
  if (with_matrix) K_.setZero(count_, count_);
  residual_.setZero(count_);
  Vector6 balance = problem.load;
  Matrix6 H = Matrix6::Zero();
  Vector6 border = Vector6::Zero();
  double border_residual = problem.objective == Objective::max_force ? 1 : 0;
  if (problem.objective == Objective::load_factor) {
    balance += s_ * problem.step;
    border = problem.step;
    border_residual = problem.step.dot(W_) - 1;
  } else if (problem.objective == Objective::distance) {
    const double k2 = problem.metric * problem.metric;
    const Vector6 metric = (Vector6() << 1, 1, 1, 1 / k2, 1 / k2, 1 / k2).finished();
    H.diagonal() -= metric;
    balance -= metric.cwiseProduct(W_);
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const PartState& state = parts_[i];
    Work& work = work_[i];
    if (!state.active) continue;
    const Element& element = grasp_->parts()[i].element;
    const double F = state.force;
    work.g = element.N();
    if (slides(element) && state.slide == Slide::slips) {
      if (with_matrix) {
        Derivatives d;
        if (!element.derivatives(state.v, d)) return false;
        work.gradient = d.gradient;
        const Eigen::Matrix<double, 6, 3> TH = (element.mu() * F) * (element.T() * d.hessian);
        H.noalias() -= TH * element.T().transpose();
        balance.noalias() -= TH * (element.sliding(W_) - state.v);
      } else {
        work.gradient = element.gradient(state.v);
      }
      work.g.noalias() -= element.mu() * (element.T() * work.gradient);
    } else if (slides(element)) {
      const Eigen::Index at = work.unknown + (work.pinned ? 0 : 1);
      const auto T = element.T().middleCols(element.first(), element.size());
      if (with_matrix) {
        K_.block(0, at, 6, element.size()) = T;
        K_.block(at, 0, element.size(), 6) = T.transpose();
      }
      residual_.segment(at, element.size()) = T.transpose() * W_;
      balance.noalias() += element.T() * state.friction;
    }
    balance += F * work.g;
    if (work.pinned && problem.objective == Objective::max_force) {
      const double c = problem.limits[grasp_->parts()[i].contact];
      border += c * work.g;
      border_residual += c * work.g.dot(W_);
    }
  }
  const double one = problem.objective == Objective::total_force ? 1 : 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!parts_[i].active || work_[i].pinned) continue;
    const bool relative = capped_[grasp_->parts()[i].contact] != 0;  // to the pinned part, which is the next
    const Vector6 g = relative ? Vector6(work_[i].g - work_[i + 1].g) : work_[i].g;
    const Eigen::Index at = work_[i].unknown;
    if (with_matrix) {
      K_.block<6, 1>(0, at) = g;
      K_.block<1, 6>(at, 0) = g.transpose();
    }
    residual_[at] = g.dot(W_) + (relative ? 0 : one);
  }
  residual_.head<6>() = balance;
  if (problem.limited()) residual_[6] = border_residual;
  if (!with_matrix) return true;
  if (problem.objective != Objective::distance) {
    H -= std::max(1.0, H.diagonal().cwiseAbs().maxCoeff()) * grasp_->unresisted();
  }
  K_.topLeftCorner<6, 6>() = H;
  if (problem.limited()) {
    K_.block<6, 1>(0, 6) = border;
    K_.block<1, 6>(6, 0) = border.transpose();
  }
  return true;
}

// Rows and columns of K made alike in size first.
void Polish::factor() noexcept {
  const Eigen::Index n = count_;
  scale_.setOnes(n);
  right_.resize(n);
  for (int pass = 0; pass < 3; ++pass) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const double largest = scale_[i] * K_.col(i).cwiseAbs().cwiseProduct(scale_).maxCoeff();
      right_[i] = largest > 0 ? 1 / std::sqrt(largest) : 1;
    }
    scale_ = scale_.cwiseProduct(right_).eval();
  }
  scaled_ = scale_.asDiagonal() * K_ * scale_.asDiagonal();
  regular_.compute(scaled_);
  is_regular_ = regular_.matrixLU().diagonal().cwiseAbs().minCoeff() > 1e-8;
  if (is_regular_) return;
  singular_.setThreshold(1e-13);
  singular_.compute(scaled_);
}

// K step = -residual; the next step takes what rounding leaves of it.
bool Polish::solve() noexcept {
  right_ = -scale_.cwiseProduct(residual_);
  if (is_regular_) {
    step_ = regular_.solve(right_);
  } else {
    step_ = singular_.solve(right_);
    right_ -= scaled_ * step_;
    step_ += singular_.solve(right_);
  }
  step_ = scale_.cwiseProduct(step_).eval();
  return step_.allFinite();
}

bool Polish::factor(const GripProblem& problem) noexcept {
  if (!arrange(problem) || !assemble(problem, true)) return false;
  factor();
  return true;
}

const Polish::Column& Polish::step(const Column& residual) noexcept {
  residual_ = residual;
  solve();
  return step_;
}

// Takes the step; change_ becomes its relative size.
void Polish::update(const GripProblem& problem) noexcept {
  displaced_ = false;
  double force_change = 0, force_size = 0;
  const double before = s_, size_before = W_.norm();
  W_ += step_.head<6>();
  if (problem.limited()) s_ += step_[6];
  if (problem.objective == Objective::max_force) {
    force_change = std::fabs(s_ - before);
    force_size = std::fabs(s_);
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    PartState& state = parts_[i];
    if (!state.active) continue;
    const Element& element = grasp_->parts()[i].element;
    Eigen::Index at = work_[i].unknown;
    const auto add = [&](double& x) {
      const double d = step_[at++];
      x += d;
      force_change = std::max(force_change, std::fabs(d));
      force_size = std::max(force_size, std::fabs(x));
    };
    if (!work_[i].pinned) add(state.force);
    force_size = std::max(force_size, std::fabs(state.force));
    if (!slides(element)) continue;
    const Vector3 v = element.sliding(W_);
    if (state.slide == Slide::sticks) {
      for (Eigen::Index k = 0; k < element.size(); ++k) add(state.friction[element.first() + k]);
      state.v = v;
      continue;
    }
    // Never through the apex: there the slip, and with it the gradient, turns round.
    const bool reversed = work_[i].gradient.dot(v) <= 0;
    state.v = reversed ? Vector3(0.1 * state.v) : v;
    displaced_ |= reversed;
  }
  change_ = std::max(step_.head<6>().norm() / std::min(size_before, W_.norm()),
                     force_change / (force_size > 0 ? force_size : 1));
}

// Relative size of the last step. K is used again where it is good for four digits a step.
double Polish::newton(const GripProblem& problem, int max_steps) noexcept {
  constexpr double contracts_well = 1e-4, rounding = 0x1p-53;
  double before = 1;
  for (int k = 0; k < max_steps; ++k) {
    change_ = std::numeric_limits<double>::infinity();
    if (!arrange(problem)) return change_;
    const bool again = reusable_ && !displaced_;
    if (!assemble(problem, !again)) return change_;
    if (!again) factor();
    if (!solve()) return change_;
    update(problem);
    ++steps_;
    if (!(change_ < 10)) return change_;
    // By what the next step with this K is smaller: as this one was, or, with a new K, by the square.
    const double ratio = change_ / before, contraction = again || k == 0 ? ratio : ratio * ratio;
    if (change_ * contraction < rounding || (change_ < 1e-10 && ratio > 0.3)) break;
    reusable_ = contraction < contracts_well;
    before = change_;
  }
  pin_forces(problem);
  return change_;
}

struct Polish::Change {
  double size = 0;
  std::size_t part = 0;
  PartState state{};
  bool capped = false;
};

// Looks for wrong signs and changes them; true if there were any.
bool Polish::repair(const GripProblem& problem, bool only_worst) noexcept {
  constexpr double tolerance = 1e-10;
  const double W = W_.norm();
  const double one = problem.objective == Objective::total_force ? 1 : 0;
  double most = std::numeric_limits<double>::min();
  for (const PartState& state : parts_) {
    if (state.active) most = std::max(most, std::fabs(state.force));
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Element& element = grasp_->parts()[i].element;
    work_[i].speed = element.dissipation(element.sliding(W_)).value;
    work_[i].rho = -element.N().dot(W_) + element.mu() * work_[i].speed - one;
  }
  bool any = false;
  Change worst;
  const auto change = [&](double size, std::size_t i, const PartState& state, bool capped) {
    any = true;
    if (!only_worst) {
      parts_[i] = state;
      capped_[grasp_->parts()[i].contact] = capped;
    } else if (size > worst.size) {
      worst = {size, i, state, capped};
    }
  };
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Element& element = grasp_->parts()[i].element;
    const std::size_t contact = grasp_->parts()[i].contact;
    const bool capped = capped_[contact] != 0;
    PartState next = parts_[i];
    const Vector3 v = element.sliding(W_);
    const double speed = work_[i].speed;
    if (!next.active) {
      double multiplier = 0;
      for (const std::size_t j : {i - 1, i + 1}) {
        if (capped && j < parts_.size() && grasp_->parts()[j].contact == contact) multiplier = work_[j].rho;
      }
      if (work_[i].rho - multiplier <= tolerance * W) continue;
      next = {true, speed < 1e-9 * W ? Slide::sticks : Slide::slips, 0, Vector3::Zero(), v};
      change((work_[i].rho - multiplier) / W, i, next, capped);
      continue;
    }
    const double F = next.force;
    const double limit = cap(problem, contact);
    if (F < -tolerance * most) {
      next.active = false;
      change(-F / most, i, next, capped && !work_[i].pinned);
    } else if (!capped && sum_[contact] > limit * (1 + tolerance)) {
      change((sum_[contact] - limit) / most, i, next, true);
    } else if (work_[i].pinned && work_[i].rho < -tolerance * W) {
      change(-work_[i].rho / W, i, next, false);
    } else if (slides(element) && next.slide == Slide::sticks) {
      const double g = element.gauge(next.friction);
      if (g <= element.mu() * F * (1 + tolerance) + tolerance * most) continue;
      const Vector3 slip = element.slip(next.friction);
      const double D = element.dissipation(slip).value;
      next.slide = Slide::slips;
      const double pace = 1e-3 * W * std::min(1.0, g / (element.mu() * most));
      if (!(D > 0)) continue;
      next.v = -pace / D * slip;
      change(g / (element.mu() * most) - F / most, i, next, capped);
    } else if (slides(element) && (speed < 1e-8 * W || element.gradient(next.v).dot(v) <= 0)) {
      next.slide = Slide::sticks;
      next.friction = -element.mu() * F * element.gradient(next.v);
      change(1, i, next, capped);
    }
  }
  if (only_worst && any) {
    parts_[worst.part] = worst.state;
    capped_[grasp_->parts()[worst.part].contact] = worst.capped;
  }
  // A cap needs a force that it holds.
  pin_forces(problem);
  for (std::size_t c = 0; c < capped_.size(); ++c) {
    if (sum_[c] == 0) capped_[c] = 0;
  }
  if (any) {
    ++repairs_;
    reusable_ = false;
  }
  return any;
}

bool Polish::converge(const GripProblem& problem) noexcept { return newton(problem, 8) < 10; }

bool Polish::run(const GripProblem& problem, int max_rounds) noexcept {
  for (int round = 0; round < max_rounds; ++round) {
    if (!repair(problem, round > 3)) return change_ < 1e-8;
    if (!converge(problem)) return false;
  }
  return !repair(problem, true) && change_ < 1e-8;
}

}  // namespace patchgrip::grasp
