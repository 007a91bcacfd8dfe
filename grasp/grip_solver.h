// Solves one of the problems of grip_problem.h: interior point, polish, bracket.
//
//     range            what no contact resists of the load is a proof that it cannot be held
//     interior point   to interior_tolerance, then again two digits further while the bracket stays open; or until its
//                      twist proves that the load cannot be held
//     polish           Newton on the exact D, from what the interior point says slips, sticks and opens
//     bracket          of the polished twist and forces; else of those of the interior point put into balance
//     64 bits          where the bracket is still open and the contacts are points and soft fingers (extended_polish.h)
//     quadratic grip   where nothing was decided so far: it guesses nothing, and finds forces or a certificate close to
//                      the boundary of what can be held (quadratic_grip.h)
//
// The bracket is all that counts: no answer rests on a flag of a solver.
//
// Memory   allocated by the constructor; nothing after.
#pragma once

#include <patchgrip/grasp/bracket.h>
#include <patchgrip/grasp/extended_polish.h>
#include <patchgrip/grasp/grip_settings.h>
#include <patchgrip/grasp/interior_point.h>
#include <patchgrip/grasp/load_path.h>
#include <patchgrip/grasp/polish.h>
#include <patchgrip/grasp/quadratic_grip.h>

namespace patchgrip::grasp {

// What closed the bracket, or was done last.
enum class Route { no_load, range, ray, warm, polished, interior, extended, quadratic };

struct Effort {
  Route route = Route::interior;
  int iterations = 0;  // of the interior point
  int newton_steps = 0;
  int repairs = 0;
};

class GripSolver {
 public:
  GripSolver(const ScaledGrasp& grasp, const GripSettings& settings);

  // From nothing; or, after a polished problem of the same objective, from its states and from where the path of such
  // loads leads to: for loads that change little under the same limits.
  void solve(const GripProblem& problem, bool warm) noexcept;

  // The largest share of the upper bound that a charge of first order may be for it to count.
  static constexpr double largest_charge = 1e-3;

  const Bracket& bracket() const noexcept { return bracket_; }
  const Polish& polish() const noexcept { return polish_; }
  const Effort& effort() const noexcept { return effort_; }

 private:
  bool closed() const noexcept { return bracket_.width() <= settings_.relative_width; }
  bool cannot() const noexcept;
  bool try_warm() noexcept;
  void polish(int max_repairs) noexcept;
  void solve_conic() noexcept;
  void solve_conic(double settled_gap) noexcept;
  void bracket_polish() noexcept;
  void bracket_interior() noexcept;
  void bracket_extended() noexcept;
  void bracket_quadratic() noexcept;
  bool decided() const noexcept;

  const ScaledGrasp* grasp_;
  GripSettings settings_;
  GripProblem problem_{};
  InteriorPoint interior_;
  Polish polish_;
  LoadPath path_;
  ExtendedPolish extended_;
  QuadraticGrip quadratic_;
  Bracket bracket_;
  Effort effort_;
  std::vector<PartForce> forces_;
  bool polished_ = false;  // the states are those of a solution
};

}  // namespace patchgrip::grasp
