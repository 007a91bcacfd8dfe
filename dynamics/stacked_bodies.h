// Two bodies, one on the other, that move in the contact plane: each of the two interfaces a patch of bristles.
//
//     M_1 v_1' = f_1 - s_A + T^T s_B,     M_2 v_2' = f_2 - s_B
//     dq_A/dt = v_1,     dq_B/dt = R_1^T (v_2 - T v_1),     kappa = q - anchor,     s = K kappa + D dkappa/dt in L B
//
// A: body 1 on the ground, its patch about its centre of mass. B: body 2 on body 1, about that of body 2; T carries the
// twist of body 1 there. q_B and kappa_B are kept in axes that turn with body 1, so that what sticks turns with it, q_A
// in those of space. Action is reaction: s_B leaves one body and enters the other at the same place, with the same T.
//
// An implicit stage of length tau is bristle_body.h's for six degrees of freedom, G the matrix of dq/dt = G v at the
// predicted place:
//
//     s + K_e u = s* = K_e [K'^-1 K kappa_0 + tau G v_0 + tau^2 G M^-1 f],   K_e = (K'^-1 + tau^2 G M^-1 G^T)^-1
//
// a convex problem in u = (u_A, u_B), solved by return mappings of one interface at a time, each exact, with what the
// other slips held: the error falls by m_2 / (m_1 + m_2) a sweep or faster, with the masses, inertias alike.
//
// Methods      implicit Euler and SDIRK2, with the energy of bristle_body.h: numerical loss >= 0, friction
//              s . e = L D(e) >= 0 in every stage, whatever L does.
// Creep        none: the anchor of an interface changes only where it slips.
// Limit        L = mu F_N [N] of each interface at the end of a stage, `limit(which, t, twist)` of its predicted
//              relative twist; that of A carries both weights.
// Patches      any; B under the centre of mass of body 2, turning with it. Body 1 has no edge: B rubs wherever it is.
// Units        m [kg], J [kg m^2]; K = diag(k, k, k_r), D likewise; f in axes of space about each centre of mass.
// Error        of order 1 and 2 in the step. Where body 1 turns, what sticks on it keeps its place to that order.
//              tests/dynamics/stacked_bodies_test.cc.
// Throws       std::invalid_argument as BristleBodyParameters, with finite stiffness; std::runtime_error where sweeps
//              do not settle: m_2 beyond some hundred times m_1.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <patchgrip/dynamics/bristle_body.h>
#include <patchgrip/dynamics/return_mapping.h>
#include <patchgrip/dynamics/stage_energy.h>

namespace patchgrip::dynamics {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// Of bodies 1 and 2, or interfaces A and B, one after the other.
struct StackState {
  Vector6 place = Vector6::Zero();
  Vector6 twist = Vector6::Zero();
  Vector6 relative = Vector6::Zero();  // q
  Vector6 anchor = Vector6::Zero();
  Vector6 acceleration = Vector6::Zero();
  double work = 0, dissipated = 0;  // [J], since the start

  Vector6 deflection() const { return relative - anchor; }
};

struct StackStep {
  StackState state;
  Vector6 wrench = Vector6::Zero();  // s at the end: A in axes of space, B in those of body 1
  Vector6 slip = Vector6::Zero();    // of the zones in the step
  std::array<bool, 2> slips{};
  StepEnergy energy;
  int sweeps = 0;
};

// dq/dt = G v at this place.
Matrix6 stack_motion(const Vector6& place);

[[noreturn]] void refuse_sweeps(double t);  // std::runtime_error

template <friction::Patch P, friction::Patch Q>
class StackedBodies {
 public:
  // `lower` is body 1 with interface A, `upper` body 2 with B.
  StackedBodies(P on_ground, Q between, const BristleBodyParameters& lower, const BristleBodyParameters& upper)
      : ground_(std::move(on_ground)), between_(std::move(between)) {
    for (const auto& [p, at] : {std::pair{lower, 0}, {upper, 3}}) {
      p.check();
      contact::require_positive("stiffness k", p.stiffness.k);
      M_.segment<3>(at) = Vector3(p.mass, p.mass, p.inertia);
      K_.segment<3>(at) = Vector3(p.stiffness.k, p.stiffness.k, p.stiffness.k_r);
      D_.segment<3>(at) = Vector3(p.damping, p.damping, p.turn_damping);
    }
  }

