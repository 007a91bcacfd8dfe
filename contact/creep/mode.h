// One exponential of a hereditary law: strength * exp(-t / time), as both Prony series hold them, ascending in time.
//
// Units    strength [Pa] in a modulus, [1/Pa] in a compliance; time [s].
// Throws   std::invalid_argument unless every strength and time is positive and finite.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include <patchgrip/contact/numbered.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

template <class Real>
struct Mode {
  Real strength;
  Real time;
};

template <class Real>
using Modes = std::vector<Mode<Real>>;

// Ascending in time; modes of one time are one mode. The names are those that a refusal prints, with the mode's number.
template <class Real>
Modes<Real> checked_modes(Modes<Real> modes, std::string_view strength_name, std::string_view time_name) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    require_representable(numbered(strength_name, i + 1), static_cast<double>(modes[i].strength));
    require_representable(numbered(time_name, i + 1), static_cast<double>(modes[i].time));
  }
  std::sort(modes.begin(), modes.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  Modes<Real> merged;
  for (const auto& mode : modes) {
    if (!merged.empty() && merged.back().time == mode.time) {
      merged.back().strength += mode.strength;
    } else {
      merged.push_back(mode);
    }
  }
  return merged;
}

}  // namespace patchgrip::contact
