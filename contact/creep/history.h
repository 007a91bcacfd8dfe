// A force or an approach over time: pieces h(s) = h_k + rate (s - s_k) + A (sin(w (s - s_k) + phi) - sin phi), with
// jumps.
//
//     faded(t, T)    = int exp(-(t - s) / T) dh(s)           Stieltjes: a jump counts with its height
//     lagged(t, T)   = int (1 - exp(-(t - s) / T)) dh(s)  =  (1/T) int exp(-(t - s) / T) h(s) ds
//     integral(t)    = int h ds
//
// each over everything up to and including t, and each in closed form. Before the first piece h = 0; h(t) and the rate
// are those just after t, so that h(0) of a step at 0 is its height.
//
// Units    h [N] or [m], t [s], w [rad/s].
// Error    of linear pieces whose steps all have one sign: <= 8 units of rounding (2^-53), relative, in every one;
//          else and with sines <= 16 units of the sum of the moduli of the steps; tests/contact/creep_history_test.cc.
// Fails    times far from zero lose digits in t - s: start histories near zero.
// Throws   std::invalid_argument unless times ascend (two equal ones are a jump), their distances are no smaller than
//          the smallest normal number, and all numbers, rates too, are finite.
#pragma once

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include <patchgrip/contact/numbered.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

template <class Real>
struct HistoryPoint {
  Real time;
  Real value;
};

template <class Real>
struct HistoryPiece {
  Real start;
  Real value;  // just after the start
  Real rate = 0;
  Real amplitude = 0;
  Real frequency = 0;
  Real phase = 0;

  Real at(const Real& s) const {
    const Real linear = value + rate * (s - start);
    return amplitude == 0 ? linear : linear + rise(start, s);
  }

  Real rate_at(const Real& s) const {
    using std::cos;
    return amplitude == 0 ? rate : rate + amplitude * frequency * cos(frequency * (s - start) + phase);
  }

  // Of the sine between two times: 2 A cos(mean) sin(half the difference) does not cancel.
  Real rise(const Real& from, const Real& to) const {
    using std::cos;
    using std::sin;
    return 2 * amplitude * cos(frequency * ((to - start) + (from - start)) / 2 + phase) *
           sin(frequency * (to - from) / 2);
  }
};

namespace history {

// (1 - exp(-z)) / z, z >= 0: what is left at the end of z of a rise over all of it, of 1.
template <class Real>
Real mean_faded(const Real& z) {
  using std::expm1;
  return z > 0 ? Real(-expm1(-z) / z) : Real(1);
}

// 1 - mean_faded(z): z / 2 for small z, where the difference would lose it.
template <class Real>
Real mean_lagged(const Real& z) {
  if (z > 1) return 1 - mean_faded(z);
  Real term = z / 2;
  Real sum = term;
  for (int k = 3; term > sum * std::numeric_limits<Real>::epsilon() / 4; ++k) {
    term *= z / k;
    sum += k % 2 == 0 ? term : -term;
  }
  return sum;
}

// int_a^b exp(-(t - s) / T) d(sine) for a piece, b <= t.
template <class Real>
Real faded_sine(const HistoryPiece<Real>& piece, const Real& a, const Real& b, const Real& t, const Real& T) {
  using std::cos;
  using std::exp;
  using std::expm1;
  using std::sin;
  const Real w = piece.frequency;
  const Real h = b - a;
  if (h < T && w * h < 1) {
    // The closed form is a difference of numbers T / h times larger than it.
    return boost::math::quadrature::gauss<Real, 20>::integrate(
        [&](const Real& s) {
          return piece.amplitude * w * cos(w * (s - piece.start) + piece.phase) * exp(-(t - s) / T);
        },
        a, b);
  }
  const Real end = w * (b - piece.start) + piece.phase;
  const Real begin = w * (a - piece.start) + piece.phase;
  const Real fade = exp(-h / T);
  const Real whole = (cos(end) - fade * cos(begin)) + w * T * (sin(end) - fade * sin(begin));
  return piece.amplitude * whole / (1 / (w * T) + w * T) * exp(-(t - b) / T);
}

// int_a^b (1 - exp(-(t - s) / T)) d(sine).
template <class Real>
Real lagged_sine(const HistoryPiece<Real>& piece, const Real& a, const Real& b, const Real& t, const Real& T) {
  using std::cos;
  using std::expm1;
  const Real w = piece.frequency;
  if (t - a < T && w * (b - a) < 1) {
    return boost::math::quadrature::gauss<Real, 20>::integrate(
        [&](const Real& s) {
          return -piece.amplitude * w * cos(w * (s - piece.start) + piece.phase) * expm1(-(t - s) / T);
        },
        a, b);
  }
  return piece.rise(a, b) - faded_sine(piece, a, b, t, T);
}

}  // namespace history

