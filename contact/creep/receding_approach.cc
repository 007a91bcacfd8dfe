#include <patchgrip/contact/creep/receding_approach.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <patchgrip/contact/creep/load_integral.h>
#include <patchgrip/contact/falling_root.h>

namespace patchgrip::contact {
namespace {

// The first time from which the approach falls.
double falls_at(const History& approach, double until) {
  const auto& pieces = approach.pieces();
  for (std::size_t k = 0; k < pieces.size() && pieces[k].start <= until; ++k) {
    // At a jump down the approach is already the smaller one: the contact grew until just before.
    if (approach.jump(k) < 0) return std::nextafter(pieces[k].start, approach.start());
    if (pieces[k].start == until) break;
    if (pieces[k].rate_at(pieces[k].start) < 0) return pieces[k].start;
    const double end = k + 1 < pieces.size() ? std::min(until, pieces[k + 1].start) : until;
    double before = pieces[k].start;
    for (const double t : look_times(pieces[k], std::nextafter(end, before))) {
      if (approach.rate(t) < 0) return falling_root([&](double s) { return approach.rate(s); }, before, t);
      before = t;
    }
  }
  return until;
}

// Where a property that holds at lo and not at hi ends.
template <class Property>
double last_of(const Property& holds, double lo, double hi) {
  while (true) {
    const double middle = lo + (hi - lo) / 2;
    if (!(middle > lo && middle < hi)) return hi;
    (holds(middle) ? lo : hi) = middle;
  }
}

}  // namespace

RecedingApproach::RecedingApproach(RelaxationModulus modulus, History approach, double until)
    : modulus_(std::move(modulus)),
      approach_(std::move(approach)),
      grows_until_(until),
      contact_lost_(std::numeric_limits<double>::infinity()),
      valid_until_(until) {
  if (!(until > approach_.start()) || !std::isfinite(until)) {
    refuse("until", until, "must be finite and after the start of the approach");
  }
  require_non_negative("approach", approach_(approach_.start()));
  require_in("dashpot", modulus_.dashpot(), 0, 0);
  grows_until_ = falls_at(approach_, until);
  if (grows_until_ < until) find_end();
}

double RecedingApproach::edge_stress(double t1, double t) const {
  double sum = modulus_.equilibrium() * (approach_(t) - approach_(t1));
  for (const auto& mode : modulus_.modes()) sum += mode.strength * approach_.faded_since(t1, t, mode.time);
  return sum;
}

double RecedingApproach::edge_stress_rate(double t1, double t) const {
  double sum = modulus_.instantaneous() * approach_.rate(t);
  for (const auto& mode : modulus_.modes()) {
    sum -= mode.strength / mode.time * approach_.faded_since(t1, t, mode.time);
  }
  return sum;
}

Past RecedingApproach::past(double t) const {
  if (t <= grows_until_) return {t, approach_(t)};
  const auto& pieces = approach_.pieces();
  double hi = grows_until_;
  for (std::size_t k = pieces.size(); k-- > 0;) {
    const double start = pieces[k].start;
    if (start > hi) continue;
    const double stress = edge_stress(start, t);
    if (stress >= 0) {
      const double t1 = falling_root([&](double s) { return edge_stress(s, t); }, start, hi);
      return {t1, approach_(t1)};
    }
    const double back = -stress / modulus_(t - start);
    // A jump down ends the growth: it is no state that the contact grew through.
    const double jump = std::max(0., approach_.jump(k));
    if (start < grows_until_ || jump > 0) {
      if (jump >= back) return {start, approach_(start) - back};
    }
    hi = start;
  }
  return {approach_.start(), 0};
}

bool RecedingApproach::is_lost(double t) const {
  const Past now = past(t);
  return now.time <= approach_.start() && !(now.measure > 0);
}

void RecedingApproach::find_end() {
  const auto& pieces = approach_.pieces();
  const auto shrinks = [&](double t) { return is_lost(t) || edge_stress_rate(past(t).time, t) <= 0; };
  for (std::size_t k = 0; k < pieces.size() && pieces[k].start < valid_until_; ++k) {
    const double start = pieces[k].start;
    const double end = k + 1 < pieces.size() ? std::min(valid_until_, pieces[k + 1].start) : valid_until_;
    if (end <= grows_until_) continue;
    if (start > grows_until_ && approach_.jump(k) > 0) {
      valid_until_ = std::nextafter(start, approach_.start());
      return;
    }
    if (start > grows_until_ && !shrinks(start)) {
      valid_until_ = start;
      return;
    }
    double before = std::max(start, grows_until_);
    for (const double t : look_times(pieces[k], std::nextafter(end, start))) {
      if (t <= before) continue;
      if (is_lost(t)) {
        // What comes after the loss is another press.
        contact_lost_ = is_lost(before) ? before : last_of([&](double s) { return !is_lost(s); }, before, t);
        valid_until_ = contact_lost_;
        return;
      }
      if (!shrinks(t)) {
        valid_until_ = last_of(shrinks, before, t);
        return;
      }
      before = t;
    }
  }
}

}  // namespace patchgrip::contact
