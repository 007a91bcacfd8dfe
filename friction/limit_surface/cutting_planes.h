// The gauge by tangent planes alone: for loads that start a slip at which D has a kink.
//
// Every gradient g_i seen bounds D from below, D(v) >= g_i . v, so that
//
//     g(t) <= max { t . v : g_i . v <= 1 } = min { sum of b_i : sum of b_i g_i = t, b_i >= 0 }
//
// Three gradients attain it, a triangle of the body B that the load's ray meets; v is where their planes meet. The
// gradient at v is the next one and takes the place of that of the three that keeps the ray within (simplex method).
// With a point load at the pole the three end up on its facet, around the load.
//
// Domain   patches whose kinks are not told (point_shares.h), and loads whose slip lies between several kinks.
// Units    gradients (fx, fy, m / length) [1], twists (vx, vy, w length) [m/s] about the centroid (pressure_frame.h).
// Error    the three gradients and the load's residual carry it: gauge_solver.cc adds them up. Next to a kink rounding
//          of the gradient leaves a bracket about 1e-8 wide.
#pragma once

#include <array>
#include <cstddef>

#include <patchgrip/friction/limit_surface/vector3.h>

namespace patchgrip::friction {

class CuttingPlanes {
 public:
  // How uncertain a gradient is.
  struct Plane {
    Vector g;
    double force_error;
    double moment_error;  // [m]
  };

  // `turning` is the gradient of a rotation about the centroid: with two translations it makes the first triangle.
  CuttingPlanes(const Vector& load, const Plane& turning) noexcept : load_(load) {
    const double sense = load[2] < 0 ? -1 : 1;
    const double b = load[2] / turning.g[2];
    const double x = load[0] - b * turning.g[0], y = load[1] - b * turning.g[1];
    planes_[0] = {{x < 0 ? -1.0 : 1.0, 0, 0}, 0, 0};
    planes_[1] = {{0, y < 0 ? -1.0 : 1.0, 0}, 0, 0};
    planes_[2] = turning;
    for (double& c : planes_[2].g) c *= sense;
    solve();
  }

  const std::array<Plane, 3>& planes() const noexcept { return planes_; }
  const Vector& weights() const noexcept { return weights_; }
  const Vector& twist() const noexcept { return twist_; }  // where the three planes meet: g_i . v = 1

  // False if the triangle stays as it is.
  bool add(const Plane& plane) noexcept {
    const Vector d = coordinates(plane.g);
    std::size_t out = 3;
    double least = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (d[i] > 0 && (out == 3 || weights_[i] < least * d[i])) out = i, least = weights_[i] / d[i];
    }
    if (out == 3) return false;
    const CuttingPlanes before = *this;
    planes_[out] = plane;
    if (solve()) return true;
    *this = before;
    return false;
  }

 private:
  Vector coordinates(const Vector& t) const noexcept {
    return {dot(t, normals_[0]), dot(t, normals_[1]), dot(t, normals_[2])};
  }

  bool solve() noexcept {
    const Vector &a = planes_[0].g, &b = planes_[1].g, &c = planes_[2].g;
    normals_ = {cross(b, c), cross(c, a), cross(a, b)};
    const double volume = dot(a, normals_[0]);
    if (!(volume != 0)) return false;
    for (std::size_t j = 0; j < 3; ++j) {
      for (Vector& n : normals_) n[j] /= volume;
      twist_[j] = normals_[0][j] + normals_[1][j] + normals_[2][j];
    }
    weights_ = coordinates(load_);
    for (double& w : weights_) w = w > 0 ? w : 0;
    return true;
  }

  Vector load_;
  std::array<Plane, 3> planes_;
  std::array<Vector, 3> normals_;  // dual to the three gradients
  Vector weights_;
  Vector twist_;
};

}  // namespace patchgrip::friction
