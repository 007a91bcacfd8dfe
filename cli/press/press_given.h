// Contacts that are not computed from two bodies: a given pressure, and the laws of soft fingertips.
#pragma once

#include <patchgrip/cli/press/pressed.h>

namespace patchgrip::cli {

Pressed press_given_pressure(const GivenPressure& given, const PressScene& scene);
Pressed press_fingertip(const PowerLawFingertip& tip, const PressScene& scene);
Pressed press_fingertip(const MeasuredFingertip& tip, const PressScene& scene);
Pressed press_fingertip(const WinklerFingertip& tip, const PressScene& scene);

}  // namespace patchgrip::cli
