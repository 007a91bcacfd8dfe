#include <patchgrip/grasp/quadratic_grip.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace patchgrip::grasp {
namespace {

constexpr double unit = 0x1p-53;

// Values tell an optimum to half of the digits, slopes to nearly all.
constexpr double value_digits = 1e-9;

constexpr int most_halvings = 20;
constexpr int most_idle = 8;  // steps in a row that improve neither balance nor bound

double square(double x) { return x * x; }

}  // namespace

QuadraticGrip::QuadraticGrip(const ScaledGrasp& grasp) : grasp_(&grasp), forces_(grasp.parts().size()) {
  // Seldom written to.
  slips_.reserve(grasp.parts().size());
  hessians_.reserve(grasp.parts().size());
}

QuadraticGrip::Response QuadraticGrip::normal_response(double phi) const noexcept {
  Response r;
  if (!(phi > 0)) return r;
  r.resistance = phi;
  r.h = phi * phi / 4;
  r.gradient[0] = phi / 2;
  r.hessian(0, 0) = 0.5;
  return r;
}

// A point with or without a spin contact beside it: D depends on p = |(v_u, v_v)| and q = |v_w| alone, and v is parallel
// to d in both. Where both govern, p = e q: the kink of the linear model.
QuadraticGrip::Response QuadraticGrip::round_response(const Element& point, const Element* spin, double phi,
                                                      const Vector3& d) const noexcept {
  const double mu = point.mu(), eps = weights_.epsilon;
  const double e = spin != nullptr ? spin->moment_length() : 0;
  const double k2 = square(weights_.length);
  const double pd = std::hypot(d[0], d[1]);
  const double qd = spin != nullptr ? std::fabs(d[2]) : 0;
  Response r;
  r.resistance = phi + mu * std::max(pd, e * qd);
  if (!(r.resistance > 0)) return r;
  // m = max(p, e q) and its change with (phi, pd, qd); pd - p and qd - q, small beside pd and qd, without cancellation.
  double m = 0, from_pd = pd, from_qd = qd;
  Vector3 dm = Vector3::Zero(), dp(0, 1, 0), dq(0, 0, 1);
  const double force_pivot = 1 + eps * mu * mu;
  const double moment_pivot = k2 + eps * square(mu * e);
  const double p_alone = (pd - eps * mu * phi) / force_pivot;
  const double q_alone = spin != nullptr ? (k2 * qd - eps * mu * e * phi) / moment_pivot : 0;
  if (p_alone > 0 && p_alone >= e * qd) {
    m = p_alone;
    dm = dp = Vector3(-eps * mu, 1, 0) / force_pivot;
    from_pd = eps * mu * (phi + mu * pd) / force_pivot;
    from_qd = 0;
  } else if (q_alone > 0 && e * q_alone >= pd) {
    m = e * q_alone;
    dq = Vector3(-eps * mu * e, 0, k2) / moment_pivot;
    dm = e * dq;
    from_pd = 0;
    from_qd = eps * mu * e * (phi + mu * e * qd) / moment_pivot;
  } else {
    const double both = spin != nullptr ? k2 / e : 0;
    const double pivot = force_pivot + (spin != nullptr ? both / e : 0);
    m = (pd + both * qd - eps * mu * phi) / pivot;
    if (m > 0) {
      dm = Vector3(-eps * mu, 1, both) / pivot;
      from_pd = (eps * mu * (phi + mu * pd) + (spin != nullptr ? both / e : 0) * (pd - e * qd)) / pivot;
      from_qd = spin != nullptr ? (eps * mu * (phi + mu * e * qd) + e * qd - pd) / (e * pivot) : 0;
    } else {
      m = 0;
    }
    dp = dm;
    dq = spin != nullptr ? Vector3(dm / e) : Vector3::Zero();
  }
  const double F = (phi + mu * m) / 2;
  const double tp = from_pd / (2 * eps), tq = k2 * from_qd / (2 * eps);  // sizes of -R and -R_M
  r.h = F * F + eps * (tp * tp + (spin != nullptr ? tq * tq / k2 : 0));
  r.slips = m > 0;
  const Vector3 along = pd > 0 ? Vector3(d[0] / pd, d[1] / pd, 0) : Vector3::Zero();
  const Vector3 about = spin != nullptr ? Vector3(0, 0, d[2] < 0 ? -1 : 1) : Vector3::Zero();
  r.gradient << F, tp * along + tq * about;
  // Columns: changes with phi, pd and qd.
  const Vector3 dF = (Vector3(1, 0, 0) + mu * dm) / 2;
  const Vector3 dtp = (Vector3(0, 1, 0) - dp) / (2 * eps);
  const Vector3 dtq = k2 * (Vector3(0, 0, 1) - dq) / (2 * eps);
  Eigen::Matrix<double, 4, 3> change;
  change << dF.transpose(), along * dtp.transpose() + about * dtq.transpose();
  r.hessian.col(0) = change.col(0);
  r.hessian.rightCols<3>() = change.col(1) * along.transpose() + change.col(2) * about.transpose();
  if (pd > 0) {
    const Vector3 across(-along[1], along[0], 0);
    r.hessian.bottomRightCorner<3, 3>() += (tp / pd) * across * across.transpose();
  } else {
    r.hessian(1, 1) = r.hessian(2, 2) = dtp[1];
  }
  return r;
}

