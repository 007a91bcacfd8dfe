#include <patchgrip/friction/limit_surface/slips.h>

#include <algorithm>
#include <array>
#include <map>
#include <queue>
#include <tuple>

namespace patchgrip::friction {
namespace {

constexpr double finest = 0x1p-30;  // distance of twists that an edge is cut to

struct Cone {
  std::array<Slip, 3> corners;
  double longest;    // edge
  std::size_t apex;  // opposite to it

  bool operator<(const Cone& other) const { return longest < other.longest; }
};

// 0 where the twists are closer than finest.
double squared_distance(const Slip& p, const Slip& q) {
  const Twist v{p.twist.vx - q.twist.vx, p.twist.vy - q.twist.vy, p.twist.w - q.twist.w};
  const Wrench t{p.wrench.fx - q.wrench.fx, p.wrench.fy - q.wrench.fy, p.wrench.m - q.wrench.m};
  const double of_twists = v.vx * v.vx + v.vy * v.vy + v.w * v.w;
  if (!(of_twists > finest * finest)) return 0;
  return of_twists + t.fx * t.fx + t.fy * t.fy + t.m * t.m;
}

Cone cone(const std::array<Slip, 3>& c) {
  const std::array<double, 3> edges{squared_distance(c[1], c[2]), squared_distance(c[2], c[0]),
                                    squared_distance(c[0], c[1])};
  const auto longest = std::max_element(edges.begin(), edges.end());
  return {c, *longest, static_cast<std::size_t>(longest - edges.begin())};
}

}  // namespace

std::vector<Slip> spread_slips(const SupportFunction& D, std::size_t count) {
  const auto slip = [&](const Twist& v) -> Slip {
    const SupportValue d = D(v);
    return {{v.vx / d.value, v.vy / d.value, v.w / d.value}, d.wrench};
  };
  std::vector<Slip> slips;
  std::map<std::tuple<double, double, double>, int> met;
  // How often.
  const auto add = [&](const Slip& s) {
    const int times = ++met[{s.twist.vx, s.twist.vy, s.twist.w}];
    if (times == 1) slips.push_back(s);
    return times;
  };
  std::priority_queue<Cone> cones;
  const Slip spin = slip({0, 0, 1});
  const std::array<Twist, 4> equator{Twist{1, 0, 0}, Twist{0, 1, 0}, Twist{-1, 0, 0}, Twist{0, -1, 0}};
  add(spin);
  for (std::size_t k = 0; k < 4; ++k) {
    cones.push(cone({slip(equator[k]), slip(equator[(k + 1) % 4]), spin}));
    if (k < 2) add(slip(equator[k]));
  }
  while (slips.size() < count && !cones.empty() && cones.top().longest > 0) {
    const Cone c = cones.top();
    cones.pop();
    const Slip &apex = c.corners[c.apex], &p = c.corners[(c.apex + 1) % 3], &q = c.corners[(c.apex + 2) % 3];
    const Slip middle = slip({p.twist.vx + q.twist.vx, p.twist.vy + q.twist.vy, p.twist.w + q.twist.w});
    // An edge is bisected from both sides. Once more, and the cone is flat: of its parts one would be cut there again.
    if (add(middle) > 2) continue;
    cones.push(cone({apex, p, middle}));
    cones.push(cone({apex, middle, q}));
  }
  return slips;
}

}  // namespace patchgrip::friction