  double kinetic_energy(const StackState& s) const { return s.twist.dot(M_.cwiseProduct(s.twist)) / 2; }
  double stored_energy(const StackState& s) const { return s.deflection().dot(K_.cwiseProduct(s.deflection())) / 2; }

  // From t to t + h; `load(t)` gives a Vector6, `limit(which, t, twist)` a double, `which` 0 for A and 1 for B.
  template <class Load, class Limit>
  StackStep step(const StackState& from, double t, double h, Method method, const Load& load,
                 const Limit& limit) const {
    contact::require_positive("step h", h);
    const Vector6 kappa = from.deflection();
    const auto solve = [&](const Vector6& v0, const Vector6& kappa0, const Vector6& place0, double tau, double at,
                           const Vector6& acceleration) {
      const Vector6 end = v0 + tau * acceleration, place = place0 + tau * end;
      const Matrix6 G = stack_motion(place);
      const Vector6 relative = G * end;
      const std::array<double, 2> limits{limit(0, at, Vector3(relative.head<3>())),
                                         limit(1, at, Vector3(relative.tail<3>()))};
      return stage(v0, kappa0, tau, at, load(at), limits, G, {place[2], place[5] - place[2]});
    };
    if (method == Method::implicit_euler)
      return combined<1>(from, h, {solve(from.twist, kappa, from.place, h, t + h, from.acceleration)}, {1});
    const Stage one = solve(from.twist, kappa, from.place, g * h, t + g * h, from.acceleration);
    const double rest = (1 - 2 * g) * h;
    const Stage two = solve(from.twist + rest * one.acceleration, kappa + rest * one.deflection_rate(),
                            from.place + rest * one.twist, g * h, t + (1 - g) * h, one.acceleration);
    return combined<2>(from, h, {one, two}, {0.5, 0.5});
  }

 private:
  struct Stage {
    Vector6 load, wrench, twist, acceleration, relative_rate, slip_rate;
    std::array<bool, 2> slips{};
    int sweeps = 0;

    Vector6 deflection_rate() const { return relative_rate - slip_rate; }
  };

  static constexpr double g = sdirk2_gamma;
  static constexpr int most_sweeps = 20000;

  template <class R>
  static Returned closest(const ReturnMapping<R>& mapping, const Vector3& trial, double limit, const Matrix3& Ke,
                          double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    Matrix3 turn;  // to the patch's axes
    turn << c, s, 0, -s, c, 0, 0, 0, 1;
    const Vector3 own = turn * trial;
    const Matrix3 metric = turn * Ke * turn.transpose();
    Returned r = mapping({own[0], own[1], own[2]}, limit, BristleMetric((metric + metric.transpose()) / 2));
    friction::Wrench& t = r.wrench.value;
    friction::Twist& u = r.slip;
    t = {c * t.fx - s * t.fy, s * t.fx + c * t.fy, t.m};
    u = {c * u.vx - s * u.vy, s * u.vx + c * u.vy, u.w};
    return r;
  }

