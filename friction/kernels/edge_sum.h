// Uniform pressure on a polygon: distance integrals as sums over its edges.
//
// For a pole M and edges from t0 to t1 (along the edge, from the foot of M) at the signed distance h = n . (P - M),
// with outward normal n, tangent tau, d = |P - M| at the ends,
//
//     L  = int dt / d = asinh(t1 / |h|) - asinh(t0 / |h|)
//     J  = int d dt   = (t1 d1 - t0 d0 + h^2 L) / 2
//     A S      = sum h J / 3
//     A grad S = -sum n J
//     A Hess S = sum [n h L + tau (d1 - d0)] n^T
//
// (divergence theorem; holes run clockwise). L is taken as the logarithm of one ratio in which nothing cancels; an edge
// in line with the pole has h L = 0. On an edge and on a vertex all of this stays finite.
//
// Far from the patch the sums cancel: the moment S - M . grad S loses (r / size)^3 units, more for slender shapes. The
// callers change to extended precision, then to a far field, before that matters.
//
// Error   with u the unit of rounding of Real and m = (|t1| d1 + |t0| d0 + |h^2 L|) / 2 + d0 d1 of an edge: A |grad
//         S| to 5 u sum m, A S to (4/9) u sum (3 |h| m + 2 d0 |J|). The constants are fitted, not proved:
//         `bounds --kind polygon`.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace patchgrip::friction::kernels {

struct Vertex {
  double x;
  double y;
};

// A closed polygon boundary: rings one after another, the interior to the left. Edge i runs from vertex i to the next
// of its ring and has the outward unit normal (nx, ny)[i].
template <class Real>
struct Boundary {
  std::vector<Vertex> vertices;
  std::vector<std::size_t> ring_ends;
  std::vector<Real> nx, ny;
};

template <class Real>
Boundary<Real> make_boundary(const std::vector<std::vector<Vertex>>& rings) {
  using std::sqrt;
  Boundary<Real> boundary;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex& p = ring[i];
      const Vertex& q = ring[(i + 1) % ring.size()];
      const Real ex = Real(q.x) - Real(p.x);
      const Real ey = Real(q.y) - Real(p.y);
      const Real length = sqrt(ex * ex + ey * ey);
      boundary.vertices.push_back(p);
      boundary.nx.push_back(ey / length);
      boundary.ny.push_back(-ex / length);
    }
    boundary.ring_ends.push_back(boundary.vertices.size());
  }
  return boundary;
}

// int dt / d over [t0, t1] at the distance h != 0.
template <class Real>
inline Real edge_logarithm(const Real& t0, const Real& d0, const Real& t1, const Real& d1, const Real& h2) {
  using std::log;
  if (t0 >= 0) return log((t1 + d1) / (t0 + d0));
  if (t1 <= 0) return log((d0 - t0) / (d1 - t1));
  return log((t1 + d1) * (d0 - t0) / h2);
}

enum class Want { gradient, bound, hessian };

// A S, A grad S, A Hess S, and the sizes of their terms.
template <class Real>
struct EdgeSum {
  Real S{0};
  Real gx{0}, gy{0};
  Real xx{0}, xy{0}, yy{0};
  Real gradient_terms{0};  // sum m
  Real S_terms{0};         // sum 3 |h| m + 2 d0 |J|
};

template <Want want, class Real>
EdgeSum<Real> edge_sum(const Boundary<Real>& boundary, const Real& X, const Real& Y) {
  using std::abs;
  using std::sqrt;
  EdgeSum<Real> sum;
  const auto distance = [](const Real& x, const Real& y) -> Real { return sqrt(x * x + y * y); };
  std::size_t first = 0;
  for (const std::size_t end : boundary.ring_ends) {
    const Real x_first = Real(boundary.vertices[first].x) - X;
    const Real y_first = Real(boundary.vertices[first].y) - Y;
    const Real d_first = distance(x_first, y_first);
    Real px = x_first;
    Real py = y_first;
    Real d0 = d_first;
    for (std::size_t i = first; i < end; ++i) {
      const bool closing = i + 1 == end;
      const Real qx = closing ? x_first : Real(boundary.vertices[i + 1].x) - X;
      const Real qy = closing ? y_first : Real(boundary.vertices[i + 1].y) - Y;
      const Real d1 = closing ? d_first : distance(qx, qy);
      const Real& nx = boundary.nx[i];
      const Real& ny = boundary.ny[i];
      const Real h = nx * px + ny * py;
      const Real t0 = nx * py - ny * px;
      const Real t1 = nx * qy - ny * qx;
      const Real h2 = h * h;
      // At a vertex h is 0 but for rounding, and h^2 L with it.
      const Real L = h2 > 0 && d0 > 0 && d1 > 0 ? edge_logarithm<Real>(t0, d0, t1, d1, h2) : Real(0);
      const Real J = (t1 * d1 - t0 * d0 + h2 * L) / 2;
      sum.S += h * J;
      sum.gx -= nx * J;
      sum.gy -= ny * J;
      if constexpr (want == Want::bound) {
        const Real m = (abs(t1) * d1 + abs(t0) * d0 + h2 * L) / 2 + d0 * d1;
        sum.gradient_terms += m;
        sum.S_terms += 3 * abs(h) * m + 2 * d0 * abs(J);
      }
      if constexpr (want == Want::hessian) {
        const Real hL = h * L;
        const Real step = (t1 - t0) * (t1 + t0) / (d1 + d0);  // d1 - d0: an edge has a length, so d1 + d0 > 0
        const Real qx_n = nx * hL - ny * step;
        const Real qy_n = ny * hL + nx * step;
        sum.xx += qx_n * nx;
        sum.xy += (qx_n * ny + qy_n * nx) / 2;
        sum.yy += qy_n * ny;
      }
      px = qx;
      py = qy;
      d0 = d1;
    }
    first = end;
  }
  sum.S /= 3;
  return sum;
}

}  // namespace patchgrip::friction::kernels
