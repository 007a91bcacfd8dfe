// Validation of physical parameters: one wording for every refusal in the library.
//
//     radius = -1 is not allowed: must be positive and finite
//     poisson_ratio = 0.7 is not allowed: must lie in (-1, 0.5]
//
// The value is printed with the fewest digits that read back to the same double. NaN is refused everywhere.
//
// An allowed value is returned, so that a factory can use it in place.
//
// Throws   std::invalid_argument with such a message.
#pragma once

#include <string_view>

namespace patchgrip::contact {

[[noreturn]] void refuse(std::string_view name, double value, std::string_view rule);

double require_positive(std::string_view name, double value);       // 0 < value < infinity
double require_non_negative(std::string_view name, double value);   // 0 <= value < infinity
double require_finite(std::string_view name, double value);         // -infinity < value < infinity
double require_representable(std::string_view name, double value);  // positive, neither overflowed nor underflowed
double require_radius(std::string_view name, double value);         // of curvature: +infinity, or finite and not 0

enum class Ends { closed, open, left_open, right_open };  // [lo, hi], (lo, hi), (lo, hi], [lo, hi)

double require_in(std::string_view name, double value, double lo, double hi, Ends ends = Ends::closed);

}  // namespace patchgrip::contact