template <class Real>
class BasicHistory {
 public:
  // Linear between the points, from a jump at the first; the last value stays.
  static BasicHistory points(const std::vector<HistoryPoint<Real>>& points) {
    if (points.empty()) refuse("points", 0, "must be at least one");
    std::vector<HistoryPiece<Real>> pieces;
    for (std::size_t i = 0; i < points.size(); ++i) {
      require_finite(numbered("t", i), static_cast<double>(points[i].time));
      require_finite(numbered("value", i), static_cast<double>(points[i].value));
      const bool is_last = i + 1 == points.size();
      if (!is_last && !(points[i + 1].time >= points[i].time)) {
        refuse(numbered("t", i + 1), static_cast<double>(points[i + 1].time),
               "must not be less than the time before it");
      }
      if (!is_last && points[i + 1].time == points[i].time) continue;
      pieces.push_back({points[i].time, points[i].value, is_last ? Real(0) : rate_between(points, i)});
    }
    return BasicHistory(std::move(pieces));
  }

  static BasicHistory step(Real height) { return points({{Real(0), height}}); }

  static BasicHistory ramp(Real rate) {
    require_finite("rate", static_cast<double>(rate));
    return BasicHistory({{Real(0), Real(0), rate}});
  }

  // rate t up to the peak, back to zero at twice that time.
  static BasicHistory triangle(Real rate, Real peak_time) {
    require_positive("peak_time", static_cast<double>(peak_time));
    return points({{Real(0), Real(0)}, {peak_time, rate * peak_time}, {2 * peak_time, Real(0)}});
  }

  // height sin(w t) for half a period, then zero.
  static BasicHistory half_sine(Real height, Real frequency) {
    require_finite("height", static_cast<double>(height));
    require_positive("frequency", static_cast<double>(frequency));
    require_finite("height * frequency", static_cast<double>(height * frequency));
    require_finite("pi / frequency", static_cast<double>(boost::math::constants::pi<Real>() / frequency));
    return BasicHistory({{Real(0), Real(0), Real(0), height, frequency, Real(0)},
                         {boost::math::constants::pi<Real>() / frequency, Real(0)}});
  }

  // mean (1 + swing sin(w t)), from a jump at t = 0.
  static BasicHistory sine(Real mean, Real swing, Real frequency) {
    require_finite("mean", static_cast<double>(mean));
    require_finite("swing", static_cast<double>(swing));
    require_positive("frequency", static_cast<double>(frequency));
    require_finite("mean * swing * frequency", static_cast<double>(mean * swing * frequency));
    return BasicHistory({{Real(0), mean, Real(0), mean * swing, frequency, Real(0)}});
  }

  Real operator()(const Real& t) const { return t >= start() ? pieces_[piece_at(t)].at(t) : Real(0); }
  Real rate(const Real& t) const { return t >= start() ? pieces_[piece_at(t)].rate_at(t) : Real(0); }
  Real start() const { return pieces_.front().start; }
  const std::vector<HistoryPiece<Real>>& pieces() const noexcept { return pieces_; }

  Real jump(std::size_t piece) const {
    if (piece == 0) return pieces_.front().value;
    const auto& before = pieces_[piece - 1];
    // Points that meet leave the rounding of rate * duration: not a jump.
    const Real end = before.at(pieces_[piece].start);
    const Real gap = pieces_[piece].value - end;
    using std::abs;
    const Real size = abs(before.value) + abs(end) + abs(before.amplitude) + abs(pieces_[piece].value);
    return abs(gap) <= 4 * std::numeric_limits<Real>::epsilon() * size ? Real(0) : gap;
  }

