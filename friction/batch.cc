#include <patchgrip/friction/batch.h>

#include <algorithm>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/moebius_batch.h>

namespace patchgrip::friction {
namespace {

template <class Coefficients, class Disc>
void run(const Disc& disc, double spin, const PoleBatch& batch) {
  static const kernels::MoebiusBatch kernel = kernels::moebius_batch<Coefficients>();
  batch.check(spin);
  constexpr std::size_t chunk = 1024;  // a pole that cannot be squared sends its own chunk to the scalar code
  const double a = disc.radius();
  const bool scalable = a * a > 0x1p-900 && a * a < 0x1p900;
  const std::size_t n = batch.pole_x.size();
  for (std::size_t i = 0; i < n; i += chunk) {
    const std::size_t count = std::min(chunk, n - i);
    const PoleBatch part{batch.pole_x.subspan(i, count), batch.pole_y.subspan(i, count),
                         batch.force_x.subspan(i, count), batch.force_y.subspan(i, count),
                         batch.moment.subspan(i, count)};
    const bool done = scalable && kernel(count, part.pole_x.data(), part.pole_y.data(), a, std::copysign(1.0, spin),
                                         part.force_x.data(), part.force_y.data(), part.moment.data());
    if (!done) gradient<Disc>(disc, spin, part);
  }
}

}  // namespace

void PoleBatch::check(double spin) const {
  if (!(std::fabs(spin) > 0)) contact::refuse("spin", spin, "must not be zero: a translation has no pole in the plane");
  const auto n = static_cast<double>(pole_x.size());
  for (const std::size_t size : {pole_y.size(), force_x.size(), force_y.size(), moment.size()}) {
    if (size != pole_x.size()) contact::refuse("length of pole_x", n, "must be that of the other spans");
  }
}

void gradient(const HertzDisc& patch, double spin, const PoleBatch& batch) {
  run<kernels::HertzCoefficients>(patch, spin, batch);
}

void gradient(const FlatPunchDisc& patch, double spin, const PoleBatch& batch) {
  run<kernels::FlatPunchCoefficients>(patch, spin, batch);
}

}  // namespace patchgrip::friction
