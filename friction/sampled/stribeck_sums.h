// Stribeck's excess (stribeck_excess.h) of the pieces of a sampled pressure: convex, with a linear pressure each.
//
// With the twist u in units of the Stribeck velocity per length of the frame, the excess of the friction stress at P is
//
//     p exp(-|u_P|^2) u_P / |u_P|,    u_P = (u_x - u_w y, u_y + u_w x)
//
// A piece far from the pole against its size, and small against 1 / u_w, is summed at n^2 Gauss points of its
// triangles; with rho the ellipse of convergence up to the pole and kappa = u_w size / 2 they err by about
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

#include <patchgrip/friction/kernels/excess_parts.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::friction::kernels {

// Force and moment about the frame's origin, with their errors. Of many terms: what each addition rounds off is kept.
class StribeckSums {
 public:
  void add(double fx, double fy, double m) noexcept {
    accumulate(sum_.value.fx, lost_.fx, fx);
    accumulate(sum_.value.fy, lost_.fy, fy);
    accumulate(sum_.value.m, lost_.m, m);
  }
  void add_error(double force, double moment) noexcept {
    sum_.force_error += force;
    sum_.moment_error += moment;
  }
  BoundedWrench total() const noexcept {
    const auto& [fx, fy, m] = sum_.value;
    return {{fx + lost_.fx, fy + lost_.fy, m + lost_.m}, sum_.force_error, sum_.moment_error};
  }

 private:
  static void accumulate(double& sum, double& lost, double term) noexcept {
    const double next = sum + term, added = next - sum;
    lost += (sum - (next - added)) + (term - added);
    sum = next;
  }

  BoundedWrench sum_;
  Wrench lost_;
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
