#include <patchgrip/friction/limit_surface/ellipsoid_gauge.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <patchgrip/friction/limit_surface/enclosing_ellipsoid.h>
#include <patchgrip/friction/limit_surface/slips.h>
#include <patchgrip/friction/limit_surface/unit_fit.h>

namespace patchgrip::friction {
namespace {

using Symmetric = std::array<double, 6>;

constexpr std::size_t samples = 1000;

// x . A x = row . (upper triangle of A)
Eigen::Matrix<double, 1, 6> monomials(double x, double y, double z) {
  return {x * x, 2 * x * y, 2 * x * z, y * y, 2 * y * z, z * z};
}

Eigen::Matrix3d matrix(const Symmetric& a) {
  Eigen::Matrix3d A;
  A << a[0], a[1], a[2], a[1], a[3], a[4], a[2], a[4], a[5];
  return A;
}

std::array<double, 6> root_of(const char* shape, const Eigen::Matrix3d& A) {
  const Eigen::LLT<Eigen::Matrix3d> factors(A);
  if (factors.info() != Eigen::Success) {
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(A).eigenvalues()[0];
    throw std::domain_error(std::string(shape) + ": the least eigenvalue of the fitted quadric = " +
                            std::to_string(least) + " must be positive, or it is no ellipsoid");
  }
  const Eigen::Matrix3d U = factors.matrixU();
  return {U(0, 0), U(0, 1), U(0, 2), U(1, 1), U(1, 2), U(2, 2)};
}

Symmetric entries(const Eigen::VectorXd& x) { return {x[0], x[1], x[2], x[3], x[4], x[5]}; }

}  // namespace

EllipsoidGauge::EllipsoidGauge(const CentredFrame& frame, const SupportFunction& D, Shape shape)
    : frame_(frame), U_(shape(D)) {
  sides_ = gauge_sides([this](const Twist& v) { return support(v); }, D);
  if (shape == inner_shape) *this = safe();
  if (shape == enclosing_shape) *this = outer();
}

EllipsoidGauge::Root EllipsoidGauge::axis_shape(const SupportFunction&) { return {1, 0, 0, 1, 0, 1}; }

EllipsoidGauge::Root EllipsoidGauge::least_squares_shape(const SupportFunction& D) {
  const std::vector<Slip> slips = spread_slips(D, samples);
  Eigen::MatrixXd rows(slips.size(), 6);
  Eigen::Index i = 0;
  for (const auto& [v, t] : slips) rows.row(i++) = monomials(t.fx, t.fy, t.m);
  return root_of("least_squares", matrix(entries(unit_fit(rows))));
}

// v . A^-1 v = D^2 to the least largest relative error: of the ellipsoid's own D, and so of its gauge.
EllipsoidGauge::Root EllipsoidGauge::even_shape(const SupportFunction& D) {
  const std::vector<Slip> slips = spread_slips(D, samples);
  Eigen::MatrixXd rows(slips.size(), 6);
  Eigen::Index i = 0;
  for (const auto& [v, t] : slips) rows.row(i++) = monomials(v.vx, v.vy, v.w);
  const Eigen::Matrix<double, 6, 1> ball{1, 0, 0, 1, 0, 1};
  return root_of("even", matrix(entries(even_unit_fit(rows, {}, ball))).inverse());
}

// {v : v . A^-1 v <= 1} of the least volume about the surface polar to the limit surface.
EllipsoidGauge::Root EllipsoidGauge::inner_shape(const SupportFunction& D) {
  std::vector<std::array<double, 3>> points;
  for (const auto& [v, t] : spread_slips(D, samples)) points.push_back({v.vx, v.vy, v.w});
  return root_of("inner", matrix(enclosing_ellipsoid(points, 1e-3)).inverse());
}

EllipsoidGauge::Root EllipsoidGauge::enclosing_shape(const SupportFunction& D) {
  std::vector<std::array<double, 3>> points;
  for (const auto& [v, t] : spread_slips(D, samples)) points.push_back({t.fx, t.fy, t.m});
  return root_of("enclosing", matrix(enclosing_ellipsoid(points, 1e-3)));
}

Gauge EllipsoidGauge::gauge(const Wrench& t) const noexcept {
  const auto value = [this](const Wrench& scaled) { return std::sqrt(squared(scaled)); };
  const auto twist = [this](const Wrench& scaled) {
    const auto [x, y, z] = root_times(frame_.local(scaled));
    const double g = std::sqrt(x * x + y * y + z * z);
    return frame_.global(Twist{U_[0] * x / g, (U_[1] * x + U_[3] * y) / g, (U_[2] * x + U_[4] * y + U_[5] * z) / g});
  };
  return bracketed_gauge(t, frame_, sides_, value, twist);
}

Twist EllipsoidGauge::inverse_root_times(const Twist& v) const noexcept {
  const double x = v.vx / U_[0];
  const double y = (v.vy - U_[1] * x) / U_[3];
  return {x, y, (v.w - U_[2] * x - U_[4] * y) / U_[5]};
}

SupportValue EllipsoidGauge::support(const Twist& local) const noexcept {
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  const Twist s = inverse_root_times(local);
  const double D = std::sqrt(s.vx * s.vx + s.vy * s.vy + s.w * s.w);
  if (D == 0) return {};
  const double m = s.w / U_[5];
  const double fy = (s.vy - U_[4] * m) / U_[3];
  const double fx = (s.vx - U_[1] * fy - U_[2] * m) / U_[0];
  return {D, {fx / D, fy / D, m / D}, rounding};
}

double EllipsoidGauge::dissipation(const Twist& v) const noexcept { return support(frame_.local(v)).value; }

Wrench EllipsoidGauge::gradient(const Twist& v) const noexcept {
  return frame_.global(support(frame_.local(v)).wrench);
}

EllipsoidGauge EllipsoidGauge::scaled(double factor) const {
  EllipsoidGauge result = *this;
  for (double& entry : result.U_) entry *= factor;
  result.sides_ = sides_.scaled(factor);
  return result;
}

}  // namespace patchgrip::friction
