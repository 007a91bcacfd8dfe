#include <patchgrip/friction/limit_surface/quartic_gauge.h>

#include <algorithm>
#include <limits>

#include <Eigen/Cholesky>

#include <patchgrip/friction/limit_surface/slips.h>
#include <patchgrip/friction/limit_surface/unit_fit.h>

namespace patchgrip::friction {
namespace {

constexpr double margin = 0.01;  // q - margin e^4 is convex, and so >= 0

const QuarticForm e4{{1, 0, 0, 2, 0, 2, 0, 0, 0, 0, 1, 0, 2, 0, 1}};  // (x^2 + y^2 + z^2)^2

QuarticForm mixed(double part, const QuarticForm& p, double rest, const QuarticForm& q) {
  QuarticForm result{};
  for (std::size_t i = 0; i < q.c.size(); ++i) result.c[i] = part * p.c[i] + rest * q.c[i];
  return result;
}

bool is_convex_enough(const QuarticForm& q) { return is_certainly_convex(mixed(1, q, -margin, e4)); }

Eigen::Matrix3d matrix(const Hessian& h) {
  Eigen::Matrix3d H;
  H << h.xx, h.xy, h.xw, h.xy, h.yy, h.yw, h.xw, h.yw, h.ww;
  return H;
}

// The Hessian in the direction of t, linear in the coefficients, exceeds twice the margin.
PositiveMatrix convex_at(const Wrench& t) {
  PositiveMatrix result;
  for (std::size_t j = 0; j < e4.c.size(); ++j) {
    QuarticForm unit{};
    unit.c[j] = 1;
    result.factor.push_back(matrix(unit.hessian(t, t)));
  }
  result.constant = 2 * margin * matrix(e4.hessian(t, t));
  return result;
}

}  // namespace

QuarticGauge::QuarticGauge(const CentredFrame& frame, const SupportFunction& D, Fit fit) : frame_(frame) {
  const std::vector<Slip> slips = spread_slips(D, 1000);
  Eigen::MatrixXd rows(slips.size(), e4.c.size());
  std::vector<PositiveMatrix> conditions;
  Eigen::Index i = 0;
  for (const auto& [v, t] : slips) {
    const auto row = QuarticForm::monomials(t);
    std::copy(row.begin(), row.end(), rows.row(i++).begin());
    if (i % 2 == 0) conditions.push_back(convex_at(t));
  }
  const Eigen::Map<const Eigen::Matrix<double, 15, 1>> start(e4.c.data());
  const auto form = [](const Eigen::VectorXd& c) {
    QuarticForm q{};
    std::copy(c.begin(), c.end(), q.c.begin());
    return q;
  };
  QuarticForm fitted = form(fit == Fit::even ? even_unit_fit(rows, conditions, start) : unit_fit(rows));
  if (fit == Fit::least_squares && !is_convex_enough(fitted)) fitted = form(unit_fit(rows, conditions, start));
  q_ = fitted;
  for (double way = 1e-3; !is_convex_enough(q_); way *= 2) q_ = way < 1 ? mixed(way, e4, 1 - way, fitted) : e4;
  sides_ = gauge_sides([this](const Twist& v) { return support(v); }, D);
}

Gauge QuarticGauge::gauge(const Wrench& t) const noexcept {
  const auto value = [this](const Wrench& scaled) { return std::sqrt(std::sqrt(q_(frame_.local(scaled)))); };
  const auto twist = [&](const Wrench& scaled) {
    const double g = value(scaled);
    const Twist n = q_.gradient(frame_.local(scaled));
    const double k = 1 / (4 * g * g * g);
    return frame_.global(Twist{k * n.vx, k * n.vy, k * n.w});
  };
  return bracketed_gauge(t, frame_, sides_, value, twist);
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
    const Eigen::Matrix3d H = matrix(q_.hessian(wrench(t), wrench(t)));
    const Vector residual = v - Vector{n.vx, n.vy, n.w};
    const Vector step = H.ldlt().solve(residual);
    const double decrease = residual.dot(step);
    if (decrease < unit * unit) break;
    double length = 1;
    while (length > 1e-3 && objective(t + length * step) > least - 0.25 * length * decrease + 4 * unit) length /= 2;
    t += length * step;
    least = objective(t);
  }
  // v = lambda n + r, n normal to the body at t: lambda <= h(v) <= lambda + h(r). The body lies in e <= margin^(-1/4).
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
