// Integrals over the past, weighted by how much of it is forgotten: quadrature on panels (panels.h) that
// widen fourfold, from the shortest fading time on, away from the present.
//
//     hereditary = int_(from, to] M(t - s) dG(s)
//                = M(t - from) (G(to) - G(from-)) + sum M_i / tau_i int (G(to) - G(s)) exp(-(t - s) / tau_i) ds
//
// for a G that does not fall, e.g. what an elastic contact of the same radius would carry: every term is positive, no
// digits are lost, and no slope of G is asked for.
//
// Units    s, t [s]; the integral [M][G].
// Error    Estimate::error: that of the panels; tests/contact/creep_press_test.cc.
// Fails    a kink of G that is not among the breaks costs time, then accuracy; the error says so.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <patchgrip/contact/creep/panels.h>
#include <patchgrip/contact/creep/relaxation_modulus.h>

namespace patchgrip::contact {

namespace fading {

// lo, breaks between, hi, and hi - shortest 4^k.
inline std::vector<double> panel_ends(double lo, double hi, double shortest, const std::vector<double>& breaks) {
  std::vector<double> ends{lo, hi};
  for (const double at : breaks) {
    if (at > lo && at < hi) ends.push_back(at);
  }
  for (double age = shortest; age < hi - lo; age *= 4) ends.push_back(hi - age);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

// int_lo^hi f ds. On the oldest panel s = lo + width z^6: there f may start like a root of s - lo, square or cube.
template <class Function>
Estimate over_past(const Function& f, double lo, double hi, double shortest, const std::vector<double>& breaks,
                   double floor) {
  const auto ends = panel_ends(lo, hi, shortest, breaks);
  const double width = ends[1] - ends[0];
  std::vector<Panel> panels{{0, 1, 0}};
  for (std::size_t k = 1; k + 1 < ends.size(); ++k) panels.push_back({ends[k], ends[k + 1], k});
  return integral_over(
      [&](std::size_t tag, double z) {
        if (tag > 0) return f(z);
        const double z2 = z * z;
        return 6 * width * z2 * z2 * z * f(lo + width * (z2 * z2 * z2));
      },
      std::move(panels), floor);
}

}  // namespace fading

// G from `before` just before `from` (a jump there counts) to `last` at `to`. Breaks: times of other jumps and of
// kinks.
template <class Growth>
Estimate hereditary_integral(const RelaxationModulus& modulus, const Growth& growth, double before, double last,
                             double from, double to, double t, const std::vector<double>& breaks) {
  const double oldest = modulus(t - from) * (last - before);
  Estimate sum{oldest, 8 * 0x1p-53 * std::fabs(oldest)};
  if (modulus.modes().empty() || !(to > from)) return sum;
  const auto integrand = [&](double s) {
    double fade = 0;
    for (const auto& mode : modulus.modes()) fade += mode.strength / mode.time * std::exp(-(t - s) / mode.time);
    return fade > 0 ? (last - growth(s)) * fade : 0;
  };
  // last - growth(s) rounds to some units of `last`.
  const double floor = 8 * 0x1p-53 * std::fabs(last) * (modulus(t - to) - modulus(t - from));
  const Estimate faded = fading::over_past(integrand, from, to, modulus.modes().front().time, breaks, floor);
  return {sum.value + faded.value, sum.error + faded.error};
}

}  // namespace patchgrip::contact
