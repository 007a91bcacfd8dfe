// The limit surface of a patch: which loads it holds, and which slip a load starts.
//
//     B = { t : t . v <= D(v) for all v },   sticks  <=>  t in mu F_N B  <=>  g(t) <= mu F_N     (seed 4.51 to 4.53)
//
// Any patch will do; what the gauge's certificate needs of it is computed once, here.
//
// Units    load [N], [N], [N m] about the origin of the contact frame; g [N].
// Error    carried (gauge.h); tests/friction/limit_surface/limit_surface_test.cc.
// Throws   std::invalid_argument on settings out of range and on a single point load; nothing afterwards.
#pragma once

#include <utility>

#include <patchgrip/friction/limit_surface/gauge_solver.h>

namespace patchgrip::friction {

template <Patch P>
class LimitSurface {
 public:
  explicit LimitSurface(P patch, const GaugeSettings& settings = {})
      : patch_(std::move(patch)), settings_(settings), frame_(view(patch_), patch_.moments(), point_shares(patch_)) {
    settings_.check();
  }

  const P& patch() const noexcept { return patch_; }
  const GaugeSettings& settings() const noexcept { return settings_; }
  const PressureFrame& frame() const noexcept { return frame_; }

  Gauge gauge(const Wrench& load) const noexcept { return maximise(view(patch_), frame_, load, settings_); }

 private:
  P patch_;
  GaugeSettings settings_;
  PressureFrame frame_;
};

}  // namespace patchgrip::friction
