#include <patchgrip/grasp/bracket.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::grasp {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Bracket::Bracket(const ScaledGrasp& grasp)
    : forces_(grasp.parts().size()), trial_(grasp.parts().size()), most_(grasp.contacts()) {}

void Bracket::reset(const GripProblem& problem) noexcept {
  problem_ = problem;
  lower_ = maximises() ? -infinity : 0;
  upper_ = infinity;
  residual_ = steepest_ = total_ = 0;
  twist_.setZero();
  std::ranges::fill(forces_, PartForce{});
}

void Bracket::add_twist(const Vector6& W) noexcept {
  const double size = W.norm();
  if (!(size > 0) || !std::isfinite(size)) return;
  const ScaledGrasp& grasp = *problem_.grasp;
  std::ranges::fill(most_, 0);
  for (const ScaledGrasp::Part& part : grasp.parts()) {
    const BoundedValue rho = part.element.resistance(W, grasp.rounding());
    most_[part.contact] = std::max(most_[part.contact], rho.value + rho.error);
  }
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < most_.size(); ++i) {
    sum += problem_.limited() ? problem_.limits[i] * most_[i] : most_[i];
    most = std::max(most, most_[i]);
  }
  sum *= 1 + grasp.rounding() * static_cast<double>(most_.size());
  const double power = problem_.load.dot(W);
  const double rounding = 8 * grasp.rounding();
  const double lost = rounding * problem_.load.norm() * size;
  switch (problem_.objective) {
    case Objective::load_factor: {
      const double step = problem_.step.dot(W);
      if (!(step > 0)) return;
      const double bound = (sum - power + lost) / step;
      const double sure = bound + rounding * std::fabs(bound) * problem_.step.norm() * size / step;
      steepest_ = std::max(steepest_, size / step);
      if (sure < upper_) {
        upper_ = sure;
        twist_ = W / step;
      }
      return;
    }
    case Objective::distance: {
      const double k2 = problem_.metric * problem_.metric;
      const double norm = std::sqrt(W.head<3>().squaredNorm() + W.tail<3>().squaredNorm() / k2);
      // Forces that carry more than was found can only be a little larger.
      const double bound = (power - lost - 2 * std::max(total_, 1.0) * most) / norm;
      if (bound > lower_ || twist_.isZero()) {
        lower_ = std::max(lower_, bound);
        twist_ = W / norm;
      }
      return;
    }
    default: {
      const double resistance = std::max(problem_.objective == Objective::max_force ? sum : most, 1e-100);
      const double bound = (power - lost) / resistance;
      if (!(bound > 0)) return;
      steepest_ = std::max(steepest_, std::min(size / resistance, 1e100));
      if (bound > lower_) {
        lower_ = bound;
        twist_ = W / resistance;
      }
    }
  }
}

bool Bracket::add_forces(std::span<const PartForce> forces, double value) noexcept {
  const ScaledGrasp& grasp = *problem_.grasp;
  using Extended = Eigen::Matrix<long double, 6, 1>;
  Extended sum = problem_.load.cast<long double>();
  if (maximises()) sum += value * problem_.step.cast<long double>();
  double total = 0;
  std::ranges::fill(most_, 0);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const Element& element = grasp.parts()[i].element;
    PartForce& x = trial_[i] = forces[i];
    if (x.on_surface) {
      x.force *= 1 + 16 * 0x1p-53;
    } else if (element.kind() != Element::Kind::normal) {
      x.force = std::max(x.force, element.gauge(x.friction) / element.mu());
    }
    if (!(x.force >= 0)) return false;
    sum += element.N().cast<long double>() * x.force;
    if (element.kind() != Element::Kind::normal) {
      for (int k = 0; k < 3; ++k) sum += element.T().col(k).cast<long double>() * x.friction[k];
    }
    total += x.force;
    most_[grasp.parts()[i].contact] += x.force;
  }
  const Vector6 balance = sum.cast<double>();
  const double rounding = 4 * grasp.rounding() * total;
  const double residual = balance.norm() + rounding;
  const double size = problem_.load.norm() + (maximises() ? std::fabs(value) * problem_.step.norm() : 0) + total;
  if (problem_.objective == Objective::distance) {
    const double k = problem_.metric;
    const double distance = std::sqrt(balance.head<3>().squaredNorm() + k * k * balance.tail<3>().squaredNorm());
    const double sure = distance + rounding * std::max(1.0, k);
    if (sure < upper_) {
      upper_ = sure;
      residual_ = residual;
      total_ = total;
      std::ranges::copy(trial_, forces_.begin());
    }
    return true;
  }
  if (!(residual <= 1e-12 * size)) return false;
  double bound = 0;
  if (problem_.objective == Objective::total_force) {
    bound = total;
  } else {
    for (std::size_t i = 0; i < most_.size(); ++i) bound = std::max(bound, most_[i] / problem_.limits[i]);
  }
  if (maximises()) {
    // Shrunk back under their caps the forces carry that much less of everything.
    const double over = std::max(0.0, bound - 1);
    const double scale = std::fabs(value) + problem_.load.norm() * steepest_;
    bound = value - over * scale - residual * steepest_;
    if (over > 1e-6 || !(bound > lower_)) return over <= 1e-6;
    lower_ = bound;
  } else {
    if (!(bound + residual * steepest_ < upper())) return true;
    upper_ = bound;
  }
  residual_ = residual;
  total_ = total;
  std::ranges::copy(trial_, forces_.begin());
  return true;
}

void Bracket::add_extended(double lower, const Vector6& W, std::span<const PartForce> forces, double upper,
                           double residual) noexcept {
  steepest_ = std::max(steepest_, W.norm());
  if (lower > lower_) {
    lower_ = lower;
    twist_ = W;
  }
  if (!(upper + residual * steepest_ < this->upper())) return;
  upper_ = upper;
  residual_ = residual;
  std::ranges::copy(forces, forces_.begin());
}

double Bracket::upper() const noexcept {
  const bool charge = problem_.objective == Objective::max_force || problem_.objective == Objective::total_force;
  return charge && upper_ < infinity ? upper_ + residual_ * steepest_ : upper_;
}

double Bracket::charged() const noexcept {
  return upper_ > 0 && upper_ < infinity ? residual_ * steepest_ / upper() : 0;
}

double Bracket::width() const noexcept {
  if (upper() == lower_) return 0;
  const double size = std::max(std::fabs(upper()), std::numeric_limits<double>::min());
  return upper() < infinity ? (upper() - lower_) / size : infinity;
}

}  // namespace patchgrip::grasp
