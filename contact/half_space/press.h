// A rigid shape pressed on an elastic half-space (or two elastic bodies on each other), for any gap z = f(x, y).
//
//     u_z + f - delta >= 0,   p >= 0,   p (u_z + f - delta) = 0
//     u_z = (1 / pi E*) integral p / r dA                                                    (seed 4.6; Johnson 5.9)
//
// Solved for the pressure p on a grid, from coarse grids to the one given (solver.h): force F or approach delta is
// prescribed, the contact may have any number of zones. On a free surface the gap is that of the grid alone, outside of
// it nothing touches; on a periodic one the grid repeats without end, F is the force on one period, and delta counts
// from the mean surface.
//
// Domain   half-space theory: slopes small. Gap in any datum: delta > least f. On a periodic surface nx and ny are
//          even, and the force is prescribed. Magnitudes of f, delta - least f, E* and F / (E* dx dy) up to 1e100,
//          above 1e-100 but for f.
// Units    f, delta [m], p, E* [Pa], F [N], areas [m^2].
// Error    of each value an estimate: the difference to the grid with half as many cells a side, over 2.4, or what a
//          Hertz contact of as many cells is off by, if that is more, and the solver's residual; of areas see
//          contact_edge.h. Force and approach of a Hertz contact of 50 cells across or more: right within a factor 3;
//          of 3 cells across or more: true errors up to 3 times the estimate, of the peak too. Peak and area of large
//          contacts: by chance far below (tests/contact/press_test.cc). Infinite where the coarser grid has no contact,
//          or not this zone: what touches in one or two cells may carry hundreds of times the value.
// Fails    on a rough surface that the grid does not resolve: the estimates then show it.
// Throws   std::invalid_argument outside the domain; std::domain_error if the contact touches the border of a free
//          grid; std::runtime_error, with the residual, if a grid does not converge; std::bad_alloc, std::system_error
//          when a thread cannot be started. What the observer throws passes through.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/contact/estimate.h>
#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/solver.h>

namespace patchgrip::contact {

// What is prescribed, and how much of it.
struct Press {
  static Press by_force(double force);        // F [N] > 0
  static Press by_approach(double approach);  // delta [m], above the least gap

  Prescribed prescribed;
  double value;
};

struct PressSettings {
  double tolerance = 1e-6;    // of the residual (solver.h), in [1e-12, 1e-2]
  int max_iterations = 500;   // on each grid, >= 1
  int threads = 2;            // in [1, 64]; grids of less than 100 x 100 cells use one
  SolverObserver observer;    // may be empty
  bool local_errors = false;  // fills coarser_pressure: 8 bytes a cell

  void check() const;  // throws std::invalid_argument
  int threads_on(const Grid& grid) const;
};

struct ContactZone {
  Estimate force;          // [N]
  Estimate area;           // [m^2]
  Estimate peak_pressure;  // [Pa]
  double counted_area;     // of the cells with p > 0 [m^2]
  bool edge_resolved;      // area is good to a fraction of a cell; else it is the counted area
  double x, y;             // centre of pressure [m]
  double centre_error;     // estimated [m]
};

struct PressedHalfSpace {
  Grid grid;
  Surface surface;
  double contact_modulus;        // [Pa]
  std::vector<double> pressure;  // [Pa], row by row
  // What half as many cells a side say of each cell [Pa], for local_pressure.h; empty unless local_errors.
  std::vector<double> coarser_pressure;
  Estimate force, approach, peak_pressure, area;
  double counted_area;
  std::vector<ContactZone> zones;  // on a periodic surface a zone across its side has no meaningful centre
  double residual;                 // relative, <= tolerance
  int iterations;                  // on the grid given
  int all_iterations;              // and on the coarser ones
  double products;                 // with the half-space, in products of the grid given
};

// `start`: an earlier solution on the same grid, of a nearby load or gap.
PressedHalfSpace press_half_space(const Grid& grid, Surface surface, std::span<const double> gap,
                                  double contact_modulus, const Press& press, const PressSettings& settings = {},
                                  const PressedHalfSpace* start = nullptr);

}  // namespace patchgrip::contact