  Stage stage(const Vector6& v0, const Vector6& kappa0, double tau, double at, const Vector6& f,
              const std::array<double, 2>& limits, const Matrix6& G, const std::array<double, 2>& angles) const {
    Stage r{f, {}, {}, {}, {}, Vector6::Zero()};
    const Vector6 inverse_mass = M_.cwiseInverse(), Kd = K_ + D_ / tau;
    const Matrix6 W = G * inverse_mass.asDiagonal() * G.transpose();
    const Matrix6 compliance = Matrix6(Kd.cwiseInverse().asDiagonal()) + tau * tau * W;
    const Matrix6 Ke = compliance.llt().solve(Matrix6::Identity());
    const Vector6 trial =
        Ke * (K_.cwiseProduct(kappa0).cwiseQuotient(Kd) + tau * (G * (v0 + tau * f.cwiseProduct(inverse_mass))));
    // Block by block, until what the other block feels of a change is rounding.
    Vector6 u = Vector6::Zero(), s = trial;
    const double rounding = 8 * 0x1p-53;
    for (double change = 1, size = 1; change > rounding * size;) {
      if (++r.sweeps > most_sweeps) refuse_sweeps(at);
      change = 0;
      for (const int i : {0, 1}) {
        const int own = 3 * i, other = 3 - own;
        const Vector3 felt = trial.segment<3>(own) - Ke.block<3, 3>(own, other) * u.segment<3>(other);
        const Matrix3 metric = Ke.block<3, 3>(own, own);
        const std::size_t which = static_cast<std::size_t>(i);
        const Returned found = i == 0 ? closest(ground_, felt, limits[0], metric, angles[0])
                                      : closest(between_, felt, limits[1], metric, angles[1]);
        const Vector3 slip(found.slip.vx, found.slip.vy, found.slip.w);
        if (!slip.allFinite()) refuse_sweeps(at);
        const Vector3 moved = slip - u.segment<3>(own);
        change += std::sqrt(std::max(0., moved.dot(metric * moved)));
        u.segment<3>(own) = slip;
        r.slips[which] = found.slips;
        s.segment<3>(own) = Vector3(found.wrench.value.fx, found.wrench.value.fy, found.wrench.value.m);
      }
      size = std::sqrt(trial.dot(compliance * trial));
    }
    if (!r.slips[0] && !r.slips[1]) {
      // For the change alone, so that equilibrium is a fixed point.
      const Vector6 stiff = tau * K_ + D_;
      const Matrix6 A = Matrix6(M_.asDiagonal()) + tau * (G.transpose() * stiff.asDiagonal() * G);
      const Vector6 out = f - G.transpose() * K_.cwiseProduct(kappa0);
      r.acceleration = A.llt().solve(out - G.transpose() * stiff.cwiseProduct(G * v0));
      r.twist = v0 + tau * r.acceleration;
      r.relative_rate = G * r.twist;
      r.wrench = K_.cwiseProduct(kappa0) + stiff.cwiseProduct(r.relative_rate);
      return r;
    }
    r.wrench = s;
    r.acceleration = (f - G.transpose() * s).cwiseProduct(inverse_mass);
    r.twist = v0 + tau * r.acceleration;
    r.relative_rate = G * r.twist;
    r.slip_rate = u / tau;
    return r;
  }

  template <std::size_t n>
  StackStep combined(const StackState& from, double h, const std::array<Stage, n>& stages,
                     const std::array<double, n>& weights) const {
    StackStep r;
    r.state = from;
    StepEnergy& e = r.energy;
    for (std::size_t i = 0; i < n; ++i) {
      const Stage& s = stages[i];
      const double w = h * weights[i];
      r.state.place += w * s.twist;
      r.state.twist += w * s.acceleration;
      r.state.relative += w * s.relative_rate;
      r.slip += w * s.slip_rate;
      for (const int which : {0, 1}) {
        const bool slips = s.slips[static_cast<std::size_t>(which)];
        if (slips) r.state.anchor.segment<3>(3 * which) += w * s.slip_rate.template segment<3>(3 * which);
        r.slips[static_cast<std::size_t>(which)] |= slips;
      }
      r.sweeps += s.sweeps;
      add_stage_energy(e, w, s, D_);
    }
    r.state.acceleration = stages[n - 1].acceleration;
    r.wrench = stages[n - 1].wrench;
    e.numerical = numerical_loss(h, stages, M_, K_);
    r.state.work += e.work;
    r.state.dissipated += e.slip + e.damping + e.numerical;
    return r;
  }

  ReturnMapping<P> ground_;
  ReturnMapping<Q> between_;
  Vector6 M_, K_, D_;
};

}  // namespace patchgrip::dynamics