// Newton's method in v, from d or from where it ended last; the kink v = 0 is a case of its own.
QuadraticGrip::Response QuadraticGrip::smooth_response(const Element& element, double phi, const Vector3& d,
                                                       Vector3& v) const noexcept {
  const double mu = element.mu();
  const Vector3 metric = Vector3(1, 1, square(weights_.length)) / weights_.epsilon;
  Response r;
  r.resistance = phi + mu * element.dissipation(d).value;
  if (!(r.resistance > 0)) {
    v = d;
    return r;
  }
  const Vector3 stuck = metric.cwiseProduct(d) / 2;
  if (phi > 0 && element.gauge(stuck) <= mu * phi / 2) {
    v.setZero();
    r.h = phi * phi / 4 + stuck.dot(d) / 2;
    r.gradient << phi / 2, stuck;
    r.hessian(0, 0) = 0.5;
    r.hessian.diagonal().tail<3>() = metric / 2;
    return r;
  }
  Derivatives D;
  const auto value = [&](const Vector3& at) {
    const double s = std::max(phi + mu * element.dissipation(at).value, 0.0);
    return (s * s + metric.dot((at - d).cwiseAbs2())) / 4;
  };
  // From the lowest point of a ray that falls from the kink on: along d, or along the slip that sticking would start.
  // All that follows lies below the kink then.
  const auto lowest_along = [&](const Vector3& u) {
    const double dissipated = mu * element.dissipation(u).value;
    const Vector3 pull = metric.cwiseProduct(u);
    return Vector3(u * ((pull.dot(d) - dissipated * phi) / (dissipated * dissipated + pull.dot(u))));
  };
  Vector3 start = lowest_along(d);
  if (!(start.dot(d) > 0)) start = lowest_along(element.slip(stuck));
  if (!v.allFinite() || v.isZero(0) || !(value(v) < value(start))) v = start;
  double h = value(v), last_slope = std::numeric_limits<double>::infinity();
  Vector3 last = v;
  Eigen::LDLT<Matrix3> factor;
  Matrix3 A;
  for (int i = 0; i < 60; ++i) {
    if (!element.derivatives(v, D)) {
      v += 1e-9 * v.norm() * Vector3::Ones();
      if (!element.derivatives(v, D)) break;
    }
    const double s = std::max(phi + mu * D.value, 0.0);
    const Vector3 slope = (s * mu * D.gradient + metric.cwiseProduct(v - d)) / 2;
    A = (s > 0 ? mu * mu : 0) / 2 * D.gradient * D.gradient.transpose() + mu * s / 2 * D.hessian;
    A.diagonal() += metric / 2;
    factor.compute(A);
    const Vector3 step = -factor.solve(slope);
    const double fall = -slope.dot(step);
    if (!(fall > value_digits * h)) {
      if (!(fall < 0.5 * last_slope)) {
        v = last;
        break;
      }
      last_slope = fall;
      last = v;
      v += step;
      continue;
    }
    double share = 1;
    double next = value(v + step);
    for (int halvings = 0; halvings < 40 && !(next <= h - 1e-4 * share * fall); ++halvings) {
      share /= 2;
      next = value(v + share * step);
    }
    v += share * step;
    h = next;
  }
  const BoundedValue bounded = element.dissipation(v);
  const double F = std::max(phi + mu * bounded.value, 0.0) / 2;
  r.h = F * F + metric.dot((v - d).cwiseAbs2()) / 4;
  r.error = F * mu * bounded.error;
  if (!element.derivatives(v, D)) return r;
  r.slips = true;
  r.gradient << F, -mu * F * -D.gradient;
  A = mu * mu / 2 * D.gradient * D.gradient.transpose() + mu * F * D.hessian;
  A.diagonal() += metric / 2;
  factor.compute(A);
  Eigen::Matrix<double, 3, 4> mixed;  // d slope / d (phi, d)
  mixed << mu / 2 * D.gradient, -Matrix3((metric / 2).asDiagonal());
  r.hessian(0, 0) = 0.5;
  r.hessian.diagonal().tail<3>() = metric / 2;
  r.hessian -= mixed.transpose() * factor.solve(mixed);
  return r;
}

