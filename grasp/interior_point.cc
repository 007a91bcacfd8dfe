#include <patchgrip/grasp/interior_point.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchgrip::grasp {
namespace {

using lorentz::least_eigenvalue;

template <class V>
double largest(const V& v) {
  return v.cwiseAbs().maxCoeff();
}

// By more than rounding.
template <int d>
bool is_inside(const lorentz::Vector<d>& x) {
  return lorentz::is_well_inside<d>(x) || least_eigenvalue<d>(x) > 1e-15 * x[0];
}

}  // namespace

InteriorPoint::InteriorPoint(const ScaledGrasp& grasp)
    : grasp_(&grasp), cones_(grasp.parts().size()), caps_(grasp.contacts()) {
  for (const ScaledGrasp::Part& part : grasp.parts()) patches_ |= part.element.kind() == Element::Kind::patch;
}

void InteriorPoint::set_cone(Cone& cone, const Element& element) noexcept {
  Matrix64 columns = element.G();
  columns.rightCols<3>() = element.mu() * (element.T() * cone.L).eval();
  if (elastic_used_) {
    cone.A = columns;
  } else {
    cone.A.noalias() = grasp_->to_range().transpose() * columns;
  }
}

void InteriorPoint::start(const GripProblem& problem) noexcept {
  const Matrix6& P = grasp_->to_range();
  elastic_used_ = problem.objective == Objective::distance;
  capped_ = problem.limited();
  factored_load_ = problem.objective == Objective::load_factor;
  rank_ = elastic_used_ ? 6 : grasp_->rank();
  b_ = elastic_used_ ? Vector6(-problem.load) : Vector6(-(P.transpose() * problem.load));
  w1_.setZero();
  scale_ = b_.norm() > 0 ? b_.norm() : 1;
  step_scale_ = 1;
  if (factored_load_) {
    scale_ = *std::ranges::max_element(problem.limits);
    w1_ = P.transpose() * problem.step;
    const double size = w1_.norm() > 0 ? w1_.norm() : 1;
    w1_ /= size;
    step_scale_ = scale_ / size;
  }
  b_ /= scale_;
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    const ScaledGrasp::Part& part = grasp_->parts()[i];
    Cone& cone = cones_[i];
    cone.contact = part.contact;
    cone.cost = problem.objective == Objective::total_force ? 1 : 0;
    cone.L = part.element.surrogate();
    set_cone(cone, part.element);
  }
  if (elastic_used_) {
    elastic_.A.setZero();
    elastic_.A.rightCols<6>().diagonal() << 1, 1, 1, 1 / problem.metric, 1 / problem.metric, 1 / problem.metric;
    elastic_.cost = 1;
  }
  each([](auto& b) {
    b.x.setZero();
    b.x[0] = 1;
    b.z = b.x;
  });
  for (std::size_t i = 0; i < caps_.size(); ++i) {
    Cap& cap = caps_[i];
    const double limit = capped_ ? problem.limits[i] / (factored_load_ ? scale_ : 1) : 0;
    cap.c = factored_load_ ? 0 : limit;
    cap.c0 = factored_load_ ? limit : 0;
    cap.slack = cap.u = 1;
  }
  y_.setZero();
  s_ = zs_ = tau_ = kappa_ = 1;
  lambda_ = 0;
  iterations_ = idle_ = 0;
  gap_ = ray_ = 1;
  balanced_ = false;
}

// The slip of a patch: where it slips that of the twist, where it sticks or opens the one that its friction would start.
void InteriorPoint::renew_ellipsoids() noexcept {
  const Vector6 W = twist();
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    const Element& element = grasp_->parts()[i].element;
    if (element.kind() != Element::Kind::patch) continue;
    Cone& cone = cones_[i];
    const Vector3 s = cone.x.tail<3>() / cone.x[0];
    if (s.norm() < 0.1) continue;
    const Vector3 from_friction = -cone.L.transpose().triangularView<Eigen::Upper>().solve(s);
    const double sticking = least_eigenvalue<4>(cone.x) / (cone.x[0] + cone.z[0]);
    Vector3 v = element.sliding(W);
    if (sticking > cone.z[0] || !(v.dot(from_friction) > 0)) v = from_friction;
    Matrix3 L;
    if (!element.osculating(v / std::hypot(v[0], v[1], v[2]), L)) continue;
    cone.L = L;
    set_cone(cone, element);
  }
}

