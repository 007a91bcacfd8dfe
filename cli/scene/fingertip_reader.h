// The table [contact.fingertip] of a scene: a soft fingertip by its own law, and the radius that the law gives.
//
// A fit to measured points knows ln a to within a half-width of confidence: the true radius lies in [a / f, a f]. Where
// the points scatter, f is far from 1, and what is said for roundings does not hold for it.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include <patchgrip/cli/scene/place.h>
#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/contact/estimate.h>
#include <patchgrip/contact/fingertip/power_law.h>

namespace patchgrip::cli {

// A soft fingertip by the laws of Keppler 4.3.2.
struct PowerLawFingertip {
  double coefficient;  // c [m N^-gamma]
  double exponent;     // gamma
  double alpha;        // of the pressure of Xydas and Kao
};
struct MeasuredFingertip {
  std::vector<std::array<double, 2>> points;  // F_N [N], a [m]
  double confidence;
  double alpha;
};
struct WinklerFingertip {
  double radius;  // R [m]
  double bed;     // c [Pa]
};

using Fingertip = std::variant<PowerLawFingertip, MeasuredFingertip, WinklerFingertip>;

struct DescribedFingertip {
  Fingertip tip;
  std::string words;
  Place place;
};

// Throws SceneError.
DescribedFingertip read_fingertip(const TomlReader& contact);

// The fit to measured points. Throws std::invalid_argument.
contact::PowerLawFit fit_to(const MeasuredFingertip& tip);

struct FingertipRadius {
  contact::Estimate radius;           // a [m], as it is rounded
  double factor = 1;                  // f, which then holds the rounding too; 1 where the points tell no scatter
  std::vector<std::string> warnings;  // where the law is used beyond what it is known for
};

FingertipRadius radius_under(const PowerLawFingertip& tip, double normal_force);
// Throws std::invalid_argument where f is beyond 10: that is no radius.
FingertipRadius radius_under(const MeasuredFingertip& tip, const contact::PowerLawFit& fit, double normal_force);

// No elastic ball has an exponent above 1/3; `least` is what it surely is.
void warn_of_exponent(std::vector<std::string>& warnings, double least);

}  // namespace patchgrip::cli
