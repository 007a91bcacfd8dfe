#include <patchgrip/grasp/held_ball.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include <patchgrip/contact/require.h>
#include <patchgrip/grasp/spherical_simplex.h>

namespace patchgrip::grasp {
namespace {

constexpr double unit = 0x1p-53;

// H and its gradient. Directions, of twists or loads, are of size 1 in the metric, in the coordinates asked for.
struct Support {
  double value = 0;
  double error = 0;
  Direction held;     // grad H: a load that the grasp holds
  bool known = true;  // the gradient lies in the coordinates
};

class Quality {
 public:
  Quality(const std::vector<Contact>& contacts, GripMeasure measure, double length, bool planar)
      : grasp_(contacts),
        scaled_(grasp_.contacts(), Vector3::Zero()),
        measure_(measure),
        arm_(scaled_.length() / length),
        axes_(planar ? std::vector<int>{0, 1, 5} : std::vector<int>{0, 1, 2, 3, 4, 5}),
        most_(grasp_.contacts().size()) {}

  Eigen::Index size() const noexcept { return static_cast<Eigen::Index>(axes_.size()); }

  // The scaled twist of a direction, and back; the same for loads, which scale the other way.
  Vector6 scaled_twist(const Direction& y) const noexcept { return expanded(y, arm_); }
  Vector6 twist(const Direction& y) const noexcept { return scaled_.twist(scaled_twist(y)); }
  Vector6 load(const Direction& y) const noexcept {
    Vector6 w = expanded(y, 1 / arm_);
    w.tail<3>() *= scaled_.length();
    return w;
  }

  Support support(const Direction& y) noexcept;

  // What is held in a direction of loads, and the normal where it gives way.
  struct Shot {
    double held = 0;
    Direction normal;
  };
  Shot shoot(const Direction& y);

  // Downhill from y, to where H / |W| no longer falls.
  std::pair<double, Direction> descend(Direction y);

 private:
  Vector6 expanded(const Direction& y, double arm) const noexcept {
    Vector6 W = Vector6::Zero();
    for (Eigen::Index j = 0; j < size(); ++j) {
      const int axis = axes_[static_cast<std::size_t>(j)];
      W[axis] = axis < 3 ? y[j] : arm * y[j];
    }
    return W;
  }
  // A scaled twist by its direction; what lies outside the coordinates is left out.
  Direction direction(const Vector6& W, double arm) const noexcept {
    Direction y(size());
    for (Eigen::Index j = 0; j < size(); ++j) {
      const int axis = axes_[static_cast<std::size_t>(j)];
      y[j] = axis < 3 ? W[axis] : W[axis] / arm;
    }
    return y;
  }

  struct Most {
    double rho = 0, error = 0;
    Vector6 held = Vector6::Zero();
  };

  Grasp grasp_;
  ScaledGrasp scaled_;
  GripMeasure measure_;
  double arm_;  // moments of 1 N l, over the scaled unit of moment
  std::vector<int> axes_;
  std::vector<Most> most_;
};

Support Quality::support(const Direction& y) noexcept {
  const Vector6 W = scaled_twist(y);
  std::ranges::fill(most_, Most{});
  for (const ScaledGrasp::Part& part : scaled_.parts()) {
    const BoundedValue rho = part.element.resistance(W, scaled_.rounding());
    Most& most = most_[part.contact];
    most.error = std::max(most.error, rho.error);
    if (rho.value <= most.rho) continue;
    most.rho = rho.value;
    const Vector3 slope = part.element.gradient(part.element.sliding(W));
    most.held = -part.element.N();
    if (part.element.mu() > 0) most.held += part.element.mu() * (part.element.T() * slope);
  }
  Support h;
  Vector6 held = Vector6::Zero();
  if (measure_ == GripMeasure::total_force) {
    const Most& most = *std::ranges::max_element(most_, {}, &Most::rho);
    h.value = most.rho;
    held = most.held;
    for (const Most& one : most_) h.error = std::max(h.error, one.error);
  } else {
    for (const Most& one : most_) {
      h.value += one.rho;
      h.error += one.error;
      held += one.held;
    }
  }
  h.error += 8 * unit * h.value;
  h.held = direction(held, 1 / arm_);
  h.known = (expanded(h.held, 1 / arm_) - held).norm() <= 1e-12 * held.norm();
  return h;
}

Quality::Shot Quality::shoot(const Direction& y) {
  const Vector6 w = load(y);
  const GripAnswer& a = measure_ == GripMeasure::largest_force ? grasp_.least_grip(w) : grasp_.least_total_grip(w);
  Shot shot;
  shot.held = a.verdict == Verdict::holds ? 1 / a.upper : 0;
  shot.normal = direction(scaled_.scaled_twist(a.escape_twist), arm_);
  const double size = shot.normal.norm();
  if (size > 0) shot.normal /= size;
  return shot;
}

std::pair<double, Direction> Quality::descend(Direction y) {
  constexpr int most_shots = 200;
  double best = support(y).value;
  Direction where = y;
  for (int shot = 0; shot < most_shots; ++shot) {
    const Direction next = shoot(y).normal;
    if (!(next.norm() > 0)) break;
    const double value = support(next).value;
    if (!(value < best * (1 - 4 * unit))) break;
    // A step of rounding is the last one.
    const bool settled = (next - y).norm() < 1e-9;
    best = value;
    y = where = next;
    if (settled) break;
  }
  return {best, where};
}

struct Simplex {
  SimplexCorners corners;
  double bound;
  Direction middle;
  double value;  // of H there

