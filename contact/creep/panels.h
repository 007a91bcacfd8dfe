// Quadrature over panels with an estimate of its error: Gauss-Kronrod, 21 points, the worst panel halved until it is
// good.
//
// Error    Estimate::error: the difference of 21 and 10 points, 8 units of 2^-53 of the moduli, and the floor.
// Fails    what is narrower than the distance of the points is not seen; where 200 panels do not do, the error says so.
#pragma once

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <vector>

#include <patchgrip/contact/estimate.h>

namespace patchgrip::contact {

// A stretch lo..hi of a coordinate z; halves of it keep the tag.
struct Panel {
  double lo, hi;
  std::size_t tag;
};

// Sum of the integrals of f(tag, z), until the errors are 1e-13 of it or the rounding that f itself brings: `floor`.
template <class Function>
Estimate integral_over(const Function& f, std::vector<Panel> panels, double floor) {
  struct Share {
    double value = 0, error = 0, size = 0;
  };
  const auto measured = [&](const Panel& panel) {
    Share share;
    share.value = boost::math::quadrature::gauss_kronrod<double, 21>::integrate(
        [&](double z) { return f(panel.tag, z); }, panel.lo, panel.hi, 0, 0., &share.error, &share.size);
    return share;
  };
  std::vector<Share> shares;
  for (const Panel& panel : panels) shares.push_back(measured(panel));
  while (true) {
    Share sum;
    std::size_t worst = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      sum.value += shares[k].value;
      sum.error += shares[k].error;
      sum.size += shares[k].size;
      if (shares[k].error > shares[worst].error) worst = k;
    }
    const double rounding = 8 * 0x1p-53 * sum.size + floor;
    const bool is_good = sum.error <= 1e-13 * std::fabs(sum.value) + rounding;
    if (panels.empty() || is_good || panels.size() >= 200) return {sum.value, sum.error + rounding};
    const Panel whole = panels[worst];
    const double middle = whole.lo + (whole.hi - whole.lo) / 2;
    if (!(middle > whole.lo && middle < whole.hi)) return {sum.value, sum.error + rounding};
    panels[worst] = {whole.lo, middle, whole.tag};
    shares[worst] = measured(panels[worst]);
    panels.push_back({middle, whole.hi, whole.tag});
    shares.push_back(measured(panels.back()));
  }
}

}  // namespace patchgrip::contact
