// A case solved on finer and finer meshes, and what that says about the error of the finest.
//
//     q_h - q ~ h^p:      error <= |q_fine - q_coarse| / (r^p - 1),   r = ratio of the mesh sizes   (Richardson)
//
// p is observed from the last three meshes,
//
//     |q_1 - q_0| / |q_2 - q_1| = (h_0^p - h_1^p) / (h_1^p - h_2^p)
//
// and taken as no less than 1/2 and no more than 2; from two meshes it is taken as 1. A difference that happens to be
// small is not trusted: the one before, shrunk as at p = 2, bounds it from below. To this comes what the last mesh but
// one changes when the body is made twice as large, times 4/3: the far field leaves an error that falls at least
// quadratically with the size.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <patchgrip/verification/claims/comparison.h>
#include <patchgrip/verification/fe/model.h>

namespace patchgrip::verification {

struct Setting {
  double elements;  // edges of elements per contact radius, or what the case names instead
  double extent;    // size of the body over the contact radius; 0 where the body is what it is
};

struct Line {
  std::string name;
  std::vector<double> x, y;
  bool is_library = false;
};

struct Curve {
  std::string name;  // of the file
  std::string x_label, y_label;
  std::vector<Line> lines;
};

struct Solved {
  std::vector<std::vector<double>> values;  // of the quantities of the case
  std::size_t unknowns = 0;
  int iterations = 0;
  std::vector<Curve> curves;
  std::optional<PlaneField> stress;               // von Mises [Pa]
  std::function<void(const std::string&)> vtk{};  // writes a file
};

struct Run {
  Setting setting;
  std::size_t unknowns;
  int iterations;
  double seconds;  // mesh and solution, wall
  std::vector<std::vector<double>> values;
};

struct Study {
  std::vector<Run> runs;  // from coarse to fine
  std::optional<Run> larger_body;
  std::vector<Comparison> comparisons;
  Solved finest;
  std::optional<PlaneField> stress;  // of the finest mesh that a picture can show
};

using Solver = std::function<Solved(const Setting&)>;

// The p of the equation above for n_0 < n_1 < n_2 elements; NaN where none from -6 to 20 solves it.
double observed_order(double n_0, double n_1, double n_2, double ratio_of_steps);

// At least two settings, from coarse to fine; without an extent there is no larger body. Throws std::runtime_error
// where a solution has other values than what is claimed, or values that are not finite.
Study study(const std::vector<Quantity>& quantities, const std::vector<Setting>& settings, const Solver& solve,
            const std::function<void(const Run&)>& progress);

}  // namespace patchgrip::verification
