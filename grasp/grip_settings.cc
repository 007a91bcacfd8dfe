#include <patchgrip/grasp/grip_settings.h>

#include <patchgrip/contact/require.h>

namespace patchgrip::grasp {

void GripSettings::check() const {
  contact::require_in("relative_width", relative_width, 0, 1, contact::Ends::open);
  contact::require_in("interior_tolerance", interior_tolerance, 1e-12, 1e-2);
  if (max_iterations < 1) contact::refuse("max_iterations", max_iterations, "must be at least 1");
  if (max_repairs < 1) contact::refuse("max_repairs", max_repairs, "must be at least 1");
  contact::require_positive("force_limit", force_limit);
}

}  // namespace patchgrip::grasp
