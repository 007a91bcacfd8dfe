// Solves the linear matrix inequalities of a grip with SDPA, a solver that shares nothing with the one of this folder.
//
// Optional: the library patchgrip::grasp_lmi, which is there where SDPA is installed (Debian: libsdpa-dev). One thread.
//
//     solved        both problems to the tolerance
//     cannot_hold   SDPA found the problem of the twist unbounded, above 1e5 units, or that of the forces infeasible
//     unsolved      SDPA stopped before either: value, twist and forces are where it stood
//
// [lower, upper] are the values of its twist and of its forces: SDPA's word, nothing of it is proved. The tolerance is
// relative to the larger of value and unit of force in the gap, and absolute in the equalities.
//
// Units    as contact.h and spatial.h.
// Error    about 1e-6 of the value: asked for 1e-7, SDPA 7.3.16 mostly stops at a gap of 5e-7, unsolved, and says "Strange
//          behavior" on the standard output; tests/grasp/lmi_solver_test.cc.
// Throws   std::invalid_argument unless the settings are in their ranges.
#pragma once

#include <patchgrip/grasp/lmi.h>

namespace patchgrip::grasp {

struct LmiSettings {
  double tolerance = 1e-6;   // of gap and equalities, in [1e-12, 1e-2]
  int max_iterations = 100;  // >= 1

  // Throws std::invalid_argument, naming the setting.
  void check() const;
};

struct LmiAnswer {
  enum class Status { solved, cannot_hold, unsolved };

  Status status = Status::unsolved;
  double lower = 0;  // of the twist [N]
  double upper = 0;  // of the forces [N]
  Vector6 twist = Vector6::Zero();
  std::vector<ContactForce> forces;
  int iterations = 0;
};

LmiAnswer solve(const GripLmi& lmi, const LmiSettings& settings = {});

}  // namespace patchgrip::grasp
