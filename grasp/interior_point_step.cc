// The linear system of a step of the interior point: contacts eliminated one by one into six or seven unknowns.
#include <patchgrip/grasp/interior_point.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::grasp {

template <int d>
void InteriorPoint::Block<d>::set_squares() noexcept {
  const double w0 = scaling.w[0];
  const Eigen::Matrix<double, d - 1, 1> w1 = scaling.w.template tail<d - 1>();
  const double c = 1 + 2 * w1.squaredNorm();
  const Vector6 q = A.template rightCols<d - 1>() * w1;
  // (1 - c^-1/2) / |w_1|^2 = 2 (1 - c^-1/2) / (c - 1)
  const double root = std::sqrt(c);
  const double share = 2 / (root * (1 + root));
  B = scaling.eta * (A.template rightCols<d - 1>() - (share * q) * w1.transpose());
  a = scaling.eta2 * (c * A.col(0) + 2 * w0 * q);
  pivot = scaling.eta2 * c;
}

// Parts of one contact share its cap: what a part adds to those before it is the square of their difference, and of
// their sum under the cap,
//
//     a_1 a_1^T / p_1 + a_2 a_2^T / p_2 = (a_1 + a_2)(a_1 + a_2)^T / (p_1 + p_2) + d d^T p_1 p_2 / (p_1 + p_2)
bool InteriorPoint::factor() noexcept {
  for (Cap& cap : caps_) cap.pivot = 0;
  each([&](auto& b) {
    b.scaling.set(b.x, b.z);
    b.set_squares();
    if (!capped_) return;
    Cap& cap = caps_[b.contact];
    b.joins = cap.pivot > 0;
    if (!b.joins) {
      cap.pivot = b.pivot;
      cap.a = b.a;
      return;
    }
    b.difference = std::sqrt(b.pivot * cap.pivot / (b.pivot + cap.pivot)) * (b.a / b.pivot - cap.a / cap.pivot);
    cap.pivot += b.pivot;
    cap.a += b.a;
  });
  border_.setZero();
  corner_ = 0;
  if (capped_) {
    for (Cap& cap : caps_) {
      cap.h = cap.slack / cap.u;
      cap.D = cap.h + cap.pivot;
      border_ += (cap.c / cap.D) * cap.a;
      corner_ += cap.c * cap.c / cap.D;
    }
  }
  if (factored_load_) {
    border_ = w1_;
  } else if (capped_) {
    hs_ = s_ / zs_;
    corner_ += 1 / hs_;
  }
  const auto emit = [&](const auto& sink) {
    each([&](const auto& b) {
      sink(b.B);
      if (!capped_) sink(Vector6(b.a / std::sqrt(b.pivot)));
      if (capped_ && b.joins) sink(b.difference);
    });
    if (!capped_) return;
    for (const Cap& cap : caps_) sink(Vector6(std::sqrt(cap.h / (cap.pivot * cap.D)) * cap.a));
  };
  if (!M_.factor(emit, rank_)) return false;
  border_solved_ = M_.solve(border_);
  return true;
}

// [M p; p^T -d] (dy, border) = (right, -corner).
InteriorPoint::Step InteriorPoint::reduced(const Vector6& right, double corner) const noexcept {
  Step step;
  step.y = M_.solve(right);
  step.border = 0;
  if (capped_) {
    step.border = (border_.dot(step.y) + corner) / (border_.dot(border_solved_) + corner_);
    step.y -= step.border * border_solved_;
  }
  return step;
}

// The Newton step to the residuals times eta and to the complementarity in rx, rc and rs; or, without corrector, what a
// change of tau by one asks for.
template <bool corrector>
InteriorPoint::Step InteriorPoint::solve(double eta, double rs) noexcept {
  const bool has_s = capped_ && !factored_load_;
  Vector6 right = corrector ? Vector6(eta * rp_) : b_;
  if (capped_) {
    for (Cap& cap : caps_) cap.q = corrector ? eta * cap.rq - cap.rc : cap.c0;
  }
  each([&](auto& b) {
    auto t = b.rx;
    if constexpr (corrector) {
      t -= eta * b.scaling.H(b.rd);
    } else {
      if (b.cost == 0) return;
      t.setZero();
      t[0] = -b.cost;
      t = b.scaling.H(t);
    }
    right.noalias() -= b.A * t;
    if (capped_) caps_[b.contact].q -= t[0];
  });
  const double rds = corrector ? eta * rds_ : 1;
  double corner = factored_load_ ? -(corrector ? eta * rl_ : -1) : 0;
  if (has_s) corner = rs / hs_ - rds;
  if (capped_) {
    for (const Cap& cap : caps_) {
      right.noalias() -= cap.a * (cap.q / cap.D);
      corner -= cap.c * cap.q / cap.D;
    }
  }
  Step step = reduced(right, corner);
  const double ds = has_s ? step.border : 0;
  double sum_cv = 0;
  if (capped_) {
    for (Cap& cap : caps_) {
      const double dv = (cap.q - cap.a.dot(step.y) + cap.c * ds) / cap.D;
      sum_cv += cap.c * dv;
      (corrector ? cap.dv : cap.pv) = dv;
      (corrector ? cap.dslack : cap.pslack) = (corrector ? cap.rc : 0) + cap.h * dv;
    }
  }
  each([&](auto& b) {
    auto z = b.rd;
    if constexpr (corrector) {
      z = eta * b.rd - b.A.transpose() * step.y;
    } else {
      z.noalias() = -(b.A.transpose() * step.y);
      z[0] += b.cost;
    }
    if (capped_) z[0] -= corrector ? caps_[b.contact].dv : caps_[b.contact].pv;
    (corrector ? b.dz : b.pz) = z;
    if constexpr (corrector) {
      b.dx = b.rx - b.scaling.H(z);
    } else {
      b.px = -b.scaling.H(z);
    }
  });
  step.dzs = has_s ? rds + sum_cv : 0;
  return step;
}

template InteriorPoint::Step InteriorPoint::solve<false>(double, double) noexcept;
template InteriorPoint::Step InteriorPoint::solve<true>(double, double) noexcept;

bool InteriorPoint::balance() noexcept {
  if (elastic_used_) return true;
  const auto emit = [&](const auto& sink) {
    each([&](auto& b) {
      b.scaling.set(b.x, b.z);
      b.set_squares();
      sink(b.B);
      sink(Vector6(b.a / std::sqrt(b.pivot)));
    });
  };
  if (!M_.factor(emit, rank_)) return false;
  each([](auto& b) { b.px = b.x; });
  balanced_ = true;
  for (int pass = 0; pass < 3; ++pass) {
    Vector6 r = b_ * tau_ - w1_ * lambda_;
    each([&](auto& b) { r.noalias() -= b.A * b.x; });
    const Vector6 u = M_.solve(r);
    each([&]<int d>(Block<d>& b) { b.x += b.scaling.H(lorentz::Vector<d>(b.A.transpose() * u)); });
  }
  return true;
}

}  // namespace patchgrip::grasp
