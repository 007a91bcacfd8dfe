// Linear pressures on convex polygons in 80 digits, piece by piece: reference of sampled patches.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include <patchgrip/friction/kernels/edge_sum.h>
#include <patchgrip/friction/sampled/pressure_grid.h>
#include <patchgrip/friction/sampled/pressure_mesh.h>
#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {

class SampledReference {
 public:
  using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<80>, boost::multiprecision::et_off>;

  // Counter-clockwise; p = level + gx x + gy y.
  struct Piece {
    std::vector<std::array<Real, 2>> corners;
    Real level, gx, gy;
  };

  static SampledReference of(const PressureCells& cells) {
    SampledReference reference;
    for (std::size_t j = 0; j < cells.ny; ++j) {
      for (std::size_t i = 0; i < cells.nx; ++i) {
        const double p = cells.pressures[j * cells.nx + i];
        if (p == 0) continue;
        const Real x0 = cells.x0 + Real(i) * cells.dx, x1 = cells.x0 + Real(i + 1) * cells.dx;
        const Real y0 = cells.y0 + Real(j) * cells.dy, y1 = cells.y0 + Real(j + 1) * cells.dy;
        reference.add({{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, p, 0, 0});
      }
    }
    return reference;
  }

  static SampledReference linear(const Triangulation& mesh, const std::vector<double>& p) {
    return of(mesh, [&](std::size_t, std::size_t corner) { return p[corner]; });
  }
  static SampledReference constant(const Triangulation& mesh, const std::vector<double>& p) {
    return of(mesh, [&](std::size_t triangle, std::size_t) { return p[triangle]; });
  }

  // Force and its first moments by the divergence theorem: int p dA etc. of polynomials of degree <= 2.
  void add(const Piece& piece) {
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
      const auto& a = piece.corners[i];
      const auto& b = piece.corners[(i + 1) % piece.corners.size()];
      // The triangle (0, a, b): midpoints of the edges integrate degree 2.
      const Real area = (a[0] * b[1] - a[1] * b[0]) / 2;
      for (const auto& [x, y] : {std::array{a[0] / 2, a[1] / 2}, std::array{b[0] / 2, b[1] / 2},
                                 std::array{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}}) {
        const Real p = (piece.level + piece.gx * x + piece.gy * y) * area / 3;
        force_ += p;
        x_ += p * x;
        y_ += p * y;
      }
    }
    pieces_.push_back(piece);
  }

  // Not at rest.
  Wrench50 gradient(const Real50& vx, const Real50& vy, const Real50& w) const {
    if (w == 0) {
      const Real50 V = sqrt(vx * vx + vy * vy);
      return {vx / V, vy / V, Real50((x_ * Real(vy) - y_ * Real(vx)) / (force_ * Real(V)))};
    }
    const Real X = -Real(vy) / Real(w);
    const Real Y = Real(vx) / Real(w);
    Real S = 0, Sx = 0, Sy = 0;
    for (const Piece& piece : pieces_) add(piece, X, Y, S, Sx, Sy);
    const Real k = (w < 0 ? -1 : 1) / force_;
    return {Real50(k * Sy), Real50(-k * Sx), Real50(k * (S - X * Sx - Y * Sy))};
  }
  Wrench50 gradient(const Twist& v) const { return gradient(v.vx, v.vy, v.w); }

  Hessian hessian(const Twist& v, double length) const {
    return hessian_by_differences([this](const auto& vx, const auto& vy, const auto& w) { return gradient(vx, vy, w); },
                                  v, length);
  }

 private:
  template <class PressureOf>
  static SampledReference of(const Triangulation& mesh, const PressureOf& pressure_of) {
    SampledReference reference;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
      std::array<std::array<Real, 2>, 3> P;
      std::array<Real, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t corner = mesh.triangles[k][i];
        P[i] = {mesh.points[corner].x, mesh.points[corner].y};
        p[i] = pressure_of(k, corner);
      }
      Real ax = P[1][0] - P[0][0], ay = P[1][1] - P[0][1], bx = P[2][0] - P[0][0], by = P[2][1] - P[0][1];
      const Real cross = ax * by - ay * bx;
      const Real gx = ((p[1] - p[0]) * by - (p[2] - p[0]) * ay) / cross;
      const Real gy = ((p[2] - p[0]) * ax - (p[1] - p[0]) * bx) / cross;
      if (cross < 0) std::swap(P[1], P[2]);
      reference.add({{P.begin(), P.end()}, p[0] - gx * P[0][0] - gy * P[0][1], gx, gy});
    }
    return reference;
  }

  static void add(const Piece& piece, const Real& X, const Real& Y, Real& S, Real& Sx, Real& Sy) {
    const Real pM = piece.level + piece.gx * X + piece.gy * Y;
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
      const auto& a = piece.corners[i];
      const auto& b = piece.corners[(i + 1) % piece.corners.size()];
      const Real ex = b[0] - a[0], ey = b[1] - a[1], l = sqrt(ex * ex + ey * ey);
      const Real nx = ey / l, ny = -ex / l;
      const Real h = nx * (a[0] - X) + ny * (a[1] - Y);
      const Real t0 = nx * (a[1] - Y) - ny * (a[0] - X), t1 = t0 + l;
      const Real d0 = sqrt(h * h + t0 * t0), d1 = sqrt(h * h + t1 * t1);
      const Real L = h != 0 ? kernels::edge_logarithm<Real>(t0, d0, t1, d1, h * h) : Real(0);
      const Real J1 = (t1 * d1 - t0 * d0 + h * h * L) / 2;
      const Real J3 = (t1 * d1 * d1 * d1 - t0 * d0 * d0 * d0) / 4 + h * h * J1 * 3 / 4;
      const Real K1 = (d1 * d1 * d1 - d0 * d0 * d0) / 3;
      const Real gn = piece.gx * nx + piece.gy * ny, gt = -piece.gx * ny + piece.gy * nx;
      const Real term = (pM + h * gn) * J1 + gt * K1;
      S += (pM * h * J1 + gn * J3) / 3;
      Sx += piece.gx * h * J1 / 3 - nx * term;
      Sy += piece.gy * h * J1 / 3 - ny * term;
    }
  }

  std::vector<Piece> pieces_;
  Real force_{0}, x_{0}, y_{0};
};

struct WrenchError {
  double force, moment;
};

inline WrenchError error_of(const Wrench& g, const Wrench50& exact) {
  const Real50 dx = g.fx - exact.fx, dy = g.fy - exact.fy;
  return {static_cast<double>(sqrt(dx * dx + dy * dy)), static_cast<double>(abs(g.m - exact.m))};
}

}  // namespace patchgrip::friction
