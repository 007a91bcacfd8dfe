// A number and how far from the truth it may be: a bound where the header of what gives it says bound, else an
// estimate.
#pragma once

namespace patchgrip::contact {

struct Estimate {
  double value;
  double error;  // >= 0, in the unit of the value
};

}  // namespace patchgrip::contact
