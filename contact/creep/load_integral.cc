#include <patchgrip/contact/creep/load_integral.h>
#include <patchgrip/contact/falling_root.h>

#include <algorithm>
#include <numbers>

namespace patchgrip::contact {

std::vector<double> look_times(const HistoryPiece<double>& piece, double end) {
  const double span = end - piece.start;
  std::vector<double> times;
  const double turns = piece.amplitude == 0 ? 0 : piece.frequency * span / (2 * std::numbers::pi);
  require_in("turns of a sine", turns, 0, most_turns);
  const int uniform = 16 + static_cast<int>(std::ceil(32 * turns));
  for (int k = 1; k <= uniform; ++k) times.push_back(piece.start + span * k / uniform);
  for (double part = 1e-9; part < 1. / uniform; part *= 2) times.push_back(piece.start + span * part);
  std::sort(times.begin(), times.end());
  times.back() = end;
  return times;
}

double load_integral_falls_at(const CreepCompliance& compliance, const History& force, double until) {
  const auto& pieces = force.pieces();
  const auto rate = [&](double t) { return load_integral_rate(compliance, force, t); };
  for (std::size_t k = 0; k < pieces.size() && pieces[k].start <= until; ++k) {
    const double start = pieces[k].start;
    const double end = k + 1 < pieces.size() ? std::min(until, pieces[k + 1].start) : until;
    // At a jump down the force is already the smaller one: the contact grew until just before.
    if (compliance.instantaneous() > 0 && force.jump(k) < 0) return std::nextafter(start, force.start());
    if (start == until) break;
    if (rate(start) < 0) return start;
    // The rate of this piece alone, up to and including its end.
    const double inside = std::nextafter(end, start);
    double before = start;
    for (const double t : look_times(pieces[k], inside)) {
      if (rate(t) < 0) return falling_root(rate, before, t);
      before = t;
    }
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace patchgrip::contact
