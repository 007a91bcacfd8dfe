// Stribeck's excess (stribeck_excess.h) of the pieces of a sampled pressure: convex, with a linear pressure each.
//
// With the twist u in units of the Stribeck velocity per length of the frame, the excess of the friction stress at P is
//
//     p exp(-|u_P|^2) u_P / |u_P|,    u_P = (u_x - u_w y, u_y + u_w x)
//
// A piece far from the pole against its size, and small against 1 / u_w, is summed at n^2 Gauss points of its triangles;
// with rho the ellipse of convergence up to the pole and kappa = u_w size / 2 they err by about
//
//     16 rho^(-2n) exp(kappa^2 (rho - 1/rho)^2 / 4)       at the best rho
//
// Otherwise the triangles between the pole and its edges are integrated along their rays in closed form,
//
//     int_0^1 exp(-y l^2) l^k dl,  k = 1, 2, 3,    y = (u_w |P - M|)^2,
//
// and across them by kernels/vector_quadrature.h.
//
// Error    carried, an estimate; sampled_excess_test.cc.
#pragma once

#include <array>

#include <patchgrip/friction/twist.h>

namespace patchgrip::friction::kernels {

// Force and moment about the frame's origin, with their errors.
struct StribeckSums {
  BoundedWrench wrench;

  void add(double fx, double fy, double m) noexcept {
    wrench.value.fx += fx;
    wrench.value.fy += fy;
    wrench.value.m += m;
  }
  void add_error(double force, double lever) noexcept {
    wrench.force_error += force;
    wrench.moment_error += force * lever;
  }
};

// Corners counter-clockwise.
struct LoadedPiece {
  std::array<double, 4> x, y;
  std::size_t corners;
  double pressure;  // at the first corner
  double gx, gy;    // its gradient
  double highest;   // pressure
};

void add_excess(const LoadedPiece& piece, const Twist& u, StribeckSums& sums) noexcept;

// Relative error of interpolation with `order` points a side on a box whose half diagonal is h, for a pole R half
// diagonals from its centre; kappa = |u_w| h.
double excess_error(int order, double R, double kappa) noexcept;

// exp(-speed^2) / speed
double excess_per_speed(double speed2) noexcept;

}  // namespace patchgrip::friction::kernels
