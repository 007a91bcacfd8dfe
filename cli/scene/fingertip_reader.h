// The table [contact.fingertip] of a scene: a soft fingertip by its own law.
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

// a = c F^gamma for c (relative) and gamma (absolute) right to so many units of 2^-53.
contact::Estimate radius_under(const contact::PowerLaw& law, double normal_force, double units);

}  // namespace patchgrip::cli
