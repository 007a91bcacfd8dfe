#include <patchgrip/friction/limit_surface/pade_wrench.h>

#include <algorithm>
#include <array>
#include <queue>

namespace patchgrip::friction {
namespace {

// Largest |p - q| over x in [0, 1] of two functions that rise or fall together, from above by <= `tolerance`: on an
// interval |p - q| <= max(|p(end) - q(start)|, |q(end) - p(start)|).
template <class P, class Q>
double largest_difference(const P& p, const Q& q, double tolerance) {
  struct End {
    double x, p, q;
  };
  struct Interval {
    End start, end;
    double bound;
    bool operator<(const Interval& other) const { return bound < other.bound; }
  };
  std::priority_queue<Interval> intervals;
  const auto at = [&](double x) { return End{x, p(x), q(x)}; };
  const auto push = [&](const End& s, const End& e) {
    intervals.push({s, e, std::max(std::fabs(e.p - s.q), std::fabs(e.q - s.p))});
  };
  push(at(0), at(1));
  double attained = 0;
  while (intervals.top().bound > attained + tolerance) {
    const auto [start, end, bound] = intervals.top();
    intervals.pop();
    const End middle = at((start.x + end.x) / 2);
    attained = std::max(attained, std::fabs(middle.p - middle.q));
    push(start, middle);
    push(middle, end);
  }
  return intervals.top().bound;
}

}  // namespace

PadeWrench::PadeWrench(int order, double radius, double slope, double spin_moment, double far, const Exact& exact)
    : order_(order),
      radius_(radius),
      spin_moment_(spin_moment),
      far_(far),
      lag_(1 / slope),
      lead_(order == 1 ? spin_moment / (radius * far) : radius * slope / (2 * spin_moment)),
      mixed_(order == 1 ? 0 : lead_ * radius * far / spin_moment) {
  constexpr double tolerance = 1e-5;
  const auto twist = [radius](double x) { return Twist{x, 0, (1 - x) / radius}; };
  force_error_ = largest_difference([&](double x) { return gradient(twist(x)).fx; },
                                    [&](double x) { return exact(twist(x)).fx; }, tolerance);
  moment_error_ = largest_difference([&](double x) { return gradient(twist(x)).m; },
                                     [&](double x) { return exact(twist(x)).m; }, tolerance * spin_moment);
}

}  // namespace patchgrip::friction
