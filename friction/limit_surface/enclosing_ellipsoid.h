// The ellipsoid of least volume about a centrally symmetric set of points (Loewner), by CGAL's Khachiyan iteration.
//
//     {p : p . A p <= 1}, A positive definite,  det A -> max      such that p_i . A p_i <= 1 for all points p_i
//
// Domain   finite points that span space: not all in one plane with 0.
// Units    p in any, A in their inverse square.
// Error    volume above the least by <= `excess_volume`, relative; the largest p_i . A p_i is 1 to rounding.
// Throws   nothing; points in a plane give an A that is not positive definite.
#pragma once

#include <array>
#include <vector>

namespace patchgrip::friction {

// Upper triangle of A: xx, xy, xz, yy, yz, zz. `excess_volume` > 0.
std::array<double, 6> enclosing_ellipsoid(const std::vector<std::array<double, 3>>& points, double excess_volume);

}  // namespace patchgrip::friction
