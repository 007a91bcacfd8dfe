// What the benchmark says: a table of times with errors, a table of ratios with their targets, and a CSV of the first.
#pragma once

#include <ostream>
#include <span>

#include <patchgrip/bench/case.h>

namespace patchgrip::bench {

struct Measurement {
  Label label;
  WorstError error;
  std::size_t judged;
  double ns;  // per evaluation
};

void print_measurements(std::ostream& out, std::span<const Measurement> measurements);
void print_ratios(std::ostream& out, std::span<const Measurement> measurements);
void write_csv(std::ostream& out, std::span<const Measurement> measurements);

}  // namespace patchgrip::bench
