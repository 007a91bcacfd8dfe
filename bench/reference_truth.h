// Any reference of the tests as the judge of a method.
#pragma once

#include <span>

#include <patchgrip/bench/truth.h>
#include <patchgrip/tests/friction/frame_reference.h>

namespace patchgrip::bench {

Truth reference_truth(const friction::Gradient50& gradient, std::span<const friction::Twist> twists);

}  // namespace patchgrip::bench