InteriorPoint::Status InteriorPoint::run(double tolerance, int max_iterations) noexcept {
  if (balanced_) each([](auto& b) { b.x = b.px; });
  balanced_ = false;
  renewing_ = patches_;
  best_ = std::numeric_limits<double>::infinity();
  idle_ = 0;
  for (;; ++iterations_) {
    if (renewing_ && std::min(gap_, ray_) < 0.1) renew_ellipsoids();
    if (gap_ < 1e-4) renewing_ = false;
    gap_ = residuals();
    if (gap_ < tolerance) return Status::optimal;
    if (ray_ < tolerance) return Status::infeasible;
    if (!std::isfinite(gap_) || iterations_ >= max_iterations) return Status::stalled;
    if (gap_ < 0.9 * best_) {
      best_ = gap_;
      idle_ = 0;
    } else if (++idle_ > 8) {
      return Status::stalled;
    }
    if (!factor() || !advance()) return Status::stalled;
  }
}

// Of primal, dual and gap, relative; sets ray_ to how far y is from a proof of infeasibility.
double InteriorPoint::residuals() noexcept {
  rp_ = b_ * tau_ - w1_ * lambda_;
  double sum_cu = 0, cap_u = 0, primal = 0, dual = 0, cost = 0, ray = 0;
  mean_ = tau_ * kappa_;
  double count = 1 + static_cast<double>(cones_.size()) + (elastic_used_ ? 1 : 0);
  for (Cap& cap : caps_) cap.rq = cap.c0 * tau_ + cap.c * s_ - cap.slack;
  each([&](auto& b) {
    rp_.noalias() -= b.A * b.x;
    b.rd.noalias() = -(b.A.transpose() * y_) - b.z;
    if (capped_) {
      caps_[b.contact].rq -= b.x[0];
      b.rd[0] += caps_[b.contact].u;
    }
    ray = std::max(ray, largest(b.rd));
    b.rd[0] += b.cost * tau_;
    dual = std::max(dual, largest(b.rd));
    cost += b.cost * b.x[0];
    mean_ += b.x.dot(b.z);
  });
  if (capped_) {
    count += static_cast<double>(caps_.size());
    for (const Cap& cap : caps_) {
      sum_cu += cap.c * cap.u;
      cap_u += cap.c0 * cap.u;
      primal = std::max(primal, std::fabs(cap.rq));
      mean_ += cap.slack * cap.u;
    }
  }
  rds_ = rl_ = 0;
  const bool has_s = capped_ && !factored_load_;
  if (has_s) {
    rds_ = tau_ - sum_cu - zs_;
    mean_ += s_ * zs_;
    count += 1;
    cost += s_;
    ray = std::max(ray, std::fabs(sum_cu + zs_));
  }
  if (factored_load_) {
    rl_ = -tau_ - w1_.dot(y_);
    cost -= lambda_;
    ray = 1;  // the problem always has a solution
  }
  mean_ /= count;
  du_ = b_.dot(y_) - cap_u;
  rg_ = kappa_ + cost - du_;
  primal = std::max(primal, largest(rp_)) / tau_;
  dual = std::max({dual, std::fabs(rds_), std::fabs(rl_)}) / tau_;
  ray_ = du_ > 0 && kappa_ > tau_ ? ray / du_ : 1;
  const double size = std::fabs(cost);
  return std::max({primal / (1 + size / tau_), dual, std::fabs(cost - du_) / (tau_ + size)});
}

// Largest step that leaves no cone, at most `most`: only what leaves its cone with the step so far makes it shorter.
double InteriorPoint::longest(const Step& step, double dtau, double dkappa, double most) noexcept {
  double a = most;
  const auto limit = [&](double x, double dx) {
    if (x + a * dx < 0) a = -x / dx;
  };
  each([&]<int d>(const Block<d>& b) {
    using V = lorentz::Vector<d>;
    if (!lorentz::is_well_inside<d>(V(b.x + a * b.dx))) a = std::min(a, lorentz::step_to_boundary<d>(b.x, b.dx));
    if (!lorentz::is_well_inside<d>(V(b.z + a * b.dz))) a = std::min(a, lorentz::step_to_boundary<d>(b.z, b.dz));
  });
  if (capped_) {
    for (const Cap& cap : caps_) {
      limit(cap.slack, cap.dslack);
      limit(cap.u, -cap.dv);
    }
    if (!factored_load_) {
      limit(s_, step.border);
      limit(zs_, step.dzs);
    }
  }
  limit(tau_, dtau);
  limit(kappa_, dkappa);
  return a;
}

