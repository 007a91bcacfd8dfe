// Stribeck's excess E(u) = int exp(-|u_P|^2) (u_P / |u_P|) [1; P x] p / F_N dA in 64 bits by ways other than those of
// the library: the judge of friction/local_stribeck.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <patchgrip/friction/kernels/edge_sum.h>
#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

using Long = long double;
using Quad = boost::multiprecision::cpp_bin_float_quad;

// A velocity is not always a double: that of a patch which lies elsewhere, and that in units of v_S.
struct LongTwist {
  LongTwist(const Twist& u) : vx(u.vx), vy(u.vy), w(u.w) {}
  LongTwist(Long x, Long y, Long spin) : vx(x), vy(y), w(spin) {}

  Long vx, vy, w;
};

struct LocalExcess {
  Long fx = 0, fy = 0, m = 0;

  friend LocalExcess operator+(const LocalExcess& a, const LocalExcess& b) {
    return {a.fx + b.fx, a.fy + b.fy, a.m + b.m};
  }
  friend LocalExcess operator*(Long k, const LocalExcess& a) { return {k * a.fx, k * a.fy, k * a.m}; }
};

// Tanh-sinh quadrature down to steps that see a singularity 1e-16 beside an end.
class LongNodes {
 public:
  static constexpr int finest = 512, coarsest = 4, reach = 5;

  struct Node {
    Long from_lo, to_hi, weight;  // on [0, 1]
  };

  static const std::vector<Node>& shared() {
    static const std::vector<Node> nodes = [] {
      std::vector<Node> all;
      for (int i = -reach * finest; i <= reach * finest; ++i) {
        const Long t = Long(i) / finest, s = std::numbers::pi_v<Long> / 2 * std::sinh(t);
        const Long x = 1 / (1 + std::exp(-2 * s)), y = 1 / (1 + std::exp(2 * s));
        all.push_back({x, y, std::numbers::pi_v<Long> * std::cosh(t) * x * y});
      }
      return all;
    }();
    return nodes;
  }
};

// f(x - lo, hi - x), infinite at the ends up to their inverse roots, until two results agree, and not by chance: the
// last two differed by 1e-8 at most. What is narrow beside an end is small, and seen late.
template <class F>
LocalExcess integral_of(const F& f, Long lo, Long hi, Long agreement = 1e-17L) {
  constexpr Long negligible = 1e-40L;
  const Long length = hi - lo;
  if (!(length > 0)) return {};
  const auto& nodes = LongNodes::shared();
  const auto size = [](const LocalExcess& g) { return std::fabs(g.fx) + std::fabs(g.fy) + std::fabs(g.m); };
  LocalExcess sum;
  Long absolute = 0;
  const auto add = [&](std::size_t first, std::size_t every) {
    for (std::size_t i = first; i < nodes.size(); i += every) {
      const auto& [from_lo, to_hi, weight] = nodes[i];
      if (weight < negligible) continue;
      const LocalExcess g = weight * f(length * from_lo, length * to_hi);
      sum = sum + g;
      absolute += size(g);
    }
  };
  std::size_t step = LongNodes::finest / LongNodes::coarsest;
  add(0, step);
  for (bool near = false, agree = false; step > 1 && !agree;) {
    const LocalExcess before = sum;
    add(step / 2, step);
    step /= 2;
    const Long difference = size(sum + -2 * before);
    agree = near && difference <= agreement * absolute;
    near = difference <= 1e-8L * absolute;
  }
  return length * static_cast<Long>(step) / LongNodes::finest * sum;
}

inline LocalExcess excess_at(const LongTwist& u, Long x, Long y) {
  const Long ux = u.vx - u.w * y, uy = u.vy + u.w * x, speed = std::sqrt(ux * ux + uy * uy);
  if (speed == 0) return {};
  const Long k = std::exp(-speed * speed) / speed;
  return {k * ux, k * uy, k * (x * uy - y * ux)};
}

