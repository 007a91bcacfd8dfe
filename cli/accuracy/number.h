// Numbers of reference tables, with all their digits.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>
#include <string_view>

namespace patchgrip::cli {

// What a reference is compared in: rounding it to double alone would cost half a unit.
using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

// A decimal ("-1.5e-3") or a fraction of two ("17/12"); nothing for any other text, or beyond 10^+-4999.
std::optional<Exact> parse_exact(std::string_view text);

}  // namespace patchgrip::cli
