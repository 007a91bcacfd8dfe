// A gauge that stands for that of a limit surface, with the proven error of it on either side.
//
//     (1 - largest_deficit) g(t) <= value(t) <= (1 + largest_excess) g(t)      for every load t of the domain
//
// The excess asks for too much grip, which is safe; the deficit for too little, which is not. gauge() turns the value
// into a bracket of g(t); its twist is the slip that the model starts: t . twist = value, up to the excess. Gauges to
// rounding are models too, of an excess and a deficit of some units.
//
// Units    load [N], [N], [N m] in the frame of the patch; value [N]; excess and deficit [1], the latter below 1.
// Error    the bracket holds, rounding included.
// Throws   nothing: models are validated where they are made.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <patchgrip/friction/limit_surface/gauge.h>

namespace patchgrip::friction {

template <class M>
concept GaugeModel = std::copyable<M> && requires(const M& model, const Wrench& load) {
  { model.value(load) }
  noexcept->std::same_as<double>;
  { model.gauge(load) }
  noexcept->std::same_as<Gauge>;
  { model.largest_excess() }
  noexcept->std::same_as<double>;
  { model.largest_deficit() }
  noexcept->std::same_as<double>;
};

// What `value` of a model says of the true gauge; `error` [N] is that of the value by rounding, as far as excess and
// deficit do not hold it already.
inline Gauge bracketed(double value, const Twist& twist, double largest_excess, double largest_deficit,
                       double error = 0) noexcept {
  constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();  // of the quotients here
  Gauge g;
  g.value = value;
  g.lower = std::fmax(0, (value - error) / (1 + largest_excess) * (1 - rounding));
  g.upper = (value + error) / (1 - largest_deficit) * (1 + rounding);
  g.twist = twist;
  return g;
}

}  // namespace patchgrip::friction
