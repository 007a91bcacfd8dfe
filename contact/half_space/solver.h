// Pressure between a half-space and a rigid shape on one grid: a quadratic programme with bounds.
//
//     g = u_z + f - delta,   p >= 0,  g >= 0,  p g = 0,  u_z = K p / E*   (Kalker 1977; Polonsky, Keer, Wear 231, 1999)
//
// f is the gap before contact, delta the approach: either delta is given, or the sum of p. Method: Newton's on the set
// A = {p > 0 or g < 0} (Hintermueller, Ito, Kunisch, SIAM J. Optim. 13, 2002); in it K p = delta - f by conjugate
// gradients, preconditioned (preconditioner.h) and stopped early, p free to turn negative until they stop. A given load
// is kept by projection of the directions. One product with K a step; g is kept by recursion, and formed anew whenever
// p was cut at zero, and at the end if rounding could matter.
//
// Converged when    residual = max(rms of g over A, largest -g outside) / s <= tolerance,
//                   s = max(delta - least f, standard deviation of f over A).
// Then F, or delta, is good to two residuals, relative (Hertz' contact; tests/contact/contact_solver_test.cc).
//
// Units    f, g, delta [m]; the pressure here is p / E* [1], the load sum(p) / E*.
// Throws   std::runtime_error when max_iterations steps do not reach the tolerance, with the residual. What the
//          observer throws passes through.
#pragma once

#include <functional>
#include <span>

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/pieces.h>
#include <patchgrip/contact/half_space/preconditioner.h>
#include <patchgrip/contact/half_space/resources.h>

namespace patchgrip::contact {

// Where a solution is: called once a step. It may throw to stop.
struct SolverProgress {
  Grid grid;
  int iteration;    // on this grid
  double residual;  // of the contact set in use, relative
};
using SolverObserver = std::function<void(const SolverProgress&)>;

enum class Prescribed { approach, load };

struct SolverStatus {
  double residual;
  int iterations;   // steps of conjugate gradients
  int sets;         // contact sets tried
  double products;  // of this solver so far, with K; one of the preconditioner counts 1/4 (1 on a periodic surface)
  double approach;  // [m]
};

class ContactSolver {
 public:
  // Enough for the fields of one on a free surface, its gap and pressure, and those of all coarser grids.
  static constexpr std::size_t bytes_per_cell = 160;
  // What is used of it in any case.
  static constexpr std::size_t least_bytes_per_cell = 80;

  ContactSolver(const Grid& grid, Surface surface, std::span<const double> gap, Resources resources);

  // Changes `pressure`, the start, into the solution. `value` is the approach [m], or the sum of p / E*, > 0. Allocates
  // nothing.
  SolverStatus solve(Prescribed prescribed, double value, double tolerance, int max_iterations,
                     const SolverObserver& observer, std::span<double> pressure);

  // The residual of a pressure, whose sum is brought to a given load.
  double residual_of(Prescribed prescribed, double value, std::span<double> pressure);

  // Sum of q, where K q = 1 in the cells with p > 0 and q = 0 elsewhere: how the sum of p grows with the approach
  // [1/m].
  double stiffness(std::span<const double> pressure, double tolerance, int max_iterations,
                   const SolverObserver& observer);

 private:
  void begin(Prescribed prescribed, double value, std::span<double> p);
  void form_displacement(Prescribed prescribed, std::span<const double> p);
  bool choose_set(bool fresh, std::span<const double> p);
  void step(Prescribed prescribed, bool with_last_direction, std::span<double> p);
  bool cut(Prescribed prescribed, double load, std::span<double> p);
  void apply_preconditioner(const double* r, double* Mr);
  void prepare_load_projection();

  Grid grid_;
  Surface surface_;
  std::span<const double> gap_;
  double least_gap_;
  Workers& workers_;
  Pieces pieces_;
  Convolution product_;
  Preconditioner preconditioner_;

  Array<double> g_;          // g
  Array<double> direction_;  // d, zero outside A
  Array<double> work_;       // -g in A, then M of it, then K d
  Array<double> on_;         // 1 in A, else 0
  Array<double> uniform_;    // M 1_A in A, for a given load

  double approach_ = 0;
  double scale_ = 0;         // s
  double set_size_ = 0;      // cells of A
  double set_residual_ = 0;  // rms of g over A [m]
  double residual_ = 0;
  double uniform_sum_ = 0;
  double residual_product_ = 0;  // r . M r
  double products_ = 0;          // since construction
};

}  // namespace patchgrip::contact
