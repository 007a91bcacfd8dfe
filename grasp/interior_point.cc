#include <patchgrip/grasp/interior_point.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchgrip::grasp {
namespace {

Eigen::Vector4d lane_of(const Packed<4, Pack>& x, int lane) { return {x[0][lane], x[1][lane], x[2][lane], x[3][lane]}; }

Vector6 lane_of(const Packed<6, Pack>& x, int lane) {
  Vector6 one;
  for (Eigen::Index i = 0; i < 6; ++i) one[i] = x[static_cast<std::size_t>(i)][lane];
  return one;
}

template <std::size_t n>
Eigen::Matrix<double, static_cast<int>(n), 1> whole(const Packed<n, double>& x) {
  return Eigen::Map<const Eigen::Matrix<double, static_cast<int>(n), 1>>(x.c);
}

template <std::size_t d, class S>
void reset(Block<d, S>& b) {
  for (auto& column : b.A) column = {};
  b.x = b.z = {};
  b.x[0] = b.z[0] = S{} + 1.0;
  b.live = b.cost = S{};
}

}  // namespace

InteriorPoint::InteriorPoint(const ScaledGrasp& grasp, const InteriorPointKernels& kernels)
    : grasp_(&grasp),
      kernels_(&kernels),
      L_(grasp.parts().size()),
      cones_((grasp.contacts() + lanes - 1) / lanes),
      caps_(cones_.size()) {
  for (std::size_t k = 0; k < cones_.size(); ++k) cones_[k].caps = k;
  // Of the next part of a contact: that of the pack's last layer so far, in which its lane may be free.
  std::vector<std::vector<std::size_t>> layers(cones_.size());
  std::vector<std::size_t> count(grasp.contacts());
  for (std::size_t k = 0; k < cones_.size(); ++k) layers[k] = {k};
  for (const ScaledGrasp::Part& part : grasp.parts()) {
    const std::size_t k = part.contact / lanes, layer = count[part.contact]++;
    if (layer == layers[k].size()) {
      layers[k].push_back(cones_.size());
      cones_.emplace_back();
      cones_.back().caps = k;
      cones_.back().joins = true;
    }
    slots_.push_back({layers[k][layer], static_cast<int>(part.contact % lanes)});
    has_patches_ |= part.element.kind() == Element::Kind::patch;
  }
  balanced_x_.resize(cones_.size());
}

void InteriorPoint::set_columns(std::size_t part) noexcept {
  const Element& element = grasp_->parts()[part].element;
  Matrix64 columns = element.G();
  columns.rightCols<3>() = element.mu() * (element.T() * L_[part]).eval();
  if (blocks_.elastic == nullptr) columns = (grasp_->to_range().transpose() * columns).eval();
  const auto [block, lane] = slots_[part];
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < 6; ++i) cones_[block].A[k][i][lane] = columns.data()[6 * k + i];
  }
}

void InteriorPoint::start(const GripProblem& problem, double settled_gap) noexcept {
  settled_gap_ = settled_gap;
  const bool elastic = problem.objective == Objective::distance;
  factored_load_ = problem.objective == Objective::load_factor;
  blocks_ = {cones_.data(),    cones_.size(), caps_.data(), caps_.size(), elastic ? &elastic_ : nullptr,
             problem.limited()};
  rank_ = elastic ? 6 : grasp_->rank();
  const Matrix6& P = grasp_->to_range();
  b_ = elastic ? Vector6(-problem.load) : Vector6(-(P.transpose() * problem.load));
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
  for (Cones& b : cones_) reset(b);
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto [block, lane] = slots_[i];
    cones_[block].live[lane] = 1;
    cones_[block].cost[lane] = problem.objective == Objective::total_force ? 1 : 0;
    L_[i] = grasp_->parts()[i].element.surrogate();
    set_columns(i);
  }
  if (elastic) {
    reset(elastic_);
    elastic_.live = elastic_.cost = 1;
    for (std::size_t i = 0; i < 6; ++i) elastic_.A[i + 1][i] = i < 3 ? 1 : 1 / problem.metric;
  }
  for (std::size_t k = 0; k < caps_.size(); ++k) {
    Caps& caps = caps_[k];
    caps.slack = caps.u = Pack{} + 1.0;
    caps.c = caps.c0 = caps.live = Pack{};
    for (int lane = 0; lane < lanes && lanes * k + static_cast<std::size_t>(lane) < grasp_->contacts(); ++lane) {
      if (!problem.limited()) break;
      const double limit = problem.limits[lanes * k + static_cast<std::size_t>(lane)];
      caps.live[lane] = 1;
      (factored_load_ ? caps.c0 : caps.c)[lane] = factored_load_ ? limit / scale_ : limit;
    }
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
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const Element& element = grasp_->parts()[i].element;
    if (element.kind() != Element::Kind::patch) continue;
    const auto [block, lane] = slots_[i];
    const Eigen::Vector4d x = lane_of(cones_[block].x, lane);
    const double z0 = cones_[block].z[0][lane];
    const Vector3 s = x.tail<3>() / x[0];
    if (s.norm() < 0.1) continue;
    const Vector3 from_friction = -L_[i].transpose().triangularView<Eigen::Upper>().solve(s);
    const double sticking = (x[0] - x.tail<3>().norm()) / (x[0] + z0);
    Vector3 v = element.sliding(W);
    if (sticking > z0 || !(v.dot(from_friction) > 0)) v = from_friction;
    Matrix3 L;
    if (!element.osculating(v / std::hypot(v[0], v[1], v[2]), L)) continue;
    L_[i] = L;
    set_columns(i);
  }
}