  bool operator<(const Simplex& other) const noexcept { return bound > other.bound; }  // the lowest first
};

void bound(Quality& quality, Simplex& simplex, double inherited) {
  simplex.middle = middle_of(simplex.corners);
  const Support h = quality.support(simplex.middle);
  simplex.value = h.value + h.error;
  // Held: the gradient, the load along the middle, and what lies between.
  const Direction along = quality.shoot(simplex.middle).held * simplex.middle;
  simplex.bound = inherited;
  for (const double share : {0., 0.5, 1.}) {
    if (share < 1 && !h.known) continue;
    const Direction held = share * along + (1 - share) * h.held;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index j = 0; j < simplex.corners.cols(); ++j) least = std::min(least, simplex.corners.col(j).dot(held));
    simplex.bound = std::max(simplex.bound, least - 8 * unit * held.norm() - h.error);
  }
}

std::pair<Simplex, Simplex> halves(const Simplex& simplex) {
  const auto [a, b] = longest_edge(simplex.corners);
  std::pair<Simplex, Simplex> both{simplex, simplex};
  const Direction middle = (simplex.corners.col(a) + simplex.corners.col(b)).normalized();
  both.first.corners.col(a) = middle;
  both.second.corners.col(b) = middle;
  return both;
}

}  // namespace

void BallSettings::check() const {
  contact::require_positive("relative_width", relative_width);
  if (relative_width >= 1) contact::refuse("relative_width", relative_width, "must lie in (0, 1)");
  if (max_simplices < 0) contact::refuse("max_simplices", max_simplices, "must not be negative");
}

HeldBall held_ball(const std::vector<Contact>& contacts, GripMeasure measure, double length,
                   const BallSettings& settings) {
  settings.check();
  Quality quality(contacts, measure, contact::require_positive("length", length), settings.planar);
  const Eigen::Index n = quality.size();
  HeldBall ball;
  Direction touching = Direction::Unit(n, 0);
  ball.upper = std::numeric_limits<double>::infinity();
  const auto lower_upper = [&](double value, const Direction& y) {
    if (!(value < ball.upper)) return;
    ball.upper = value;
    touching = y;
  };
  const auto search = [&](const Direction& from) {
    const auto [value, y] = quality.descend(from);
    const Support h = quality.support(y);
    lower_upper(value + h.error, y);
  };

  // The orthants, and the way down from the middle of each.
  std::priority_queue<Simplex> open;
  for (int signs = 0; signs < 1 << n; ++signs) {
    Simplex piece;
    piece.corners = orthant(n, signs);
    bound(quality, piece, 0);
    lower_upper(piece.value, piece.middle);
    search(piece.middle);
    open.push(std::move(piece));
  }
  const auto met = [&] { return open.top().bound >= (1 - settings.relative_width) * ball.upper; };
  while (ball.simplices < settings.max_simplices && !met()) {
    if (settings.check_interrupt) settings.check_interrupt();
    auto [first, second] = halves(open.top());
    const double inherited = open.top().bound;
    open.pop();
    for (Simplex* half : {&first, &second}) {
      bound(quality, *half, inherited);
      if (half->value < ball.upper) {
        lower_upper(half->value, half->middle);
        search(half->middle);
      }
      open.push(std::move(*half));
    }
    ++ball.simplices;
  }
  ball.lower = settings.max_simplices > 0 ? std::clamp(open.top().bound, 0.0, ball.upper) : 0;
  ball.twist = quality.twist(touching);
  ball.load = quality.load(touching);
  return ball;
}

}  // namespace patchgrip::grasp
