// What `patchgrip grasp` says: of every load, of the grasp alone, or of a family of grasps.
//
// Error    the bracket of each answer, member of a family and held ball. Where a patch follows from bodies and its D is
//          known to a relative error, the bracket is that of the grasps with as much less and as much more friction.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/grasp/grasp_scene.h>
#include <patchgrip/cli/table.h>
#include <patchgrip/grasp/growing_grip.h>
#include <patchgrip/grasp/internal_forces.h>

namespace patchgrip::cli {

constexpr std::size_t most_grasp_loads_listed = 1000;  // in JSON

struct GraspLoadAnswer {
  grasp::Vector6 load;     // with the weight of the object; of the load factors, what is multiplied
  grasp::GripAnswer grip;  // of growing_grip, that of the upper bound
  double lower, upper;     // of the value
  grasp::Verdict verdict;
};

struct FamilyMember {
  double value;  // of the parameter
  grasp::Verdict verdict;
  double grip, lower, upper;  // [N]
};

struct GraspAnswer {
  std::vector<GraspLoadAnswer> loads;
  std::optional<grasp::HeldBall> ball;
  std::optional<grasp::InternalForces> internal;
  int simplices = 0;  // halved in search of the worst load
  std::vector<FamilyMember> family;
  std::vector<double> boundaries;  // of the family: where it stops holding, or starts to
  std::vector<std::string> warnings;
};

// Throws SceneError and Interrupted.
GraspAnswer answer_grasp(const GraspScene& scene);

// One JSON object with a line break at the end.
std::string to_json(const GraspAnswer& answer, const GraspScene& scene, std::string_view scene_path);

// What the twist of an answer is divided by: a certificate has no scale of its own, its size is made 1 with spins times
// the length.
double pace_of(const GraspLoadAnswer& load, const GraspScene& scene);

// A row a load or, of a family, a member.
Table grasp_rows(const GraspAnswer& answer, const GraspScene& scene);

// The unit of what is asked for, and of the forces of the answer.
std::string_view unit_of(GraspQuestion question);

}  // namespace patchgrip::cli
