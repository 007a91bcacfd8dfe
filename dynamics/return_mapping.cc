#include <patchgrip/dynamics/return_mapping.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace patchgrip::dynamics {
namespace {

using friction::BoundedWrench;
using friction::Hessian;
using friction::Twist;
using friction::Wrench;

constexpr double unit = 0x1p-53;

Vector3 vector(const Wrench& t) { return {t.fx, t.fy, t.m}; }
Twist twist(const Vector3& v) { return {v[0], v[1], v[2]}; }

Matrix3 matrix(const Hessian& h) {
  Matrix3 H;
  H << h.xx, h.xy, h.xw, h.xy, h.yy, h.yw, h.xw, h.yw, h.ww;
  return H;
}

class Search {
 public:
  Search(const friction::PatchView& patch, const Wrench& trial, double limit, const BristleMetric& metric)
      : patch_(patch), metric_(metric), L_(limit), trial_(vector(trial)), y_(to_sphere(trial_)) {}

  // psi at the direction of n.
  double at(const Vector3& n) { return at_unit((metric_.root() * n).normalized()); }

  // From where psi > 0.
  Returned climb() {
    double gap = across(y_ - L_ * g_).norm();
    for (int step = 0; step < max_steps && gap > rounding(); ++step) {
      Hessian h;
      if (!patch_.hessian(patch_.patch, twist(n_), h) || !matrix(h).allFinite()) {
        stiffness_ = std::numeric_limits<double>::infinity();
        break;
      }
      const Matrix3 A = L_ * (metric_.inverse_root().transpose() * matrix(h) * metric_.inverse_root());
      stiffness_ = A.trace();
      // nu itself is what neither A nor the gap sees; a curvature for it keeps the matrix regular.
      const Matrix3 B = A + psi_ * Matrix3::Identity() + (stiffness_ + psi_) * nu_ * nu_.transpose();
      const Vector3 d = across(B.ldlt().solve(across(y_ - L_ * g_)));
      const double before = gap;
      if (!move(d, gap)) break;
      gap = across(y_ - L_ * g_).norm();
      if (d.norm() < last_step && !(gap < before / 2)) break;
    }
    return result(gap);
  }

  int evaluations() const { return evaluations_; }

 private:
  static constexpr int max_steps = 60;
  static constexpr int max_halvings = 40;
  static constexpr double last_step = 1e-8;  // after it only rounding is left

  Vector3 to_sphere(const Vector3& t) const { return metric_.inverse_root().transpose() * t; }
  Vector3 across(const Vector3& q) const { return q - nu_ * nu_.dot(q); }
  // Of the gap: also by that of nu.
  double rounding() const {
    return 2 * unit * (y_.norm() + L_ * g_.norm() + (std::isinf(stiffness_) ? 0 : stiffness_));
  }

  double at_unit(const Vector3& nu) {
    nu_ = nu;
    n_ = metric_.inverse_root() * nu;
    gradient_ = patch_.gradient(patch_.patch, twist(n_));
    ++evaluations_;
    g_ = to_sphere(vector(gradient_.value));
    psi_ = y_.dot(nu) - L_ * g_.dot(nu);
    return psi_;
  }

  // Along d as far as psi grows, or as the gap shrinks where psi is down to rounding.
  bool move(const Vector3& d, double gap) {
    const Search before = *this;
    const double slack = 4 * rounding();
    // A step that gains less than rounding is tried once.
    const int tries = gap * d.norm() < slack ? 1 : max_halvings;
    double share = 1;
    for (int i = 0; i < tries; ++i, share /= 2) {
      at_unit((before.nu_ + share * d).normalized());
      if (psi_ > before.psi_) return true;
      if (psi_ > before.psi_ - slack && across(y_ - L_ * g_).norm() < 0.9 * gap) return true;
    }
    const int count = evaluations_;
    restore(before);
    evaluations_ = count;
    return false;
  }

  void restore(const Search& s) { nu_ = s.nu_, n_ = s.n_, g_ = s.g_, gradient_ = s.gradient_, psi_ = s.psi_; }

  // s can be off by the gap on the sphere, as far as the limit surface is flat there.
  Returned result(double gap) const {
    const double psi = std::max(psi_, 0.);
    const double share = std::isinf(stiffness_) ? 1 : stiffness_ / (stiffness_ + psi);
    const double off = 2 * share * (gap + rounding());
    const Wrench& g = gradient_.value;
    const double force = L_ * std::hypot(g.fx, g.fy), moment = L_ * std::fabs(g.m);
    const Matrix3& K = metric_.stiffness();
    return {{{L_ * g.fx, L_ * g.fy, L_ * g.m},
             L_ * gradient_.force_error + unit * force + off * std::sqrt(K(0, 0) + K(1, 1)),
             L_ * gradient_.moment_error + unit * moment + off * std::sqrt(K(2, 2))},
            twist(psi * n_),
            true,
            evaluations_};
  }