  Real faded(const Real& t, const Real& T) const { return faded_since(start(), t, T) + start_jump(t, T); }

  // The same of what happens after `from` alone: a jump at `from` itself is left out.
  Real faded_since(const Real& from, const Real& t, const Real& T) const {
    using std::exp;
    return sum_of_pieces(
        from, t, [&](const Real& u) { return exp(-u / T); },
        [&](const HistoryPiece<Real>& piece, const Real& a, const Real& b) {
          const Real linear = piece.rate * (b - a) * history::mean_faded<Real>((b - a) / T) * exp(-(t - b) / T);
          return piece.amplitude == 0 ? linear : linear + history::faded_sine(piece, a, b, t, T);
        });
  }

  Real lagged(const Real& t, const Real& T) const {
    using std::exp;
    using std::expm1;
    const Real steps = t >= start() ? -pieces_.front().value * expm1(-(t - start()) / T) : Real(0);
    return steps + sum_of_pieces(
                       start(), t, [&](const Real& u) { return -expm1(-u / T); },
                       [&](const HistoryPiece<Real>& piece, const Real& a, const Real& b) {
                         const Real fade = exp(-(t - b) / T);
                         const Real linear = piece.rate * (b - a) *
                                             (-expm1(-(t - b) / T) + fade * history::mean_lagged<Real>((b - a) / T));
                         return piece.amplitude == 0 ? linear : linear + history::lagged_sine(piece, a, b, t, T);
                       });
  }

  Real integral(const Real& t) const {
    using std::cos;
    using std::sin;
    Real sum = 0;
    for (std::size_t k = 0; k < pieces_.size() && t > pieces_[k].start; ++k) {
      const auto& piece = pieces_[k];
      const Real h = end_of(k, t) - piece.start;
      sum += h * (piece.value + piece.rate * h / 2);
      if (piece.amplitude != 0) {
        const Real turn = piece.frequency * h;
        // int (sin(w s + phi) - sin phi) ds
        sum += piece.amplitude / piece.frequency *
               (2 * sin(turn / 2 + piece.phase) * sin(turn / 2) - turn * sin(piece.phase));
      }
    }
    return sum;
  }

 private:
  explicit BasicHistory(std::vector<HistoryPiece<Real>> pieces) : pieces_(std::move(pieces)) {}

  static Real rate_between(const std::vector<HistoryPoint<Real>>& points, std::size_t i) {
    const Real duration = points[i + 1].time - points[i].time;
    require_representable(numbered("t", i + 1) + " - " + numbered("t", i), static_cast<double>(duration));
    const Real rate = (points[i + 1].value - points[i].value) / duration;
    require_finite(numbered("rate", i), static_cast<double>(rate));
    return rate;
  }

  std::size_t piece_at(const Real& t) const {
    const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), t,
                                        [](const Real& time, const auto& piece) { return time < piece.start; });
    return static_cast<std::size_t>(after - pieces_.begin()) - 1;
  }

  Real end_of(std::size_t piece, const Real& t) const {
    return piece + 1 < pieces_.size() ? std::min<Real>(t, pieces_[piece + 1].start) : t;
  }

  Real start_jump(const Real& t, const Real& T) const {
    using std::exp;
    return t >= start() ? pieces_.front().value * exp(-(t - start()) / T) : Real(0);
  }

  // Jumps in (from, t], weighted by their age, and the pieces' own share over their part of it.
  template <class Weight, class Share>
  Real sum_of_pieces(const Real& from, const Real& t, const Weight& weight, const Share& share) const {
    Real sum = 0;
    for (std::size_t k = 0; k < pieces_.size() && t >= pieces_[k].start; ++k) {
      const Real a = std::max<Real>(from, pieces_[k].start);
      if (k > 0 && pieces_[k].start > from) sum += jump(k) * weight(t - pieces_[k].start);
      const Real b = end_of(k, t);
      if (b > a) sum += share(pieces_[k], a, b);
    }
    return sum;
  }

  std::vector<HistoryPiece<Real>> pieces_;
};

using History = BasicHistory<double>;

}  // namespace patchgrip::contact
