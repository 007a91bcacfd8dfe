// Times of cases by Google Benchmark: repeated, the repetitions of all cases in random order, so that a disturbance of
// the machine meets all alike; of each the fastest counts.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/bench/case.h>

namespace patchgrip::bench {

// CPU time of one evaluation [ns] per case; NaN where a --benchmark_filter leaves the case out.
std::vector<double> least_times(std::span<const Case> cases);

}  // namespace patchgrip::bench