  const friction::PatchView& patch_;
  const BristleMetric& metric_;
  double L_;
  Vector3 trial_, y_;  // R^-T s*
  Vector3 nu_, n_, g_;
  BoundedWrench gradient_;
  double psi_ = 0;
  double stiffness_ = 0;  // trace of L R^-T H R^-1, one step ago
  int evaluations_ = 0;
};

// Slip of the closest point of the ellipsoid |f|^2 + (m / e)^2 = L^2 about the centroid: (K + tau Q) u = s* with
// tau = L / sqrt(u . Q u), by Newton's method for that root.
Vector3 ellipsoid_slip(const ReturnFrame& frame, const Vector3& trial, double limit, const Matrix3& K) {
  const double e2 = frame.spin_scale * frame.spin_scale;
  Matrix3 A;  // twist at the centroid
  A << 1, 0, -frame.y, 0, 1, frame.x, 0, 0, 1;
  const Matrix3 Q = A.transpose() * Vector3(1, 1, e2).asDiagonal() * A;
  Vector3 u = K.ldlt().solve(trial);
  for (int i = 0; i < 4; ++i) {
    // As a function of size = sqrt(u . Q u) the slip's own size is u(tau = L / size).
    const double size = std::sqrt(u.dot(Q * u));
    if (!(size > 0)) break;
    const Eigen::LDLT<Matrix3> solver(K + limit / size * Q);
    const Vector3 next = solver.solve(trial);
    const double found = std::sqrt(next.dot(Q * next));
    if (!(found > 0)) break;
    // d found / d size, and one step of Newton's method for found = size, kept positive.
    const Vector3 turn = limit / (size * size) * solver.solve(Q * next);
    const double slope = next.dot(Q * turn) / found;
    const double to = size + (found - size) / std::max(1 - slope, 0x1p-20);
    u = next * (std::max(to, 0.1 * found) / found);
  }
  return u;
}

}  // namespace

ReturnFrame::ReturnFrame(const friction::PatchView& patch, const friction::PressureFrame& frame)
    : x(frame.x), y(frame.y) {
  const Wrench g = patch.gradient(patch.patch, friction::twist_about({x, y}, 1)).value;
  spin_scale = g.m - (x * g.fy - y * g.fx);
}

Returned return_mapping(const friction::PatchView& patch, const friction::PressureFrame& pressure,
                        const ReturnFrame& frame, const friction::GaugeSettings& settings, const Wrench& trial,
                        double limit, const BristleMetric& metric) noexcept {
  const Vector3 t = vector(trial);
  if (!t.allFinite() || !(limit >= 0 && limit < std::numeric_limits<double>::infinity())) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), none = std::numeric_limits<double>::infinity();
    return {{{nan, nan, nan}, none, none}, {nan, nan, nan}, true, 0};
  }
  const auto all_slips = [&] {
    const Vector3 u = metric.inverse_root() * (metric.inverse_root().transpose() * t);
    return Returned{{}, twist(u), true, 0};
  };
  if (limit == 0) return all_slips();
  const friction::Vector centred = pressure.about_centroid(trial);
  if (std::hypot(centred[0], centred[1]) + std::fabs(centred[2]) * pressure.length / pressure.least_moment <= limit)
    return {{trial, 0, 0}, {}, false, 0};

  Search search(patch, trial, limit, metric);
  const Vector3 n = ellipsoid_slip(frame, t, limit, metric.stiffness());
  if (n.allFinite() && n.norm() > 0 && search.at(n) > 0) return search.climb();
  const friction::Gauge gauge = friction::maximise(patch, pressure, trial, settings);
  if (gauge.lower > limit && search.at({gauge.twist.vx, gauge.twist.vy, gauge.twist.w}) > 0) {
    Returned found = search.climb();
    found.evaluations += gauge.evaluations;
    return found;
  }
  // Inside, or outside by less than the gauge tells: as far as that the trial is its own closest point.
  const double excess = std::max(0., gauge.upper / limit - 1);
  Returned result;
  result.wrench = {trial, excess * std::hypot(trial.fx, trial.fy), excess * std::fabs(trial.m)};
  result.evaluations = search.evaluations() + gauge.evaluations;
  return result;
}

}  // namespace patchgrip::dynamics
