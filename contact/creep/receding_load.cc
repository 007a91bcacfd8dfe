#include <patchgrip/contact/creep/receding_load.h>
#include <patchgrip/contact/falling_root.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::contact {
namespace {

constexpr double at_rest = 16 * 0x1p-53;  // of the stress of a past, relative (receding_load.h)

}  // namespace

RecedingLoad::RecedingLoad(ContactCreep creep, History force, double until)
    : creep_(std::move(creep)), force_(std::move(force)), grows_until_(until), valid_until_(until) {
  if (!(until > force_.start()) || !std::isfinite(until)) {
    refuse("until", until, "must be finite and after the start of the force");
  }
  const auto& pieces = force_.pieces();
  for (std::size_t k = 0; k < pieces.size() && pieces[k].start <= until; ++k) {
    require_non_negative("force", pieces[k].value);
    const double end = k + 1 < pieces.size() ? std::min(until, pieces[k + 1].start) : until;
    if (!(end > pieces[k].start)) continue;
    const double rounding = 16 * 0x1p-53 * (pieces[k].value + std::fabs(pieces[k].amplitude));
    for (const double t : look_times(pieces[k], std::nextafter(end, pieces[k].start))) {
      const double value = pieces[k].at(t);
      if (value < -rounding - 16 * 0x1p-53 * std::fabs(pieces[k].rate * (t - pieces[k].start))) {
        refuse("force", value, "must be non-negative");
      }
    }
  }
  grows_until_ = std::min(until, load_integral_falls_at(creep_.compliance, force_, until));
  if (grows_until_ < until) valid_until_ = first_end();
}

double RecedingLoad::stress(const Past& past, double t) const {
  const auto& modulus = creep_.modulus;
  const auto& modes = creep_.compliance.modes();
  const double age = t - past.time;
  const double X = grown(past.time);
  double sum = modulus.equilibrium() * past.measure;
  for (std::size_t i = 0; i < modulus.modes().size(); ++i) {
    const auto& relaxing = modulus.modes()[i];
    double faded = creep_.compliance.fluidity() * force_(past.time);
    for (std::size_t j = 0; j < modes.size(); ++j) {
      faded += modes[j].strength * force_.faded(past.time, modes[j].time) * creep_.coupling[i][j];
    }
    sum += relaxing.strength * std::exp(-age / relaxing.time) * (relaxing.time * faded - (X - past.measure));
  }
  return sum;
}

double RecedingLoad::stress_rate(const Past& past, double t) const {
  const auto& modulus = creep_.modulus;
  const auto& modes = creep_.compliance.modes();
  const double X = grown(past.time);
  double sum = 0;
  for (std::size_t i = 0; i < modulus.modes().size(); ++i) {
    const auto& relaxing = modulus.modes()[i];
    double faded = creep_.compliance.fluidity() * force_(past.time);
    for (std::size_t j = 0; j < modes.size(); ++j) {
      faded += modes[j].strength * force_.faded(past.time, modes[j].time) * creep_.coupling[i][j];
    }
    sum -= relaxing.strength / relaxing.time * std::exp(-(t - past.time) / relaxing.time) *
           (relaxing.time * faded - (X - past.measure));
  }
  return sum;
}

Past RecedingLoad::past(double t) const {
  if (t <= grows_until_) return {t, grown(t)};
  const double force = force_(t);
  const auto lacking = [&](double t1) { return force - stress({t1, grown(t1)}, t); };
  const auto& pieces = force_.pieces();
  double hi = grows_until_;
  for (std::size_t k = pieces.size(); k-- > 0;) {
    const double start = pieces[k].start;
    if (start > hi) continue;
    const double lack = lacking(start);
    if (lack >= 0) {
      const double t1 = falling_root(lacking, start, hi);
      return {t1, grown(t1)};
    }
    const double modulus = creep_.modulus(t - start);
    const double jump = creep_.compliance.instantaneous() * force_.jump(k);
    if (k == 0 || lack + modulus * jump > 0) return {start, std::max(0., grown(start) + lack / modulus)};
    hi = start;
  }
  return {force_.start(), 0};
}

std::vector<double> RecedingLoad::passes(double t) const {
  std::vector<double> times;
  const auto& pieces = force_.pieces();
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].start > grows_until_) times.push_back(pieces[k].start);
    if (!(pieces[k].start <= grows_until_)) continue;
    const double X = grown(pieces[k].start);
    const double jump = creep_.compliance.instantaneous() * force_.jump(k);
    for (const double measure : {X, X - jump}) {
      const auto above = [&](double at) { return force_(at) - stress({pieces[k].start, measure}, at); };
      if (above(grows_until_) > 0 && above(t) < 0) times.push_back(falling_root(above, grows_until_, t));
    }
  }
  return times;
}

double RecedingLoad::first_end() const {
  const auto& pieces = force_.pieces();
  // Lost, or growing again: by more than what rounds the stress, over the time that is left or since the last look.
  const double until = valid_until_;
  const auto ends = [&](double t, double since) {
    const double force = force_(t);
    if (!(force > 0)) return true;
    const double growth = force_.rate(t) - stress_rate(past(t), t);
    return growth * std::max(until - t, t - since) > at_rest * force;
  };
  for (std::size_t k = 0; k < pieces.size() && pieces[k].start < valid_until_; ++k) {
    const double end = k + 1 < pieces.size() ? std::min(valid_until_, pieces[k + 1].start) : valid_until_;
    if (end <= grows_until_) continue;
    double before = std::max(pieces[k].start, grows_until_);
    if (before > grows_until_ && force_.jump(k) > 0) return std::nextafter(before, force_.start());
    if (before > grows_until_ && ends(before, before)) return before;
    for (const double t : look_times(pieces[k], std::nextafter(end, pieces[k].start))) {
      if (t <= before) continue;
      if (ends(t, before)) {
        // The first of the two ways to end: the sign alone says which side of it a time is on.
        double lo = before, hi = t;
        while (true) {
          const double middle = lo + (hi - lo) / 2;
          if (!(middle > lo && middle < hi)) return hi;
          (ends(middle, before) ? hi : lo) = middle;
        }
      }
      before = t;
    }
  }
  return valid_until_;
}

}  // namespace patchgrip::contact
