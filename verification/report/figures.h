// Figures of a case, as SVG: its curves, its convergence, its mesh with the von Mises stress.
#pragma once

#include <string>

#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

std::string curve_figure(const Curve& curve);
// Difference from the library, relative to the scale, against elements per radius; both axes logarithmic.
std::string convergence_figure(const Study& study);
// Up to `reach` from the axis and from the surface; the colour bar is in [Pa].
std::string stress_figure(const PlaneField& field, double reach);

}  // namespace patchgrip::verification
