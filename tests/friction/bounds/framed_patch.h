// A patch in a frame of its own, with its reference there; moments as seen from the contact frame.
#pragma once

#include <patchgrip/friction/any_patch.h>
#include <patchgrip/tests/friction/bounds/exact_friction.h>
#include <patchgrip/tests/friction/frame_reference.h>

namespace patchgrip::friction::bounds {

struct FramedPatch {
  AnyPatch patch;
  Gradient50 gradient;
  double x, y, radius;
  Moments50 moments;
};

}  // namespace patchgrip::friction::bounds
