// Friction under a stamp of revolution: whatever round pressure a smooth profile makes.
//
// A contact of radius a grows by annuli: while its radius is s, a further approach dg(s) presses like a flat punch of
// that radius (Mossakovskii; Jaeger). The contact is a stack of flat punches, of which those between s and s + ds carry
// the share
//
//     w(s) ds = 2 E* s g'(s) ds / F,       int_0^a w ds = 1        (contact/axisymmetric.h; g(a) is the approach)
//
// of the normal force, and every function of the patch is the average of the flat punch's over them. It is integrated
// once, in the factory (some 0.1 s), into the table that evaluates it (kernels/round_table.h); copies share it.
//
// Domain   every pole; w smooth in (0, a] and ~ s^order at s = 0 with order >= 1/2: no flat end, no kink.
// Units    a, s [m], w [1/m].
// Error    <= 8 units of 2^-53 of force and of moment (round_patch.h), and the relative error of w where that differs
//          from punch to punch.
// Throws   std::invalid_argument outside the domain, and where w does not carry the whole force.
#pragma once

#include <functional>

#include <patchgrip/friction/kernels/table_kernel.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

class StampDisc : public RoundPatch<kernels::TableKernel> {
 public:
  static StampDisc of_punches(double radius, const std::function<double(double)>& share_per_radius, double order);

 private:
  StampDisc(double radius, double polar, kernels::TableKernel kernel) : RoundPatch(radius, polar, std::move(kernel)) {}
};

}  // namespace patchgrip::friction
