// The limit surface as files for other programs.
//
// VTK   legacy PolyData as text (ParaView, PyVista, meshio): points (fx [N], fy [N], m / L [N]), cells with outward
//       NORMALS in these coordinates; point data: slip (vx [m/s], vy [m/s], w [rad/s]), whose pole is (-vy, vx) / w,
//       and pole_share = d / (d + i), d the distance of the pole from the centroid and i the radius of gyration: 0
//       turns about the centroid, 1 is a translation.
// CSV   one row a point, numbers with 17 significant digits; the pole of a translation is infinite, as in `tabulate`.
//
// Where friction is not given, forces are per mu F_N.
//
// Throws   Interrupted
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/limit/limit_mesh.h>
#include <patchgrip/cli/table.h>

namespace patchgrip::cli {

std::string to_vtk(const LimitMesh& mesh, std::string_view title);

Table surface_rows(const LimitMesh& mesh, bool per_friction_force);

}  // namespace patchgrip::cli
