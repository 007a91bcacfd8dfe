#include <patchgrip/friction/limit_surface/quartic_form.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace patchgrip::friction {
namespace {

// Positive definite by more than rounding: pivots of the elimination.
bool is_positive(const Hessian& h) {
  constexpr double rounding =
      1000 * 0x1p-53;  // of a Hessian and its elimination: some hundred units, and ten times that
  const double least = rounding * (std::fabs(h.xx) + std::fabs(h.yy) + std::fabs(h.ww));
  if (!(h.xx > least)) return false;
  const double yy = h.yy - h.xy * h.xy / h.xx, yw = h.yw - h.xy * h.xw / h.xx, ww = h.ww - h.xw * h.xw / h.xx;
  return yy > least && ww - yw * yw / yy > least;
}

using Cone = std::array<Wrench, 3>;

Wrench middle(const Wrench& p, const Wrench& q) {
  const Wrench sum{p.fx + q.fx, p.fy + q.fy, p.m + q.m};
  const double size = std::sqrt(sum.fx * sum.fx + sum.fy * sum.fy + sum.m * sum.m);
  return {sum.fx / size, sum.fy / size, sum.m / size};
}

bool corners_are_positive(const QuarticForm& q, const Cone& t) {
  return std::all_of(t.begin(), t.end(), [&](const Wrench& s) { return is_positive(q.hessian(s, s)); });
}

bool edges_are_positive(const QuarticForm& q, const Cone& t) {
  return is_positive(q.hessian(t[0], t[1])) && is_positive(q.hessian(t[1], t[2])) && is_positive(q.hessian(t[2], t[0]));
}

}  // namespace

QuarticForm::Coefficients QuarticForm::monomials(const Wrench& t) noexcept {
  const auto [x, y, z] = t;
  return {x * x * x * x, x * x * x * y, x * x * x * z, x * x * y * y, x * x * y * z,
          x * x * z * z, x * y * y * y, x * y * y * z, x * y * z * z, x * z * z * z,
          y * y * y * y, y * y * y * z, y * y * z * z, y * z * z * z, z * z * z * z};
}

Hessian QuarticForm::hessian(const Wrench& s, const Wrench& t) const noexcept {
  const double xx = s.fx * t.fx, yy = s.fy * t.fy, zz = s.m * t.m;
  const double xy = (s.fx * t.fy + s.fy * t.fx) / 2;
  const double xz = (s.fx * t.m + s.m * t.fx) / 2;
  const double yz = (s.fy * t.m + s.m * t.fy) / 2;
  return {12 * c[0] * xx + 6 * (c[1] * xy + c[2] * xz) + 2 * (c[3] * yy + c[4] * yz + c[5] * zz),
          3 * (c[1] * xx + c[6] * yy) + 4 * c[3] * xy + 2 * (c[4] * xz + c[7] * yz) + c[8] * zz,
          3 * (c[2] * xx + c[9] * zz) + 4 * c[5] * xz + 2 * (c[4] * xy + c[8] * yz) + c[7] * yy,
          12 * c[10] * yy + 6 * (c[6] * xy + c[11] * yz) + 2 * (c[3] * xx + c[7] * xz + c[12] * zz),
          3 * (c[11] * yy + c[13] * zz) + 4 * c[12] * yz + 2 * (c[7] * xy + c[8] * xz) + c[4] * xx,
          12 * c[14] * zz + 6 * (c[9] * xz + c[13] * yz) + 2 * (c[5] * xx + c[8] * xy + c[12] * yy)};
}

Twist QuarticForm::gradient(const Wrench& t) const noexcept {
  const Hessian h = hessian(t, t);
  return {(h.xx * t.fx + h.xy * t.fy + h.xw * t.m) / 3, (h.xy * t.fx + h.yy * t.fy + h.yw * t.m) / 3,
          (h.xw * t.fx + h.yw * t.fy + h.ww * t.m) / 3};
}

bool is_certainly_convex(const QuarticForm& q) {
  constexpr std::size_t most_cones = 100000;
  std::vector<Cone> cones;  // q is even: half of all directions
  const std::array<Wrench, 4> equator{Wrench{1, 0, 0}, Wrench{0, 1, 0}, Wrench{-1, 0, 0}, Wrench{0, -1, 0}};
  for (std::size_t k = 0; k < 4; ++k) cones.push_back({equator[k], equator[(k + 1) % 4], Wrench{0, 0, 1}});
  for (std::size_t seen = 0; !cones.empty(); ++seen) {
    const Cone t = cones.back();
    cones.pop_back();
    if (!corners_are_positive(q, t) || seen == most_cones) return false;
    if (edges_are_positive(q, t)) continue;
    const Wrench a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
    for (const Cone& part : {Cone{t[0], a, c}, Cone{a, t[1], b}, Cone{c, b, t[2]}, Cone{a, b, c}}) {
      cones.push_back(part);
    }
  }
  return true;
}

}  // namespace patchgrip::friction
