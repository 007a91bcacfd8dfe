// A number and how far from the truth it may be: a bound where the header of what gives it says bound, else an
// estimate.
#pragma once

namespace patchgrip::contact {

template <class Real>
struct BasicEstimate {
  Real value;
  Real error;  // >= 0, in the unit of the value
};

using Estimate = BasicEstimate<double>;

}  // namespace patchgrip::contact
