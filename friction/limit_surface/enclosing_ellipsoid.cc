#include <patchgrip/friction/limit_surface/enclosing_ellipsoid.h>

#include <CGAL/Approximate_min_ellipsoid_d.h>
#include <CGAL/Approximate_min_ellipsoid_d_traits_3.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Simple_cartesian.h>

namespace patchgrip::friction {

std::array<double, 6> enclosing_ellipsoid(const std::vector<std::array<double, 3>>& points, double excess_volume) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Traits = CGAL::Approximate_min_ellipsoid_d_traits_3<Kernel, CGAL::MP_Float>;
  std::vector<Kernel::Point_3> both;
  both.reserve(2 * points.size());
  for (const auto& [x, y, z] : points) {
    both.emplace_back(x, y, z);
    both.emplace_back(-x, -y, -z);
  }
  const CGAL::Approximate_min_ellipsoid_d<Traits> ellipsoid(excess_volume, both.begin(), both.end());
  // p . M p + p . m + mu <= 1 with m = 0 by symmetry, up to rounding and the iteration: both are left to the scale.
  std::array<double, 6> A{};
  std::size_t k = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) A[k++] = ellipsoid.defining_matrix(i, j);
  }
  double largest = 0;
  for (const auto& p : points) {
    const double size = p[0] * (A[0] * p[0] + 2 * (A[1] * p[1] + A[2] * p[2])) +
                        p[1] * (A[3] * p[1] + 2 * A[4] * p[2]) + A[5] * p[2] * p[2];
    largest = std::max(largest, size);
  }
  for (double& entry : A) entry /= largest;
  return A;
}

}  // namespace patchgrip::friction
