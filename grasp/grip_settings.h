// How a grip is solved, and when an answer counts as a verdict.
#pragma once

namespace patchgrip::grasp {

struct GripSettings {
  double relative_width = 1e-12;  // of the bracket that is asked for, in (0, 1)
  // Of the interior point before it is polished, shared by the contacts, in [1e-12, 1e-2]: states are told apart by
  // what each contact has of the gap, and Newton's method does the rest faster.
  double interior_tolerance = 1e-4;
  int max_iterations = 100;  // of the interior point, >= 1
  int max_repairs = 8;       // of the guess of what slips, >= 1
  double force_limit = 1e6;  // F over max(|f|, |m| / L) that no finger is expected to give, > 0

  // Throws std::invalid_argument, naming the setting.
  void check() const;
};

}  // namespace patchgrip::grasp
