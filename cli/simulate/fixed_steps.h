// Steps of one length between the times that are told and the corners of what acts.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace patchgrip::cli {

// `row(t)` at each of `times`, `step(t, h, end, last)` from t to end = t + h between them, no longer than `longest`
// [s]; `last` is the last time of the smooth piece that the step lies in, just before a corner.
template <class Row, class Step>
void take_fixed_steps(const std::vector<double>& times, const std::vector<double>& corners, double longest,
                      const Row& row, const Step& step) {
  double t = 0;
  for (std::size_t next = 0; next < times.size();) {
    if (times[next] <= t) {
      row(t);
      ++next;
      continue;
    }
    const auto corner = std::ranges::upper_bound(corners, t);
    const double to = corner == corners.end() ? times[next] : std::min(times[next], *corner);
    const double from = t, last = std::nextafter(to, t);
    const auto steps = static_cast<long>(std::ceil((to - t) / longest * (1 - 1e-9)));
    const double h = (to - t) / static_cast<double>(steps);
    for (long i = 0; i < steps; ++i) {
      const double end = i + 1 == steps ? to : from + static_cast<double>(i + 1) * h;
      step(t, h, end, last);
      t = end;
    }
  }
}

}  // namespace patchgrip::cli