// int_0^1 exp(-y l^2) l dl and int_0^1 exp(-y l^2) l^2 dl
inline Long ray_force(Long y) { return y > 0 ? -std::expm1(-y) / (2 * y) : 0.5L; }
inline Long ray_moment(Long y) {
  if (y > 1) return (std::sqrt(std::numbers::pi_v<Long> / y) / 2 * std::erf(std::sqrt(y)) - std::exp(-y)) / (2 * y);
  Long sum = 0, term = 1;
  for (int k = 0; k < 25; ++k) {
    sum += term / (2 * k + 3);
    term *= -y / (k + 1);
  }
  return sum;
}

// What a triangle between the pole and a piece of boundary at d = P - M contributes; `cross` is d x dP. About the pole.
inline LocalExcess ray_excess(Long dx, Long dy, Long cross, Long w) {
  const Long R2 = dx * dx + dy * dy, R = std::sqrt(R2), y = w * w * R2;
  if (R == 0) return {};
  const Long k = std::copysign(cross, w < 0 ? -cross : cross);
  return {-k * dy / R * ray_force(y), k * dx / R * ray_force(y), k * R * ray_moment(y)};
}

inline LocalExcess about_origin(LocalExcess g, Long X, Long Y) {
  g.m += X * g.fy - Y * g.fx;
  return g;
}

// Both halves of a ring from the pole's angle are alike.
inline LocalExcess ring_excess(Long a, const LongTwist& u) {
  const Long pole = std::atan2(u.vx, -u.vy) + (u.w < 0 ? std::numbers::pi_v<Long> : 0);
  const auto at = [&](Long from, Long) { return excess_at(u, a * std::cos(pole + from), a * std::sin(pole + from)); };
  const LocalExcess half = std::numbers::inv_pi_v<Long> * integral_of(at, 0, std::numbers::pi_v<Long>);
  const Long speed = std::hypot(u.vx, u.vy), ex = speed > 0 ? u.vx / speed : 1, ey = speed > 0 ? u.vy / speed : 0;
  const Long along = half.fx * ex + half.fy * ey;
  return {along * ex, along * ey, half.m};
}

// The pressure ~ (1 - x^2/a^2 - y^2/b^2)^(n - 1/2), -1/2 < n < 1/2, of a disc as a stack of rings in y = (1 - x^2)^(n + 1/2),
// 1 - y = z: its rim is smooth there.
inline LocalExcess stacked_excess(Long a, Long n, const LongTwist& u) {
  const Long level = std::hypot(u.vx, u.vy) / std::fabs(u.w * a), m = n + 0.5L;
  const auto at = [&](Long y, Long z) {
    const Long x = std::sqrt(-std::expm1((y < 0.5L ? std::log(y) : std::log1p(-z)) / m));
    return ring_excess(x * a, u);
  };
  if (level >= 1) return integral_of(at, 0, 1);
  const Long y = std::exp(m * std::log1p(-level * level)), z = -std::expm1(m * std::log1p(-level * level));
  return integral_of([&](Long from, Long to) { return at(from, z + to); }, 0, y) +
         integral_of([&](Long from, Long to) { return at(y + from, to); }, 0, z);
}

// The same pressure, n >= 0, on chords through the pole: the velocity keeps its direction there. x/a and y/b make the
// ellipse a circle; a needle's sides pass the pole where a chord lies across it.
class Chords {
 public:
  Chords(Long a, Long b, Long n, const LongTwist& u)
      : a_(a),
        b_(b),
        n_(n),
        w_(u.w),
        level_(std::hypot(u.vy / a, u.vx / b) / std::fabs(u.w)),
        beyond_((level_ - 1) * (level_ + 1)),
        inwards_(std::atan2(-u.vx / (u.w * b), u.vy / (u.w * a))) {}