QuadraticGrip::Dual QuadraticGrip::evaluate(const Vector6& W) noexcept {
  const auto& parts = grasp_->parts();
  Dual dual;
  dual.value = load_.dot(W);
  dual.balance = load_;
  const double lost = 4 * grasp_->rounding() * W.norm();
  dual.error = lost * load_.norm();
  std::size_t i = 0;
  while (i < parts.size()) {
    const Element& element = parts[i].element;
    const bool paired = i + 1 < parts.size() && parts[i + 1].contact == parts[i].contact;
    const Element* const spin = paired ? &parts[i + 1].element : nullptr;
    const double phi = -element.N().dot(W);
    const Vector3 d = element.sliding(W);
    Response r;
    switch (element.kind()) {
      case Element::Kind::normal:
        r = normal_response(phi);
        break;
      case Element::Kind::point:
      case Element::Kind::spin:
        r = round_response(element, spin, phi, d);
        break;
      default:
        r = smooth_response(element, phi, d, slips_[i]);
    }
    const double F = r.gradient[0];
    const Vector3 t = -r.gradient.tail<3>();
    const Matrix64& G = element.G();
    Matrix64 B = G;
    B.col(0) *= -1;
    dual.value -= r.h;
    dual.error += r.error + lost * (F * G.col(0).norm() + t.norm() * G.rightCols<3>().norm()) + 8 * unit * r.h;
    dual.balance -= B * r.gradient;
    hessians_[i] = r.hessian;
    dual.total += F;
    dual.resistance += std::max(r.resistance, 0.0);
    dual.squares += F * F + weights_.epsilon * (square(t[0]) + square(t[1]) + square(t[2] / weights_.length));
    if (paired) {
      const double force = std::min(element.gauge({t[0], t[1], 0}) / element.mu(), F);
      forces_[i] = {force, Vector3(t[0], t[1], 0), false};
      forces_[i + 1] = {F - force, Vector3(0, 0, t[2]), false};
    } else {
      const bool smooth = element.kind() == Element::Kind::ellipsoid || element.kind() == Element::Kind::patch;
      forces_[i] = {F, t, smooth && r.slips};
    }
    i += paired ? 2 : 1;
  }
  return dual;
}

// Of the forces, in extended precision.
double QuadraticGrip::imbalance() const noexcept {
  Eigen::Matrix<long double, 6, 1> sum = load_.cast<long double>();
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const Matrix64& G = grasp_->parts()[i].element.G();
    const PartForce& x = forces_[i];
    sum += G.col(0).cast<long double>() * x.force;
    for (Eigen::Index k = 0; k < 3; ++k) sum += G.col(k + 1).cast<long double>() * x.friction[k];
  }
  return static_cast<double>(sum.norm());
}

// Root by root: next to the boundary of what can be held the curvature along the escape is below 1e-16 of the largest.
bool QuadraticGrip::factor(double regular) noexcept {
  const Matrix6& P = grasp_->to_range();
  const auto emit = [&](const auto& sink) {
    sink(Matrix6(std::sqrt(regular) * Matrix6::Identity()));
    for (std::size_t i = 0; i < hessians_.size(); ++i) {
      if (hessians_[i].isZero(0)) continue;
      const Eigen::SelfAdjointEigenSolver<Matrix4> modes(hessians_[i]);
      Matrix64 B = grasp_->parts()[i].element.G();
      B.col(0) *= -1;
      const Vector4 roots = modes.eigenvalues().cwiseMax(0).cwiseSqrt();
      sink(Matrix64(P.transpose() * B * modes.eigenvectors() * roots.asDiagonal()));
    }
  };
  return K_.factor(emit, grasp_->rank());
}

