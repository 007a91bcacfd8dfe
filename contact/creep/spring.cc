#include <patchgrip/contact/creep/spring.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <patchgrip/contact/creep/load_integral.h>
#include <patchgrip/contact/falling_root.h>

namespace patchgrip::contact {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// f(h) = start + slope h + sum weight_k (exp(-rate_k h) - 1), start >= 0: the first h <= end from which it is negative.
struct Course {
  double start;
  double slope;
  std::span<const double> weights;
  std::span<const double> rates;

  double operator()(double h) const {
    double sum = start + slope * h;
    for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * std::expm1(-rates[k] * h);
    return sum;
  }

  double fall(double h) const {  // -f'
    double sum = -slope;
    for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * rates[k] * std::exp(-rates[k] * h);
    return sum;
  }

  // By more than the rounding of the sum: a spring that has just changed starts at 0.
  bool is_below_zero(double h) const {
    double size = start + std::fabs(slope * h);
    for (std::size_t k = 0; k < weights.size(); ++k) size -= std::fabs(weights[k]) * std::expm1(-rates[k] * h);
    return (*this)(h) < -8 * 0x1p-53 * size;
  }

  double falls_below_zero(double end) const {
    bool rises = slope >= 0, falls = slope <= 0;
    double least = start + std::fmin(0, slope * end);
    for (std::size_t k = 0; k < weights.size(); ++k) {
      rises = rises && weights[k] <= 0;
      falls = falls && weights[k] >= 0;
      if (weights[k] > 0) least += weights[k] * std::expm1(-rates[k] * end);
    }
    if (rises || least > 0) return never;
    if (falls) return (*this)(end) < 0 ? falling_root(*this, 0., end) : never;
    double before = 0;
    for (int k = 0; k < 28; ++k) {
      // 2^-23 .. 1/16, then eighths.
      const double h = end * (k < 20 ? std::scalbn(1., k - 23) : (k - 19) * 0.125);
      if (is_below_zero(h)) return falling_root(*this, before, h);
      if (fall(before) > 0 && fall(h) < 0) {
        const double least_at = falling_root([&](double at) { return fall(at); }, before, h);
        if (is_below_zero(least_at)) return falling_root(*this, before, least_at);
      }
      before = h;
    }
    return never;
  }
};

}  // namespace

SpringLaw::SpringLaw(ContactCreep creep) : creep_(std::move(creep)), instantaneous_(creep_.modulus.instantaneous()) {
  require_in("dashpot", creep_.modulus.dashpot(), 0, 0);
  for (const auto& mode : creep_.modulus.modes()) relaxation_rates_.push_back(1 / mode.time);
  for (const auto& mode : creep_.compliance.modes()) creep_rates_.push_back(1 / mode.time);
}

double SpringLaw::stress(const Spring& spring, std::span<const double> relaxing) const {
  if (!spring.is_touching) return 0;
  double sum = creep_.modulus.equilibrium() * spring.depth;
  for (const double q : relaxing) sum += q;
  return sum;
}

double SpringLaw::creeping(std::span<const double> relaxing, std::size_t j) const {
  double sum = 0;
  for (std::size_t i = 0; i < relaxing.size(); ++i) sum += relaxing[i] * creep_.coupling[i][j];
  const auto& mode = creep_.compliance.modes()[j];
  return -mode.time * mode.strength * sum;
}

void SpringLaw::press(Spring& spring, std::span<double> relaxing, double rate, double duration) const {
  for (std::size_t i = 0; i < relaxing.size(); ++i) {
    const auto& mode = creep_.modulus.modes()[i];
    const double lost = -std::expm1(-duration / mode.time);
    relaxing[i] += (mode.strength * rate * mode.time - relaxing[i]) * lost;
  }
  spring.depth += rate * duration;
}

void SpringLaw::recover(Spring& spring, std::span<double> relaxing, double duration) const {
  const auto& modes = creep_.compliance.modes();
  thread_local std::vector<double> faded;
  faded.resize(modes.size());
  for (std::size_t j = 0; j < modes.size(); ++j) {
    const double U = creeping(relaxing, j);
    spring.depth += U * std::expm1(-duration / modes[j].time);
    faded[j] = U * std::exp(-duration / modes[j].time);
  }
  for (std::size_t i = 0; i < relaxing.size(); ++i) {
    const auto& mode = creep_.modulus.modes()[i];
    double sum = 0;
    for (std::size_t j = 0; j < modes.size(); ++j) sum += faded[j] * creep_.coupling[i][j];
    relaxing[i] = -mode.strength * mode.time * sum;
  }
}

double SpringLaw::lets_go(const Spring& spring, std::span<const double> relaxing, double rate, double duration,
                          bool starts_free) const {
  thread_local std::vector<double> weights;
  weights.resize(relaxing.size());
  for (std::size_t i = 0; i < relaxing.size(); ++i) {
    const auto& mode = creep_.modulus.modes()[i];
    weights[i] = relaxing[i] - mode.strength * rate * mode.time;
  }
  const double start = starts_free ? 0 : std::fmax(0, stress(spring, relaxing));
  return Course{start, creep_.modulus.equilibrium() * rate, weights, relaxation_rates_}.falls_below_zero(duration);
}

double SpringLaw::is_met(const Spring& spring, std::span<const double> relaxing, double d, double rate,
                         double duration) const {
  thread_local std::vector<double> weights;
  weights.resize(creep_rates_.size());
  for (std::size_t j = 0; j < weights.size(); ++j) weights[j] = creeping(relaxing, j);
  return Course{std::fmax(0, spring.depth - d), -rate, weights, creep_rates_}.falls_below_zero(duration);
}

void SpringLaw::advance(Spring& spring, std::span<double> relaxing, double d, double rate, double duration) const {
  const double end = d + rate * duration;
  double left = duration;
  bool just_changed = false;
  for (int change = 0; change < 64; ++change) {
    // Where the stamp leaves along with the surface, rounding alone would change the spring to and fro.
    const double stay = just_changed ? std::scalbn(left, change - 60) : 0;
    if (spring.is_touching) {
      const double h = std::fmax(stay, lets_go(spring, relaxing, rate, left, just_changed));
      press(spring, relaxing, rate, std::fmin(h, left));
      if (!(h < left)) {
        spring.depth = end;
        return;
      }
      d += rate * h;
      left -= h;
      spring.is_touching = false;
    } else {
      if (!spring.was_touched && end <= 0 && d <= 0) return;
      const double h = std::fmax(stay, is_met(spring, relaxing, d, rate, left));
      recover(spring, relaxing, std::fmin(h, left));
      if (!(h < left)) return;
      d += rate * h;
      left -= h;
      spring.depth = d;
      spring.is_touching = spring.was_touched = true;
    }
    just_changed = true;
    ++spring.changes;
  }
  throw std::runtime_error("a spring changed 64 times in one step: residual " + std::to_string(left));
}

void SpringLaw::jump(Spring& spring, std::span<double> relaxing, double d) const {
  double rise = d - spring.depth;
  if (!spring.is_touching) {
    if (!(rise > 0)) return;
    spring.is_touching = spring.was_touched = true;
    ++spring.changes;
  } else if (const double carried = stress(spring, relaxing); carried + instantaneous_ * rise < 0) {
    rise = -carried / instantaneous_;  // as far as the surface follows
    spring.is_touching = false;
    ++spring.changes;
  }
  spring.depth += rise;
  for (std::size_t i = 0; i < relaxing.size(); ++i) relaxing[i] += creep_.modulus.modes()[i].strength * rise;
}

}  // namespace patchgrip::contact
