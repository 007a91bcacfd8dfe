// Point loads on a tensor grid of Chebyshev points, in place of a pressure that is far from the pole.
//
// A pressure on a box acts on a distant pole as the loads q_ij = integral of p l_i(x) l_j(y) dA at the box's Chebyshev
// points do, l_i the Lagrange polynomials on them: the velocity field's direction is interpolated, and with it
//
//     D = sum q |v_P|,   grad D = sum (q / |v_P|) (v_x, v_y, x v_y - y v_x),   Hess D = sum (q / |v_P|) z z^T,
//     z = (-v_y, v_x, x v_x + y v_y) / |v_P|
//
// Written in the twist itself: no pole, regular at w = 0, and the three are derivatives of one function.
//
// Error    relative to the load of the box (moment: to load times half diagonal, about the box's centre), with N points
//          a side and the pole at R half diagonals from the centre, R >= 1.5:
//              (4/3) R (R + sqrt(R^2 - 1))^-N
//          The base is the ellipse of convergence of a pole on the long axis, the factor is measured:
//          sampled_kernels_test.cc. It holds for any pressure p >= 0.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/friction/sampled/lanes.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::friction::kernels {

struct Box {
  double x = 0, y = 0;    // centre
  double hx = 0, hy = 0;  // half sides

  double half_diagonal() const noexcept { return std::hypot(hx, hy); }
};

struct LoadSums {
  Wrench gradient;
  Hessian hessian;
};

// The twist and the moment are about the origin of the box's coordinates. Adds to `sums`.
using LoadKernel = void (*)(const double* loads, const Box& box, const Twist& v, LoadSums& sums) noexcept;

struct LoadKernels {
  LoadKernel gradient;
  LoadKernel hessian;
};

inline constexpr int load_orders[] = {8, 16, 24};  // N

LoadKernels load_kernels(int order, Lanes lanes) noexcept;

// Points in [-1, 1], largest first.
std::span<const double> load_points(int order) noexcept;

// The error above for one N and R, and the least R for which it is at most `tolerance`.
double load_error(int order, double R) noexcept;
double load_reach(int order, double tolerance) noexcept;

// How loads are chosen for a tolerance; one of 0 stands for rounding.
struct LoadRule {
  int order;         // N
  double reach;      // R from which on they are good to the tolerance
  double tolerance;  // > 0
};

LoadRule load_rule(double tolerance) noexcept;

// l_0(t) ... l_(N-1)(t)
void lagrange(int order, double t, std::span<double> values) noexcept;

}  // namespace patchgrip::friction::kernels
