// CPU time of whole runs.
#pragma once

#include <algorithm>
#include <ctime>
#include <limits>

namespace patchgrip::bench {

// The least of a run [us], repeated for `seconds`. Runs are timed a millisecond at a time: the clock ticks in
// microseconds.
template <class Run>
double least_cpu_time(const Run& run, double seconds) {
  double least = std::numeric_limits<double>::infinity(), spent = 0;
  do {
    const std::clock_t begin = std::clock();
    int runs = 0;
    while (std::clock() - begin < CLOCKS_PER_SEC / 1000) run(), ++runs;
    const double s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    least = std::min(least, s / runs);
    spent += s;
  } while (spent < seconds);
  return 1e6 * least;
}

}  // namespace patchgrip::bench