InteriorPoint::Status InteriorPoint::run(double tolerance, double ray_tolerance, int max_iterations) noexcept {
  if (balanced_) {
    for (std::size_t k = 0; k < cones_.size(); ++k) cones_[k].x = balanced_x_[k];
  }
  balanced_ = false;
  renewing_ = has_patches_;
  best_ = std::numeric_limits<double>::infinity();
  idle_ = 0;
  for (;; ++iterations_) {
    if (renewing_ && std::min(gap_, ray_) < 0.1) renew_ellipsoids();
    if (gap_ < settled_gap_) renewing_ = false;
    gap_ = residuals();
    const auto ended = [&](Status status) {
      twist_size_ = y_.norm() > 0 ? twist().norm() : 0;
      return status;
    };
    if (gap_ < tolerance) return ended(Status::optimal);
    if (ray_ < ray_tolerance) return ended(Status::infeasible);
    if (!std::isfinite(gap_) || iterations_ >= max_iterations) return ended(Status::stalled);
    if (gap_ < 0.9 * best_) {
      best_ = gap_;
      idle_ = 0;
    } else if (++idle_ > 8) {
      return ended(Status::stalled);
    }
    if (!factor() || !advance()) return ended(Status::stalled);
  }
}

// Of primal, dual and gap, relative; sets ray_ to how far y is from a proof of infeasibility.
double InteriorPoint::residuals() noexcept {
  Residuals r;
  kernels_->residuals(blocks_, y_.data(), tau_, s_, r);
  rp_ = b_ * tau_ - w1_ * lambda_ - Eigen::Map<const Vector6>(r.carried);
  double cost = r.cost, ray = r.ray;
  mean_ = tau_ * kappa_ + r.product;
  std::size_t count = 1 + slots_.size() + (blocks_.elastic != nullptr ? 1 : 0);
  if (blocks_.capped) count += grasp_->contacts();
  rds_ = rl_ = 0;
  if (has_s()) {
    rds_ = tau_ - r.limit_share - zs_;
    mean_ += s_ * zs_;
    count += 1;
    cost += s_;
    ray = std::max(ray, std::fabs(r.limit_share + zs_));
  }
  if (factored_load_) {
    rl_ = -tau_ - w1_.dot(y_);
    cost -= lambda_;
    ray = 1;  // the problem always has a solution
  }
  mean_ /= static_cast<double>(count);
  du_ = b_.dot(y_) - r.limit_power;
  rg_ = kappa_ + cost - du_;
  const double primal = std::max(r.primal, rp_.cwiseAbs().maxCoeff()) / tau_;
  const double dual = std::max({r.dual, std::fabs(rds_), std::fabs(rl_)}) / tau_;
  ray_ = du_ > 0 && kappa_ > tau_ ? ray / du_ : 1;
  const double size = std::fabs(cost);
  return std::max({primal / (1 + size / tau_), dual, std::fabs(cost - du_) / (tau_ + size)});
}

