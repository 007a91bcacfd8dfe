// Which model of adhesion is enough: Hertz, DMT or JKR against Maugis-Dugdale, by the radius of contact under a load.
//
// The map of Johnson and Greenwood (J. Colloid Interface Sci. 192, 1997) over lambda and F / (pi w R), with its borders
// where the models differ by the tolerance that is asked for.
//
// Domain   as maugis_dugdale.h; F not below its pull-off.
// Error    of the errors themselves: 1e-12, absolute, away from the pull-off. A model without contact under this load
//          is infinitely wrong.
// Throws   std::invalid_argument, naming the parameter, outside the domain.
#pragma once

#include <patchgrip/contact/adhesion/maugis_dugdale.h>

namespace patchgrip::contact {

enum class AdhesionModel { hertz, dmt, jkr, maugis_dugdale };  // by cost

struct AdhesionMap {
  static AdhesionMap of(const MaugisDugdale& reference, double normal_force);

  // The first whose radius is within `tolerance` of that of Maugis and Dugdale.
  AdhesionModel cheapest_within(double tolerance) const;

  double hertz_error;  // |a / a_MD - 1| [1]
  double dmt_error;
  double jkr_error;
};

}  // namespace patchgrip::contact
