// The claim that two solvers agree where both solve a case: GetFEM and CalculiX, other elements, another contact.
//
//     | c (q - l) / s - (q' - l') / s' |  <=  |c| e / s + e' / s'      for every entry of a quantity
//
// q, e what a solver found and its estimate of its own error, l the library's value and s its scale. c = 1 where both
// find the same quantity. GetFEM is given a force and finds an approach, CalculiX the other way round: F ~ delta^n, and
// an approach too large by a share is a force too small by n times that, c = -n.
#pragma once

#include <span>
#include <string_view>

#include <patchgrip/verification/claims/stored_run.h>

namespace patchgrip::verification {

struct SolverPair {
  std::string_view first, first_quantity;    // GetFEM: name of a case, and of what it finds
  std::string_view second, second_quantity;  // CalculiX
  double factor;                             // c
};

struct Agreement {
  double apart, bound;  // of the entry that exhausts its bound most, relative to the scale
  bool is_within_bound;
};

std::span<const SolverPair> solver_pairs();

// Throws std::out_of_range where a run is of another case or lacks the quantity.
Agreement agreement(const SolverPair& pair, const StoredRun& first, const StoredRun& second);

}  // namespace patchgrip::verification