template <class Sink>
void InteriorPoint::emit(const Sink& sink) const {
  const auto one = [&](double eta, double eta2, const auto& w, const auto& A, double& pivot, Vector6& a) {
    constexpr int n = std::decay_t<decltype(A)>::ColsAtCompileTime - 1;
    const Eigen::Matrix<double, n, 1> w1 = w.template tail<n>();
    const double c = 1 + 2 * w1.squaredNorm(), r = std::sqrt(c);
    const Vector6 q = A.template rightCols<n>() * w1;
    sink(Eigen::Matrix<double, 6, n>(eta * (A.template rightCols<n>() - (2 / (r * (1 + r)) * q) * w1.transpose())));
    pivot = eta2 * c;
    a = eta2 * (c * A.col(0) + 2 * w[0] * q);
  };
  double pivot = 0, before = 0;
  Vector6 a, sum = Vector6::Zero();
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto [block, lane] = slots_[i];
    const Cones& b = cones_[block];
    Matrix64 A;
    for (int k = 0; k < 4; ++k) A.col(k) = lane_of(b.A[k], lane);
    one(b.scaling.eta[lane], b.scaling.eta2[lane], lane_of(b.scaling.w, lane), A, pivot, a);
    if (!blocks_.capped) {
      sink(Vector6(a / std::sqrt(pivot)));
    } else if (b.joins) {  // the parts of a contact follow each other
      sink(Vector6(std::sqrt(pivot * before / (pivot + before)) * (a / pivot - sum / before)));
      before += pivot;
      sum += a;
    } else {
      before = pivot;
      sum = a;
    }
  }
  if (blocks_.elastic != nullptr) {
    Eigen::Matrix<double, 6, 7> A;
    for (int k = 0; k < 7; ++k) A.col(k) = whole(elastic_.A[k]);
    one(elastic_.scaling.eta, elastic_.scaling.eta2, whole(elastic_.scaling.w), A, pivot, a);
    sink(Vector6(a / std::sqrt(pivot)));
  }
  if (!blocks_.capped) return;
  for (std::size_t contact = 0; contact < grasp_->contacts(); ++contact) {
    const Caps& caps = caps_[contact / lanes];
    const auto lane = static_cast<int>(contact % lanes);
    sink(Vector6(std::sqrt(caps.h[lane] / (caps.pivot[lane] * caps.D[lane])) * lane_of(caps.a, lane)));
  }
}

bool InteriorPoint::factor() noexcept {
  NormalMatrix N;
  kernels_->factor(blocks_, N);
  Matrix6 M;
  for (int i = 0, at = 0; i < 6; ++i) {
    for (int j = 0; j <= i; ++j, ++at) M(j, i) = M(i, j) = N.lower[at];
  }
  corner_ = N.corner;
  border_ = factored_load_ ? w1_ : Vector6(Eigen::Map<const Vector6>(N.border));
  if (has_s()) {
    hs_ = s_ / zs_;
    corner_ += 1 / hs_;
  }
  if (!M_.factor(
          M, [&](const auto& sink) { emit(sink); }, rank_))
    return false;
  if (blocks_.capped) border_solved_ = M_.solve(border_);
  return true;
}

// [M p; p^T -d] (dy, border) = (right, -corner).
InteriorPoint::Step InteriorPoint::reduced(const RightSide& r) const noexcept {
  Step step{M_.solve(Eigen::Map<const Vector6>(r.right)), 0, 0};
  if (blocks_.capped) {
    step.border = (border_.dot(step.y) + r.corner) / (border_.dot(border_solved_) + corner_);
    step.y -= step.border * border_solved_;
  }
  return step;
}

InteriorPoint::Step InteriorPoint::solve(bool corrector, double eta, double rs, double& gain) noexcept {
  const double rds = corrector ? eta * rds_ : 1;
  RightSide r;
  Eigen::Map<Vector6>(r.right) = corrector ? Vector6(eta * rp_) : b_;
  r.corner = factored_load_ ? -(corrector ? eta * rl_ : -1) : 0;
  if (has_s()) r.corner = rs / hs_ - rds;
  kernels_->add_right_side(blocks_, corrector, eta, r);
  Step step = reduced(r);
  const Gain g = kernels_->directions(blocks_, corrector, eta, step.y.data(), has_s() ? step.border : 0);
  step.dzs = has_s() ? rds + g.limit_share : 0;
  gain = g.objective + (has_s() ? step.border : 0) - (factored_load_ ? step.border : 0) - b_.dot(step.y);
  return step;
}