  LocalExcess excess() const { return (n_ + 0.5L) / pi * (level_ < 1 ? about_inner_pole() : about_outer_pole()); }

 private:
  static constexpr Long pi = std::numbers::pi_v<Long>;
  // Half the step has twice the digits: 180 ellipses, needles of 1e6 among them, moved by less than 1e-17 when taken on
  // until 17 digits agreed.
  static constexpr Long agreement = 1e-13L;

  // In turns of the chord; the pole cuts it, and the part ahead is taken.
  LocalExcess about_inner_pole() const {
    std::vector<Long> cuts;
    for (const Long turn : {across(), across() + pi, inwards_ + pi / 2, inwards_ - pi / 2})
      cuts.push_back(turn - 2 * pi * std::floor(turn / (2 * pi)));
    std::ranges::sort(cuts);
    cuts.push_back(cuts[0] + 2 * pi);
    LocalExcess sum;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const auto at = [&](Long from, Long to) {
        const Long turn = from < to ? cuts[i] + from : cuts[i + 1] - to;
        const Long middle = level_ * std::cos(turn - inwards_), half = std::sqrt(middle * middle - beyond_);
        const Long ahead = middle > 0 ? middle + half : -beyond_ / (half - middle);
        return of_chord(turn, level_ * std::sin(turn - inwards_), half, 0, ahead, -beyond_ / ahead);
      };
      sum = sum + integral_of(at, cuts[i], cuts[i + 1], agreement);
    }
    return sum;
  }

  // In distances of the chord from the centre.
  LocalExcess about_outer_pole() const {
    std::vector<Long> cuts{-1, 1};
    for (const Long turn : {across() - inwards_, across() + pi - inwards_}) {
      const Long offset = level_ * std::sin(turn);
      if (std::cos(turn) > 0 && std::fabs(offset) < 1) cuts.push_back(offset);
    }
    std::ranges::sort(cuts);
    LocalExcess sum;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const auto at = [&](Long from, Long to) {
        const Long below = cuts[i] + 1 + from, above = 1 - cuts[i + 1] + to;
        const Long offset = below < above ? below - 1 : 1 - above;
        const Long half = std::sqrt(below * above), middle = std::sqrt(beyond_ + below * above);
        const Long turn = inwards_ + std::asin(std::clamp(offset / level_, -1.0L, 1.0L));
        return 1 / middle * of_chord(turn, offset, half, beyond_ / (middle + half), 2 * half, 0);
      };
      sum = sum + integral_of(at, cuts[i], cuts[i + 1], agreement);
    }
    return sum;
  }

  // A chord of two `half`, `offset` to the left of the centre: `length` of it from `start` off the pole, and `behind`
  // between there and the rim.
  LocalExcess of_chord(Long turn, Long offset, Long half, Long start, Long length, Long behind) const {
    const Long c = std::cos(turn), s = std::sin(turn), k = std::hypot(b_ * s, a_ * c);
    const Long lever = offset * (b_ - a_) * (b_ + a_) * s * c;
    const auto at = [&](Long from, Long to) {
      const Long r = start + from, speed = w_ * k * r;
      const Long g = std::exp((n_ - 0.5L) * std::log(to * (behind + from)) - speed * speed) * r;
      return LocalExcess{-g * b_ * s, g * a_ * c, g * (lever + (half - to) * k * k)};
    };
    return 1 / std::copysign(k, w_) * integral_of(at, 0, length, agreement);
  }

  Long across() const { return a_ > b_ ? pi / 2 : 0; }

  Long a_, b_, n_, w_, level_, beyond_, inwards_;
};

// Below n = 0 a disc, of a = b.
inline LocalExcess power_ellipse_excess(Long a, Long b, Long n, const LongTwist& u) {
  if (u.w == 0) return excess_at(u, 0, 0);  // the same everywhere
  if (n >= 0) return Chords(a, b, n, u).excess();
  return n == -0.5L ? ring_excess(a, u) : stacked_excess(a, n, u);
}

