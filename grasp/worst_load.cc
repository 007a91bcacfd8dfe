#include <patchgrip/grasp/worst_load.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <patchgrip/contact/require.h>
#include <patchgrip/grasp/spherical_simplex.h>

namespace patchgrip::grasp {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Of the convex function, the least grip or one over the load factor.
struct Demand {
  double lower;
  double upper;  // infinite unless the load is held
  const GripAnswer& answer;
};
using Question = std::function<Demand(const Vector6& load)>;

struct Simplex {
  SimplexCorners corners;
  std::size_t centre;  // corner of the set that it lies about
  double bound;

  bool operator<(const Simplex& other) const noexcept { return bound < other.bound; }  // the highest first
};

class Search {
 public:
  Search(Question question, const LoadSet& set) : question_(std::move(question)), set_(set) {
    for (Eigen::Index k = 0; k < dimension(); ++k) axes_.col(k) = set.axes[static_cast<std::size_t>(k)];
  }

  WorstLoad run(const WorstLoadSettings& settings);

 private:
  Eigen::Index dimension() const noexcept { return static_cast<Eigen::Index>(set_.axes.size()); }
  Vector6 load(std::size_t centre, const Direction& y) const {
    return set_.corners[centre] + axes_.leftCols(dimension()) * y;
  }

  // Asks, and keeps the answer if it is the worst so far.
  Demand ask(const Vector6& load);
  void climb(std::size_t centre, Direction y);
  void bound(Simplex& piece, double inherited);

  Question question_;
  const LoadSet& set_;
  Matrix6 axes_ = Matrix6::Zero();  // one a column
  WorstLoad worst_;
  double inside_ = 0;  // upper bound of what is not on a sphere
};

Demand Search::ask(const Vector6& load) {
  const Demand demand = question_(load);
  const bool fails = demand.answer.verdict == Verdict::cannot_hold;
  if (demand.lower > worst_.lower || fails || worst_.answer.contacts.empty()) {
    worst_.lower = demand.lower;
    worst_.load = load;
    worst_.answer = demand.answer;
    if (fails) worst_.verdict = Verdict::cannot_hold;
  }
  return demand;
}

void Search::climb(std::size_t centre, Direction y) {
  constexpr int most_steps = 200;
  double best = 0;
  for (int step = 0; step < most_steps && worst_.verdict != Verdict::cannot_hold; ++step) {
    const Demand demand = ask(load(centre, y));
    if (!(demand.lower > best * (1 + 0x1p-51))) return;
    best = demand.lower;
    const Vector6 farthest = axes_.transpose() * demand.answer.escape_twist;
    const double size = farthest.norm();
    if (!(size > 0)) return;
    y = farthest.head(dimension()) / size;
  }
}

void Search::bound(Simplex& piece, double inherited) {
  const Eigen::Index n = piece.corners.cols();
  const Direction m = piece.corners.transpose().partialPivLu().solve(Direction::Ones(n));
  const double reach = m.norm() * (1 + 1e-12);
  double most = inside_;
  for (Eigen::Index j = 0; j < n && most < inherited; ++j) {
    // Not a load of the set: that it cannot be held means nothing.
    most = std::max(most, question_(load(piece.centre, reach * piece.corners.col(j))).upper);
  }
  piece.bound = std::min(most, inherited);
}

WorstLoad Search::run(const WorstLoadSettings& settings) {
  const auto fails = [&] { return worst_.verdict == Verdict::cannot_hold; };
  for (const Vector6& corner : set_.corners) {
    inside_ = std::max(inside_, ask(corner).upper);
    if (fails()) break;
  }
  const Eigen::Index n = dimension();
  std::priority_queue<Simplex> open;
  for (std::size_t centre = 0; n > 0 && centre < set_.corners.size() && !fails(); ++centre) {
    for (int which = 0; which < 1 << n && !fails(); ++which) {
      Simplex piece{orthant(n, which), centre, 0};
      climb(centre, middle_of(piece.corners));
      bound(piece, infinity);
      open.push(std::move(piece));
    }
  }
  const auto upper = [&] { return open.empty() ? inside_ : std::max(inside_, open.top().bound); };
  while (n > 1 && !fails() && inside_ < infinity && worst_.simplices < settings.max_simplices &&
         !(worst_.lower >= (1 - settings.relative_width) * upper())) {
    if (settings.check_interrupt) settings.check_interrupt();
    const Simplex piece = open.top();
    open.pop();
    const auto [a, b] = longest_edge(piece.corners);
    const Direction middle = (piece.corners.col(a) + piece.corners.col(b)).normalized();
    climb(piece.centre, middle);
    for (const Eigen::Index replaced : {a, b}) {
      Simplex half = piece;
      half.corners.col(replaced) = middle;
      bound(half, piece.bound);
      open.push(std::move(half));
    }
    ++worst_.simplices;
  }
  worst_.upper = fails() ? infinity : std::max(upper(), worst_.lower);
  if (!fails()) worst_.verdict = worst_.upper < infinity ? Verdict::holds : Verdict::undecided;
  return std::move(worst_);
}

void check(const LoadSet& loads) {
  if (loads.corners.empty()) throw std::invalid_argument("corners = none is not allowed: a set has at least one load");
  if (loads.axes.size() > 6) {
    contact::refuse("number of axes", static_cast<double>(loads.axes.size()), "must be at most 6");
  }
  for (const Vector6& corner : loads.corners) {
    for (const double x : corner) contact::require_finite("corner", x);
  }
  for (const Vector6& axis : loads.axes) {
    for (const double x : axis) contact::require_finite("axis", x);
  }
}

}  // namespace

