#include <patchgrip/friction/limit_surface/support_ratio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

namespace patchgrip::friction {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();  // of the few sums and products here

struct Corner {
  Twist v;
  SupportValue a, b;
};

struct Cone {
  std::array<Corner, 3> corners;
  double bound;

  bool operator<(const Cone& other) const { return bound < other.bound; }
};

Twist unit(const Twist& v) {
  const double size = std::sqrt(v.vx * v.vx + v.vy * v.vy + v.w * v.w);
  return {v.vx / size, v.vy / size, v.w / size};
}

// a(v) / t . v at most, with t of the body of b up to its error.
double ratio(const SupportValue& a, double power_of_b, double error_of_b) {
  const double least = power_of_b / (1 + error_of_b) - rounding;
  return least > 0 ? a.value * (1 + a.error + rounding) / least : infinity;
}

// How much the wrenches of both bodies turn from p to q, as the power of the change over the change of twist.
double turn(const Corner& p, const Corner& q) {
  const Twist d{p.v.vx - q.v.vx, p.v.vy - q.v.vy, p.v.w - q.v.w};
  return power(p.a.wrench, d) - power(q.a.wrench, d) + power(p.b.wrench, d) - power(q.b.wrench, d);
}

class Search {
 public:
  Search(const SupportFunction& a, const SupportFunction& b) : a_(a), b_(b) {
    // a and b are even: half of all twists.
    const std::array<Twist, 4> equator{Twist{1, 0, 0}, Twist{0, 1, 0}, Twist{-1, 0, 0}, Twist{0, -1, 0}};
    const Corner pole = corner({0, 0, 1});
    for (std::size_t k = 0; k < 4; ++k) push({corner(equator[k]), corner(equator[(k + 1) % 4]), pole});
  }

  LargestRatio run(double tolerance, int most_cones) {
    for (int k = 0; k < most_cones && cones_.top().bound > seen_ + tolerance; ++k) {
      const Cone cone = cones_.top();
      cones_.pop();
      split(cone.corners);
    }
    return {cones_.top().bound, attained_};
  }

 private:
  Corner corner(const Twist& v) const { return {v, a_(v), b_(v)}; }

  void push(const std::array<Corner, 3>& corners) {
    Twist sum;
    for (const Corner& c : corners) sum = {sum.vx + c.v.vx, sum.vy + c.v.vy, sum.w + c.v.w};
    const Twist middle = unit(sum);
    const SupportValue a = a_(middle), b = b_(middle);
    seen_ = std::max(seen_, ratio(a, power(b.wrench, middle), b.error));
    attained_ = std::max(attained_, a.value * (1 - a.error - rounding) / (b.value * (1 + b.error + rounding)));
    double bound = 0;
    for (const Corner& c : corners) bound = std::max(bound, ratio(c.a, power(b.wrench, c.v), b.error));
    cones_.push({corners, bound});
  }

  void split(const std::array<Corner, 3>& c) {
    const std::array<double, 3> turns{turn(c[1], c[2]), turn(c[2], c[0]), turn(c[0], c[1])};
    const auto i = static_cast<std::size_t>(std::max_element(turns.begin(), turns.end()) - turns.begin());
    const Corner &apex = c[i], &p = c[(i + 1) % 3], &q = c[(i + 2) % 3];
    const Corner between = corner(unit({p.v.vx + q.v.vx, p.v.vy + q.v.vy, p.v.w + q.v.w}));
    push({apex, p, between});
    push({apex, between, q});
  }

  const SupportFunction &a_, &b_;
  std::priority_queue<Cone> cones_;
  double seen_ = 0;      // the largest ratio in the middle of a cone, errors counted as in a bound
  double attained_ = 0;  // by the true functions
};

}  // namespace

LargestRatio largest_ratio(const SupportFunction& a, const SupportFunction& b, double tolerance, int most_cones) {
  return Search(a, b).run(tolerance, most_cones);
}

GaugeSides GaugeSides::scaled(double factor) const {
  return {std::max(0.0, (1 + largest_excess) * factor - 1), std::max(0.0, 1 - (1 - largest_deficit) * factor),
          slack * factor};
}

GaugeSides gauge_sides(const SupportFunction& model, const SupportFunction& truth) {
  constexpr double tolerance = 1e-5;
  const LargestRatio excess = largest_ratio(truth, model, tolerance), deficit = largest_ratio(model, truth, tolerance);
  const double slack = std::max(excess.bound - excess.attained, 1 / deficit.attained - 1 / deficit.bound);
  return {std::max(0.0, excess.bound - 1), std::max(0.0, 1 - 1 / deficit.bound), std::max(0.0, slack)};
}

}  // namespace patchgrip::friction
