#include <patchgrip/contact/require.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace patchgrip::contact {
namespace {

std::string shortest(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

}  // namespace

void refuse(std::string_view name, double value, std::string_view rule) {
  throw std::invalid_argument(std::string(name) + " = " + shortest(value) + " is not allowed: " + std::string(rule));
}

double require_positive(std::string_view name, double value) {
  if (!(value > 0 && std::isfinite(value))) refuse(name, value, "must be positive and finite");
  return value;
}

double require_non_negative(std::string_view name, double value) {
  if (!(value >= 0 && std::isfinite(value))) refuse(name, value, "must be non-negative and finite");
  return value;
}

double require_finite(std::string_view name, double value) {
  if (!std::isfinite(value)) refuse(name, value, "must be finite");
  return value;
}

double require_representable(std::string_view name, double value) {
  return require_in(name, value, std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
}

double require_radius(std::string_view name, double value) {
  if (!(std::isfinite(value) || value == std::numeric_limits<double>::infinity()) || value == 0) {
    refuse(name, value, "must be positive (infinite for a plane), or negative and finite for a hollow");
  }
  return value;
}

double require_in(std::string_view name, double value, double lo, double hi, Ends ends) {
  const bool without_lo = ends == Ends::open || ends == Ends::left_open;
  const bool without_hi = ends == Ends::open || ends == Ends::right_open;
  if (!(without_lo ? value > lo : value >= lo) || !(without_hi ? value < hi : value <= hi)) {
    refuse(name, value,
           std::string("must lie in ") + (without_lo ? "(" : "[") + shortest(lo) + ", " + shortest(hi) +
               (without_hi ? ")" : "]"));
  }
  return value;
}

}  // namespace patchgrip::contact
