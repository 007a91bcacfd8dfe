#include <patchgrip/cli/press/press_mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <patchgrip/cli/press/rounding.h>

namespace patchgrip::cli {
namespace {

using contact::MeshContact;
using contact::MeshCurvature;
using contact::TriangleMesh;

// In metres.
TriangleMesh read_mesh(const MeshSurface& surface) {
  TriangleMesh mesh = TriangleMesh::read(surface.file.string());
  if (surface.unit == 1) return mesh;
  std::vector<contact::Vector> vertices = mesh.vertices();
  for (auto& vertex : vertices) {
    for (double& coordinate : vertex) coordinate *= surface.unit;
  }
  return TriangleMesh::of(std::move(vertices), mesh.triangles());
}

contact::Vector point_of(const MeshSurface& surface) {
  contact::Vector point = surface.point;
  for (double& coordinate : point) coordinate *= surface.unit;
  return point;
}

// At the mesh's place in the scene, whatever is wrong with it.
MeshCurvature curvature_of(const MeshSurface& surface) {
  return at(surface.place, [&] {
    try {
      return contact::curvature_near(read_mesh(surface), point_of(surface));
    } catch (const std::runtime_error& error) {
      surface.place.refuse(error.what());
    }
  });
}

// Principal radii of a body by its fit; where the fit cannot tell a curvature from 0, that curvature.
void add_fit(std::vector<Result>& results, const std::string& body, const MeshCurvature& fit) {
  const double error = fit.curvature_error;
  int index = 0;
  for (const double k : {fit.curvatures.k_max, fit.curvatures.k_min}) {
    ++index;
    if (std::fabs(k) > 2 * error) {
      results.push_back(
          {fmt::format("{}_radius_{}", body, index), 1 / k, error / (std::fabs(k) * (std::fabs(k) - error)), "m"});
    } else {
      results.push_back({fmt::format("{}_curvature_{}", body, index), k, error, "1/m"});
    }
  }
}

double radius_of(const Shape& shape) {
  if (std::holds_alternative<Plane>(shape)) return std::numeric_limits<double>::infinity();
  if (const auto* ball = std::get_if<Ball>(&shape)) return ball->radius;
  throw std::invalid_argument("a mesh presses on a ball, a hollow, a plane or another mesh");
}

}  // namespace

MeshContact mesh_contact(const BodyPair& pair, const Place& bodies) {
  const auto* first = std::get_if<MeshSurface>(&pair.first.shape);
  const auto* second = std::get_if<MeshSurface>(&pair.second.shape);
  const MeshSurface& mesh = first != nullptr ? *first : *second;
  const MeshCurvature curvature = curvature_of(mesh);
  if (first != nullptr && second != nullptr) {
    const MeshCurvature other = curvature_of(*second);
    return at(bodies, [&] { return MeshContact::between(curvature, other); });
  }
  const Shape& other = first != nullptr ? pair.second.shape : pair.first.shape;
  const double radius = at(bodies, [&] { return radius_of(other); });
  return at(mesh.place, [&] { return MeshContact::with_ball(curvature, radius); });
}

bool has_mesh(const BodyPair& pair) {
  return std::holds_alternative<MeshSurface>(pair.first.shape) ||
         std::holds_alternative<MeshSurface>(pair.second.shape);
}

Pressed press_mesh(const BodyPair& pair, double modulus, const PressScene& scene) {
  const auto& load = std::get<StaticLoad>(scene.load);
  if (load.kind != LoadKind::normal_force) load.place.refuse("a mesh takes 'normal_force'");
  const MeshContact contact = mesh_contact(pair, scene.subject_place);
  const auto pressed = contact.under_force(load.value, modulus);
  const auto& e = pressed.ellipse;
  // delta = (3/2) F / stiffness.
  const double stiffness_error = e.stiffness * pressed.approach_error / (e.approach - pressed.approach_error);
  const auto relative_radius = [&](const char* name, double radius) {
    return Result{name, radius, radius * radius * contact.curvature_error / (1 - radius * contact.curvature_error),
                  "m"};
  };
  Pressed result{{{"hertz_ellipse",
                   {{"semi_axis_a", e.a, pressed.a_error, "m"},
                    {"semi_axis_b", e.b, pressed.b_error, "m"},
                    {"normal_force", e.normal_force, 0, "N"},
                    {"approach", e.approach, pressed.approach_error, "m"},
                    {"peak_pressure", e.peak_pressure, pressed.peak_pressure_error, "Pa"},
                    {"stiffness", e.stiffness, stiffness_error, "N/m"},
                    relative_radius("radius_large", contact.radii.large),
                    relative_radius("radius_small", contact.radii.small),
                    within("contact_modulus", modulus, 1.01, "Pa")},
                   "by the curvature of the mesh; errors are those of its fit"},
                  {},
                  {}},
                 e.a,
                 [p = e.elliptic_pressure(), error = pressed](double x, double y) -> SurfacePoint {
                   const double value = p.pressure(x, y);
                   const double rho2 = std::pow(x / p.a, 2) + std::pow(y / p.b, 2);
                   // What the axes may do to rho^2; beyond that there is no pressure.
                   const double axes = std::max(error.a_error / p.a, error.b_error / p.b) + 4 * unit;
                   if (!(axes < 1)) return {{value, p.peak_pressure + error.peak_pressure_error}};
                   const double moved = rho2 * axes * (2 - axes) / std::pow(1 - axes, 2);
                   if (rho2 > 1 + moved) return {{0, 0}};
                   const double peak = p.peak_pressure + error.peak_pressure_error;
                   const double height = std::min(std::sqrt(moved), moved * p.peak_pressure / value);
                   return {{value, (error.peak_pressure_error / p.peak_pressure + 4 * unit) * value + peak * height}};
                 }};
  result.knows_displacement = false;
  auto& results = result.answer.main.results;
  const bool first_is_mesh = std::holds_alternative<MeshSurface>(pair.first.shape);
  add_fit(results, first_is_mesh ? "body_a" : "body_b", contact.first);
  if (first_is_mesh && std::holds_alternative<MeshSurface>(pair.second.shape)) {
    add_fit(results, "body_b", contact.second);
  }
  warn_if_steep(result.answer, Steepness::of_mesh(contact, e.a, e.b));
  return result;
}

}  // namespace patchgrip::cli