bool InteriorPoint::advance() noexcept {
  double gain_per_tau = 0;
  const Step per_tau = solve(false, 0, 0, gain_per_tau);
  Step step;
  double dtau = 0, dkappa = 0;
  const auto direction = [&](double eta, double rs, double rk) {
    double gain = 0;
    step = solve(true, eta, rs, gain);
    dtau = (rk / tau_ + eta * rg_ + gain) / (kappa_ / tau_ - gain_per_tau);
    dkappa = (rk - kappa_ * dtau) / tau_;
    step.y += dtau * per_tau.y;
    step.border += dtau * per_tau.border;
    step.dzs += dtau * per_tau.dzs;
    kernels_->add_tau(blocks_, dtau);
  };
  // Largest step that leaves no cone, at most `most`.
  const auto longest = [&](double most) {
    double a = kernels_->longest(blocks_, most);
    const auto limit = [&](double x, double dx) {
      if (x + a * dx < 0) a = -x / dx;
    };
    if (has_s()) {
      limit(s_, step.border);
      limit(zs_, step.dzs);
    }
    limit(tau_, dtau);
    limit(kappa_, dkappa);
    return a;
  };
  kernels_->predict(blocks_);
  direction(1, -s_, -tau_ * kappa_);
  const double affine = longest(1);
  const double sigma = (1 - affine) * (1 - affine) * (1 - affine);
  const double target = sigma * mean_;
  kernels_->correct(blocks_, target);
  const double rs = has_s() ? (target - s_ * zs_ - step.border * step.dzs) / zs_ : 0;
  direction(1 - sigma, rs, target - tau_ * kappa_ - dtau * dkappa);
  double a = 0.99 * longest(1 / 0.99);
  if (!(a > 1e-7)) return false;
  for (int tries = 0; tries < 30 && !kernels_->inside(blocks_, a); ++tries) a *= 0.7;
  kernels_->advance(blocks_, a);
  y_ += a * step.y;
  if (factored_load_) {
    lambda_ += a * step.border;
  } else if (blocks_.capped) {
    s_ += a * step.border;
    zs_ += a * step.dzs;
  }
  tau_ += a * dtau;
  kappa_ += a * dkappa;
  return true;
}

bool InteriorPoint::balance() noexcept {
  if (blocks_.elastic != nullptr) return true;
  Blocks uncapped = blocks_;
  uncapped.capped = false;
  std::swap(blocks_, uncapped);
  const bool factored = factor();
  if (factored) {
    for (std::size_t k = 0; k < cones_.size(); ++k) balanced_x_[k] = cones_[k].x;
    balanced_ = true;
    for (int pass = 0; pass < 3; ++pass) {
      Residuals r;
      kernels_->residuals(blocks_, y_.data(), tau_, s_, r);
      const Vector6 u = M_.solve(b_ * tau_ - w1_ * lambda_ - Eigen::Map<const Vector6>(r.carried));
      kernels_->shift(blocks_, u.data());
    }
  }
  std::swap(blocks_, uncapped);
  return factored;
}

Vector6 InteriorPoint::twist() const noexcept {
  const Vector6 W = blocks_.elastic != nullptr ? Vector6(-y_) : Vector6(-(grasp_->to_range() * y_));
  return tau_ > 1e-9 * kappa_ ? Vector6(W / tau_) : Vector6(W / W.norm());
}

double InteriorPoint::value() const noexcept {
  return factored_load_ ? lambda_ / tau_ * step_scale_ : s_ / tau_ * scale_;
}

InteriorPoint::PartPoint InteriorPoint::part(std::size_t index) const noexcept {
  const auto [block, lane] = slots_[index];
  const Eigen::Vector4d x = lane_of(cones_[block].x, lane), z = lane_of(cones_[block].z, lane);
  const double k = scale_ / tau_, mu = grasp_->parts()[index].element.mu();
  const double x_tail = x.tail<3>().norm(), z_tail = z.tail<3>().norm();
  const double slip = mu > 0 && twist_size_ > 0 ? z_tail / (mu * tau_ * twist_size_) : 0;
  return {k * x[0], k * mu * (L_[index] * x.tail<3>()), x[0] - x_tail, x[0] + x_tail, z[0] - z_tail, z[0] + z_tail,
          slip};
}

InteriorPoint::CapPoint InteriorPoint::cap(std::size_t contact) const noexcept {
  const Caps& caps = caps_[contact / lanes];
  const auto lane = static_cast<int>(contact % lanes);
  return {caps.slack[lane], caps.u[lane]};
}

}  // namespace patchgrip::grasp
