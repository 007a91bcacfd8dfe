// Pressure that is linear over each triangle of a mesh: distance integrals as sums over the edges where it jumps or
// bends.
//
// Every triangle has p = p_M + g . (P - M) and per edge (edge_sum.h: h, t, d, L, J1 = J) with J3 = int d^3 dt, K1 = int
// t d dt, M2 = int t^2 / d dt, g_n = g . n, g_t = g . tau
//
//     S      = sum (p_M h J1 + g_n J3) / 3
//     grad S = sum -n [(p_M + h g_n) J1 + g_t K1] + g h J1 / 3
//     Hess S = sum q n^T - n J1 g^T,   q = (p_M + h g_n)[n h L + tau (d1 - d0)] + g_t [n h (d1 - d0) + tau M2]
//
// (divergence theorem). The two triangles at an edge have opposite normals: only the jump of p and g across it counts,
// so an edge in a continuous pressure keeps g_n alone, one in a linear pressure nothing. The jump along the edge is
// f + g_t t with f = p_M + h g_n, its value at the pole's foot. With the length l of the edge,
//
//     s = d0 + d1,   d1 - d0 = l (t0 + t1) / s,   L = 2 artanh(l / s),   J1 = [l s + (t0 + t1)(d1 - d0) + 2 h^2 L] / 4
//
// so that distant edges keep their digits. Next to the pole L is a logarithm as in edge_sum.h.
//
// Error    u the unit of rounding, r >= every d: grad S to about u sum l (|jump| r + |g| r^2), S to r times that.
//          sampled_mesh_test.cc.
#pragma once

#include <cstddef>
#include <vector>

#include <patchgrip/friction/sampled/distance_sums.h>
#include <patchgrip/friction/sampled/lanes.h>

namespace patchgrip::friction::kernels {

// A list of edges, one array per component, as many as a multiple of 8: see pad().
struct EdgeJumps {
  std::vector<double> x, y;    // start
  std::vector<double> nx, ny;  // normal, tau = (-ny, nx) points to the end
  std::vector<double> length;
  std::vector<double> jump;    // of the pressure, at the start
  std::vector<double> gn, gt;  // of its gradient

  void add(double x0, double y0, double x1, double y1, double jump_at_start, double normal_slope,
           double tangential_slope);
  void pad();  // with edges of no jump
  std::size_t size() const noexcept { return x.size(); }
};

// Adds edges first ... last - 1, both multiples of 8, to `sums`.
using EdgeKernel = void (*)(const EdgeJumps& edges, std::size_t first, std::size_t last, double X, double Y,
                            DistanceSums& sums) noexcept;

EdgeKernel edge_kernel(Derivatives derivatives, Lanes lanes) noexcept;

}  // namespace patchgrip::friction::kernels