bool InteriorPoint::advance() noexcept {
  const bool has_s = capped_ && !factored_load_;
  const auto objective = [&](const Step& step, bool corrector) {  // c dx - b dy
    double t = (has_s ? step.border : 0) - (factored_load_ ? step.border : 0) - b_.dot(step.y);
    each([&](auto& b) { t += b.cost * (corrector ? b.dx[0] : b.px[0]); });
    if (capped_) {
      for (const Cap& cap : caps_) t -= cap.c0 * (corrector ? cap.dv : cap.pv);
    }
    return t;
  };
  const Step per_tau = solve<false>(0, 0);
  const double per_tau_objective = objective(per_tau, false);
  Step step;
  double dtau = 0, dkappa = 0;
  const auto direction = [&](double eta, double rs, double rk) {
    step = solve<true>(eta, rs);
    dtau = (rk / tau_ + eta * rg_ + objective(step, true)) / (kappa_ / tau_ - per_tau_objective);
    dkappa = (rk - kappa_ * dtau) / tau_;
    step.y += dtau * per_tau.y;
    step.border += dtau * per_tau.border;
    step.dzs += dtau * per_tau.dzs;
    each([&](auto& b) {
      b.dx += dtau * b.px;
      b.dz += dtau * b.pz;
    });
    if (capped_) {
      for (Cap& cap : caps_) {
        cap.dv += dtau * cap.pv;
        cap.dslack += dtau * cap.pslack;
      }
    }
  };
  // Predictor
  each([](auto& b) { b.rx = -b.x; });
  for (Cap& cap : caps_) cap.rc = -cap.slack;
  direction(1, -s_, -tau_ * kappa_);
  const double affine = longest(step, dtau, dkappa, 1);
  const double sigma = (1 - affine) * (1 - affine) * (1 - affine);
  const double target = sigma * mean_;
  // Corrector
  each([&]<int d>(Block<d>& b) {
    const auto l = b.scaling.T(b.z);
    auto r = lorentz::Vector<d>(-lorentz::product<d>(l, l) -
                                lorentz::product<d>(b.scaling.inverse_T(b.dx), b.scaling.T(b.dz)));
    r[0] += target;
    b.rx = b.scaling.T(lorentz::quotient<d>(r, l));
  });
  if (capped_) {
    for (Cap& cap : caps_) cap.rc = (target - cap.slack * cap.u + cap.dslack * cap.dv) / cap.u;
  }
  const double rs = has_s ? (target - s_ * zs_ - step.border * step.dzs) / zs_ : 0;
  direction(1 - sigma, rs, target - tau_ * kappa_ - dtau * dkappa);
  double a = 0.99 * longest(step, dtau, dkappa, 1 / 0.99);
  if (!(a > 1e-7)) return false;
  const auto inside = [&] {
    bool all = true;
    each([&]<int d>(const Block<d>& b) { all = all && is_inside<d>(b.x + a * b.dx) && is_inside<d>(b.z + a * b.dz); });
    return all;
  };
  for (int tries = 0; tries < 30 && !inside(); ++tries) a *= 0.7;
  y_ += a * step.y;
  each([&](auto& b) {
    b.x += a * b.dx;
    b.z += a * b.dz;
  });
  if (capped_) {
    for (Cap& cap : caps_) {
      cap.u -= a * cap.dv;
      cap.slack += a * cap.dslack;
    }
    if (factored_load_) {
      lambda_ += a * step.border;
    } else {
      s_ += a * step.border;
      zs_ += a * step.dzs;
    }
  }
  tau_ += a * dtau;
  kappa_ += a * dkappa;
  return true;
}

Vector6 InteriorPoint::twist() const noexcept {
  const Vector6 W = elastic_used_ ? Vector6(-y_) : Vector6(-(grasp_->to_range() * y_));
  return tau_ > 1e-9 * kappa_ ? Vector6(W / tau_) : Vector6(W / W.norm());
}

double InteriorPoint::value() const noexcept {
  return factored_load_ ? lambda_ / tau_ * step_scale_ : s_ / tau_ * scale_;
}

InteriorPoint::PartPoint InteriorPoint::part(std::size_t index) const noexcept {
  const Cone& cone = cones_[index];
  const double k = scale_ / tau_;
  const double x = cone.x.tail<3>().norm(), z = cone.z.tail<3>().norm();
  const double mu = grasp_->parts()[index].element.mu();
  const double slip = mu > 0 && y_.norm() > 0 ? z / (mu * tau_ * twist().norm()) : 0;
  return {
      k * cone.x[0], k * mu * (cone.L * cone.x.tail<3>()), cone.x[0] - x, cone.x[0] + x, cone.z[0] - z, cone.z[0] + z,
      slip};
}

InteriorPoint::CapPoint InteriorPoint::cap(std::size_t contact) const noexcept {
  return {caps_[contact].slack, caps_[contact].u};
}

}  // namespace patchgrip::grasp