// About the pole up to three radii, beyond them on chords.
inline LocalExcess uniform_ellipse_excess(Long a, Long b, const LongTwist& u) {
  const Long w = u.w, X = -u.vy / w, Y = u.vx / w;
  if (w == 0 || std::hypot(X / a, Y / b) > 3) return power_ellipse_excess(a, b, 0.5L, u);
  const Long pi = std::numbers::pi_v<Long>, pole = std::atan2(Y / b, X / a);
  const auto at = [&](Long angle) {
    const Long c = std::cos(angle), s = std::sin(angle), dx = a * c - X, dy = b * s - Y;
    return ray_excess(dx, dy, dx * b * c + dy * a * s, w);
  };
  const LocalExcess sum = integral_of([&](Long from, Long) { return at(pole + from); }, 0, pi) +
                          integral_of([&](Long from, Long) { return at(pole - from); }, 0, pi);
  return about_origin(1 / (pi * a * b) * sum, X, Y);
}

// A uniform line along x, in two pieces from the foot of the pole.
inline LocalExcess line_excess(Long length, const LongTwist& u) {
  const Long foot = u.w == 0 ? 0 : std::clamp(-u.vy / u.w, -length / 2, length / 2);
  return 1 / length *
         (integral_of([&](Long, Long to_foot) { return excess_at(u, foot - to_foot, 0); }, -length / 2, foot) +
          integral_of([&](Long from_foot, Long) { return excess_at(u, foot + from_foot, 0); }, foot, length / 2));
}

// Triangles between the pole and the edges within two and a half radii, beyond them between the first vertex and the
// edges. The pole, the area and twice the triangles in 113 bits: along a needle they cancel by its aspect.
inline LocalExcess polygon_excess(const std::vector<std::vector<kernels::Vertex>>& rings, const PressureMoments& s,
                                  const LongTwist& u) {
  Long radius = 0;
  Quad twice_area = 0;
  const auto& first = rings[0][0];
  for (const auto& p : rings[0]) radius = std::max(radius, std::hypot(Long(p.x) - s.x, Long(p.y) - s.y));
  const Long w = u.w;
  const bool near = std::hypot(-u.vy - w * s.x, u.vx - w * s.y) < 2.5L * radius * std::fabs(w);
  const Quad X = near ? -Quad(u.vy) / Quad(w) : Quad(first.x), Y = near ? Quad(u.vx) / Quad(w) : Quad(first.y);
  LocalExcess sum;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const Quad twice_triangle = (p.x - X) * (Quad(q.y) - p.y) - (p.y - Y) * (Quad(q.x) - p.x);
      twice_area += twice_triangle;
      const Long px(p.x - X), py(p.y - Y), ex = Long(q.x) - p.x, ey = Long(q.y) - p.y, cross(twice_triangle);
      if (cross == 0) continue;
      if (near) {
        const Long foot = std::clamp(-(px * ex + py * ey) / (ex * ex + ey * ey), 0.0L, 1.0L);
        const auto at = [&](Long t) { return ray_excess(px + t * ex, py + t * ey, cross, w); };
        sum = sum + integral_of([&](Long, Long to_foot) { return at(foot - to_foot); }, 0, foot) +
              integral_of([&](Long from_foot, Long) { return at(foot + from_foot); }, foot, 1);
      } else {
        sum =
            sum + integral_of(
                      [&](Long t, Long) {
                        return integral_of(
                            [&](Long l, Long) {
                              return cross * l * excess_at(u, first.x + l * (px + t * ex), first.y + l * (py + t * ey));
                            },
                            0, 1);
                      },
                      0, 1);
      }
    }
  }
  const LocalExcess mean = 2 / Long(twice_area) * sum;
  return near ? about_origin(mean, Long(X), Long(Y)) : mean;
}

}  // namespace patchgrip::friction
