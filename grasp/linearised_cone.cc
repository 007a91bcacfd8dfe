#include <patchgrip/grasp/linearised_cone.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <patchgrip/contact/require.h>
#include <patchgrip/grasp/bracket.h>
#include <patchgrip/grasp/interior_point.h>

namespace patchgrip::grasp {
namespace {

using Model = FrictionCone::Model;

void require_edges(int edges) {
  if (edges % 4 != 0 || edges < 4 || edges > 1024)
    contact::refuse("edges", edges, "must be a multiple of 4 in [4, 1024]");
}

void require_cuttable(const FrictionCone& cone) {
  if (cone.model() == Model::patch && cone.has_friction())
    throw std::invalid_argument("an exact patch is not allowed: must be frictionless, point or soft");
}

// On the parallel at `latitude` of the ellipsoid with radius mu in force, mu e in moment.
void add_round(std::vector<Vector3>& edges, int count, const Vector3& radii, double latitude) {
  for (int j = 0; j < count; ++j) {
    const double phi = 2 * std::numbers::pi * j / count;
    edges.push_back(radii.cwiseProduct(
        Vector3(std::cos(phi) * std::cos(latitude), std::sin(phi) * std::cos(latitude), std::sin(latitude))));
  }
}

}  // namespace

double cut_factor(const FrictionCone& cone, int edges) {
  require_edges(edges);
  require_cuttable(cone);
  if (!cone.has_friction() || cone.model() == Model::frictionless) return 1;
  const double half = std::numbers::pi / edges;
  if (cone.model() != Model::soft_elliptic) return std::cos(half);
  return std::cos(half) / std::hypot(1, std::sin(half));
}

std::vector<Vector3> cone_edges(const FrictionCone& cone, int edges, CutSide side) {
  const double c = cut_factor(cone, edges);
  if (!cone.has_friction() || cone.model() == Model::frictionless) return {Vector3::Zero()};
  const double mu = side == CutSide::inner ? cone.mu() : cone.mu() / c;
  const Vector3 radii(mu, mu, mu * cone.moment_length());
  std::vector<Vector3> all;
  add_round(all, edges, radii, 0);
  if (cone.model() == Model::point) return all;
  all.emplace_back(0, 0, radii[2]);
  all.emplace_back(0, 0, -radii[2]);
  if (cone.model() == Model::soft_linear) return all;
  for (int i = 1; i < edges / 4; ++i) {
    add_round(all, edges, radii, 2 * std::numbers::pi * i / edges);
    add_round(all, edges, radii, -2 * std::numbers::pi * i / edges);
  }
  return all;
}

LinearisedGrip linearised_least_grip(const std::vector<Contact>& contacts, const Vector6& load, int edges, CutSide side,
                                     const GripSettings& settings) {
  settings.check();
  require_edges(edges);
  for (const double x : load) contact::require_finite("load", x);
  std::vector<std::vector<Vector3>> rays;
  for (const Contact& c : contacts) rays.push_back(cone_edges(c.cone(), edges, side));
  const ScaledGrasp grasp(contacts, rays);
  const Vector6 w = grasp.scaled_load(load);
  const double size = w.norm();
  LinearisedGrip answer;
  answer.forces.resize(contacts.size());
  if (size == 0) return answer;

  const std::vector<double> limits(contacts.size(), 1);
  const GripProblem problem{&grasp, Objective::max_force, w / size, Vector6::Zero(), limits};
  Bracket bracket(grasp);
  bracket.reset(problem);
  const Vector6 off = grasp.unresisted() * problem.load;
  if (off.norm() > 100 * grasp.rounding()) bracket.add_twist(off);
  InteriorPoint interior(grasp);
  interior.start(problem);
  std::vector<PartForce> forces(grasp.parts().size());
  // Step by step: where few edges bear, the matrix of the twist becomes singular before the tolerance is met.
  constexpr double width = 1e-8;
  for (const double share : {1e2, 3e1, 1e1, 3., 1., 0.3, 0.1}) {
    const double tolerance = share * width;
    const InteriorPoint::Status status = interior.run(tolerance, tolerance, settings.max_iterations);
    bracket.add_twist(interior.twist());
    if (status == InteriorPoint::Status::infeasible || bracket.lower() > settings.force_limit) break;
    if (!interior.balance()) break;
    for (std::size_t i = 0; i < forces.size(); ++i) forces[i].force = std::max(interior.part(i).force, 0.0);
    bracket.add_forces(forces, interior.value());
    if (status == InteriorPoint::Status::stalled || bracket.width() < width) break;
  }

  answer.lower = size * bracket.lower();
  answer.upper = size * bracket.upper();
  answer.escape_twist = grasp.twist(bracket.twist());
  answer.iterations = interior.iterations();
  std::vector<std::size_t> edge(contacts.size(), 0);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const std::size_t c = grasp.parts()[i].contact;
    const double F = size * bracket.forces()[i].force;
    answer.forces[c].normal += F;
    answer.forces[c].friction += F * rays[c][edge[c]++];
  }
  return answer;
}

}  // namespace patchgrip::grasp
