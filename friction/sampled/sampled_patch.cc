#include <patchgrip/friction/sampled/sampled_patch.h>

#include <cmath>
#include <numbers>
#include <utility>

#include <patchgrip/friction/sampled/sampled_pressure.h>

namespace patchgrip::friction {

SampledPatch::SampledPatch(std::shared_ptr<const kernels::SampledPressure> pressure) noexcept
    : pressure_(std::move(pressure)) {}

double SampledPatch::dissipation(const Twist& v) const noexcept { return pressure_->dissipation(v); }
Wrench SampledPatch::gradient(const Twist& v) const noexcept { return pressure_->gradient(v); }
BoundedWrench SampledPatch::bounded_gradient(const Twist& v) const noexcept { return pressure_->bounded_gradient(v); }
Hessian SampledPatch::hessian(const Twist& v) const { return pressure_->hessian(v); }

BoundedWrench stribeck_excess(const SampledPatch& patch, const Twist& u) noexcept {
  return patch.pressure_->stribeck_excess(u);
}

PressureMoments SampledPatch::moments() const noexcept {
  const kernels::PressureFrame& frame = pressure_->frame();
  return {frame.x, frame.y, frame.polar};
}

double SampledPatch::area_radius() const noexcept { return std::sqrt(pressure_->frame().area / std::numbers::pi); }
double SampledPatch::tolerance() const noexcept { return pressure_->tolerance(); }

}  // namespace patchgrip::friction
