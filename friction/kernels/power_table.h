// The table of the power family p ~ (1 - r^2)^(n - 1/2), n >= -1/2.
#pragma once

#include <memory>

#include <patchgrip/friction/kernels/round_table.h>

namespace patchgrip::friction::kernels {

// Rows that a pressure p ~ d^edge at the rim needs: f and m carry a singular part d^(edge + 2), f' one of d^(edge + 1).
int rim_levels(double edge) noexcept;

std::shared_ptr<const RoundTable> power_table(double n);

}  // namespace patchgrip::friction::kernels
