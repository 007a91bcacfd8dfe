// The ellipsoid of least volume about a centrally symmetric set of points (Loewner), by CGAL's Khachiyan iteration.
#pragma once

#include <array>
#include <vector>

namespace patchgrip::friction {

// Upper triangle (xx, xy, xz, yy, yz, zz) of the matrix A of {p : p . A p <= 1}, which holds every point and its
// negative. Its volume exceeds the least by <= `excess_volume`, relative. The points are not in one plane with 0.
std::array<double, 6> enclosing_ellipsoid(const std::vector<std::array<double, 3>>& points, double excess_volume);

}  // namespace patchgrip::friction