LoadSet LoadSet::ball(const Vector6& centre, double radius, double length) {
  const double r = contact::require_positive("radius", radius), l = contact::require_positive("length", length);
  LoadSet set{{centre}};
  for (Eigen::Index k = 0; k < 6; ++k) set.axes.emplace_back((k < 3 ? r : r * l) * Vector6::Unit(k));
  return set;
}

void WorstLoadSettings::check() const {
  contact::require_in("relative_width", relative_width, 0, 1, contact::Ends::open);
  contact::require_non_negative("max_simplices", max_simplices);
}

WorstLoad worst_grip(const std::vector<Contact>& contacts, const LoadSet& loads, GripMeasure measure,
                     const WorstLoadSettings& settings) {
  settings.check();
  check(loads);
  Grasp grasp(contacts);
  const auto question = [&](const Vector6& load) -> Demand {
    const bool each = measure == GripMeasure::largest_force;
    const GripAnswer& a = each ? grasp.least_grip(load) : grasp.least_total_grip(load);
    return {a.lower, a.verdict == Verdict::holds ? a.upper : infinity, a};
  };
  return Search(question, loads).run(settings);
}

WorstLoad worst_load_factor(const std::vector<Contact>& contacts, const Vector6& load, const LoadSet& loads,
                            std::span<const double> limits, const WorstLoadSettings& settings) {
  settings.check();
  check(loads);
  Grasp grasp(contacts);
  const GripAnswer start = grasp.holds_within(load, limits);
  if (start.verdict != Verdict::holds) return {start.verdict, -infinity, infinity, load, start, 0};
  const auto inverse = [](double factor) { return factor > 0 ? 1 / factor : infinity; };
  const auto question = [&](const Vector6& step) -> Demand {
    if (step.isZero(0)) return {0, 0, start};
    const GripAnswer& a = grasp.load_factor(load, step, limits);
    return {inverse(a.upper), inverse(a.lower), a};
  };
  WorstLoad worst = Search(question, loads).run(settings);
  worst.verdict = Verdict::holds;
  std::tie(worst.lower, worst.upper) = std::pair(1 / worst.upper, inverse(worst.lower));
  return worst;
}

}  // namespace patchgrip::grasp