bool QuadraticGrip::solve(const Vector6& load, const Weights& weights, int max_iterations,
                          double force_limit) noexcept {
  load_ = load;
  weights_ = weights;
  slips_.assign(grasp_->parts().size(), Vector3::Zero());
  hessians_.assign(grasp_->parts().size(), Matrix4::Zero());
  const Matrix6& P = grasp_->to_range();
  W_ = P * (P.transpose() * load);
  Dual dual = evaluate(W_);
  lower_ = std::max(0.0, dual.value - dual.error);
  double regular = 1e-2;
  int idle = 0;
  const auto out_of_balance = [&](const Dual& at) { return at.balance.norm() / (1 + at.total); };
  double best = out_of_balance(dual);
  for (iterations_ = 0; iterations_ < max_iterations && best > 2 * unit && idle < most_idle; ++iterations_) {
    const Vector6 slope = P.transpose() * dual.balance;
    if (!factor(regular * slope.norm())) break;
    const Vector6 step = P * K_.solve(slope);
    if (!step.allFinite()) break;
    const double rise = step.dot(dual.balance);
    double share = 1;
    Vector6 W = W_ + step;
    Dual next = evaluate(W);
    const auto better = [&] {
      if (share * rise <= value_digits * dual.value) return out_of_balance(next) < best;
      return next.value - dual.value >= 1e-4 * share * rise;
    };
    int halvings = 0;
    for (; halvings < most_halvings && !better(); ++halvings) {
      share /= 2;
      W = W_ + share * step;
      next = evaluate(W);
    }
    if (halvings == most_halvings) {
      // The step was the rounding of a matrix that is hardly regular.
      ++idle;
      regular = std::max(1e-12, 1e3 * regular);
      continue;
    }
    regular = std::clamp(regular * (halvings == 0 ? 0.1 : halvings > 2 ? 10 : 1), 1e-30, 1e2);
    W_ = W;
    dual = next;
    const double now = out_of_balance(dual);
    idle = now < 0.9 * best || dual.value - dual.error > (1 + 1e-12) * lower_ ? 0 : idle + 1;
    lower_ = std::max(lower_, dual.value - dual.error);
    best = std::min(best, now);
    if (load.dot(W_) > force_limit * dual.resistance) break;
  }
  dual = evaluate(W_);
  residual_ = imbalance() + 2 * grasp_->rounding() * dual.total;
  upper_ = dual.squares + residual_ * W_.norm();
  return dual.balance.norm() <= 1e-12 * (1 + dual.total);
}

// One step of Newton's method for the least change: a contact that presses in the forces found, or would in the twist
// reached, gives the row rho = 0; one that sticks T^T W = 0 as well.
bool QuadraticGrip::sharpen(Vector6& W) const noexcept {
  constexpr int most_rows = 48;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::ColMajor, most_rows, 6>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_rows, 1>;
  const auto& parts = grasp_->parts();
  W.normalize();
  // Of rho, beyond its own rounding, so that nothing is left of it.
  const double spare = 64 * grasp_->rounding();
  Rows rows(most_rows, 6);
  Column right(most_rows);
  Eigen::Index count = 0;
  const auto add = [&](const Vector6& row, double value) {
    if (count == most_rows) return;
    rows.row(count) = row.transpose();
    right[count++] = -value;
  };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Element& element = parts[i].element;
    const PartForce& x = forces_[i];
    const double rho = element.resistance(W, 0).value + spare;
    if (!(x.force > 0) && !(rho > 0)) continue;
    const Vector3 d = element.sliding(W);
    const bool rubs = element.kind() != Element::Kind::normal;
    if (rubs && x.force > 0 && !x.on_surface && element.size() == 3) {
      add(-element.N(), -element.N().dot(W) + spare);
      for (Eigen::Index k = 0; k < 3; ++k) add(element.T().col(k), d[k]);
      continue;
    }
    Vector6 slope = -element.N();
    if (rubs) slope += element.mu() * (element.T() * element.gradient(d));
    add(slope, rho);
  }
  if (count == 0 || count == most_rows) return false;
  rows.conservativeResize(count, 6);
  right.conservativeResize(count);
  Eigen::CompleteOrthogonalDecomposition<Rows> solver;
  solver.setThreshold(1e-6);  // near a certificate the rows are dependent but for its error
  solver.compute(rows);
  W += solver.solve(right);
  return W.allFinite() && W.norm() > 0.1;
}

}  // namespace patchgrip::grasp
