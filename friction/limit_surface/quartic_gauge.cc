#include <patchgrip/friction/limit_surface/quartic_gauge.h>

#include <algorithm>
#include <limits>

#include <Eigen/Cholesky>

#include <patchgrip/friction/limit_surface/unit_fit.h>

namespace patchgrip::friction {
namespace {

constexpr double margin = 0.01;  // q - margin e^4 is convex, and so >= 0

QuarticForm mixed(double part, const QuarticForm& p, double rest, const QuarticForm& q) {
  QuarticForm result{};
  for (std::size_t i = 0; i < q.c.size(); ++i) result.c[i] = part * p.c[i] + rest * q.c[i];
  return result;
}

// (xx x^2 + 2 xy x y + ...)^2
QuarticForm square(const Eigen::VectorXd& a) {
  const double xx = a[0], xy = a[1], xz = a[2], yy = a[3], yz = a[4], zz = a[5];
  return {{xx * xx, 4 * xx * xy, 4 * xx * xz, 2 * xx * yy + 4 * xy * xy, 4 * xx * yz + 8 * xy * xz,
           2 * xx * zz + 4 * xz * xz, 4 * xy * yy, 4 * xz * yy + 8 * xy * yz, 4 * xy * zz + 8 * xz * yz, 4 * xz * zz,
           yy * yy, 4 * yy * yz, 2 * yy * zz + 4 * yz * yz, 4 * yz * zz, zz * zz}};
}

const QuarticForm e4 = square(Eigen::Matrix<double, 6, 1>{1, 0, 0, 1, 0, 1});

bool is_convex_enough(const QuarticForm& q) { return is_certainly_convex(mixed(1, q, -margin, e4)); }

}  // namespace

QuarticGauge::QuarticGauge(const CentredFrame& frame, const SupportFunction& D, const std::vector<Wrench>& boundary,
                           Fit fit)
    : frame_(frame) {
  constexpr int steps = 200;
  Eigen::MatrixXd rows(boundary.size(), 15), squares(boundary.size(), 6);
  Eigen::Index i = 0;
  for (const Wrench& t : boundary) {
    const auto row = QuarticForm::monomials(t);
    std::copy(row.begin(), row.end(), rows.row(i).begin());
    squares.row(i++) << t.fx * t.fx, 2 * t.fx * t.fy, 2 * t.fx * t.m, t.fy * t.fy, 2 * t.fy * t.m, t.m * t.m;
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(rows.rows());
  const Eigen::VectorXd c = fit == Fit::even ? even_unit_fit(rows, steps) : unit_fit(rows, ones);
  QuarticForm free{};
  std::copy(c.begin(), c.end(), free.c.begin());

  q_ = free;
  if (!is_convex_enough(free)) {
    const QuarticForm ellipsoid = square(unit_fit(squares, ones));
    double convex = 1, not_convex = 0;
    while (convex - not_convex > 1e-4) {
      const double part = (convex + not_convex) / 2;
      (is_convex_enough(mixed(part, ellipsoid, 1 - part, free)) ? convex : not_convex) = part;
    }
    way_given_ = convex;
    q_ = mixed(convex, ellipsoid, 1 - convex, free);
  }
  sides_ = gauge_sides([this](const Twist& v) { return support(v); }, D);
}

Twist QuarticGauge::twist(const Wrench& t) const noexcept {
  const Wrench s = frame_.local(t);
  const double g = std::sqrt(std::sqrt(q_(s)));
  if (g == 0) return {};
  const Twist n = q_.gradient(s);
  const double k = 1 / (4 * g * g * g);
  return frame_.global(Twist{k * n.vx, k * n.vy, k * n.w});
}

// Minimises q(t) - t . v, convex: there grad q = v, and t . v = 4 q.
SupportValue QuarticGauge::support(const Twist& local) const noexcept {
  using Vector = Eigen::Vector3d;
  constexpr double unit = std::numeric_limits<double>::epsilon();
  const Vector v0{local.vx, local.vy, local.w};
  const double size = v0.norm();
  if (!(size > 0)) return {};
  const Vector v = v0 / size;
  const auto wrench = [](const Vector& t) { return Wrench{t[0], t[1], t[2]}; };
  const auto objective = [&](const Vector& t) { return q_(wrench(t)) - t.dot(v); };
  Vector t = 0.63 * v;  // of e^4
  double least = objective(t);
  for (int k = 0; k < 100; ++k) {
    const Twist n = q_.gradient(wrench(t));
    const Hessian h = q_.hessian(wrench(t), wrench(t));
    Eigen::Matrix3d H;
    H << h.xx, h.xy, h.xw, h.xy, h.yy, h.yw, h.xw, h.yw, h.ww;
    const Vector residual = v - Vector{n.vx, n.vy, n.w};
    const Vector step = H.ldlt().solve(residual);
    const double decrease = residual.dot(step);
    if (decrease < unit * unit) break;
    double length = 1;
    while (length > 1e-3 && objective(t + length * step) > least - 0.25 * length * decrease + 4 * unit) length /= 2;
    t += length * step;
    least = objective(t);
  }
  // v = lambda n + r, n normal to the body at t: lambda <= h(v) <= lambda + h(r), and the body lies in e <= 1/margin^(1/4).
  const double g = std::sqrt(std::sqrt(q_(wrench(t))));
  const Twist n = q_.gradient(wrench(t));
  const Vector normal = Vector{n.vx, n.vy, n.w} / (4 * g * g * g);
  const double value = t.dot(v) / g;
  const double rest = (v - value * normal).norm() / std::sqrt(std::sqrt(margin));
  return {size * value, wrench(t / g), rest / value + 64 * unit};
}

double QuarticGauge::dissipation(const Twist& v) const noexcept { return support(frame_.local(v)).value; }

Wrench QuarticGauge::gradient(const Twist& v) const noexcept { return frame_.global(support(frame_.local(v)).wrench); }

QuarticGauge QuarticGauge::scaled(double factor) const {
  QuarticGauge result = *this;
  const double fourth = factor * factor * factor * factor;
  for (double& coefficient : result.q_.c) coefficient *= fourth;
  result.sides_ = sides_.scaled(factor);
  return result;
}

}  // namespace patchgrip::friction
