#include <patchgrip/cli/accuracy/number.h>

#include <algorithm>
#include <string>

namespace patchgrip::cli {
namespace {

constexpr std::size_t most_digits = 1000;
constexpr std::size_t most_exponent_digits = 4;

std::size_t leading_digits(std::string_view text) {
  return static_cast<std::size_t>(std::find_if(text.begin(), text.end(), [](char c) { return c < '0' || c > '9'; }) -
                                  text.begin());
}

bool skip_one_of(std::string_view& text, std::string_view characters) {
  if (text.empty() || characters.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

std::size_t skip_digits(std::string_view& text) {
  const std::size_t n = leading_digits(text);
  text.remove_prefix(n);
  return n;
}

bool is_decimal(std::string_view text) {
  if (text.size() > most_digits) return false;
  skip_one_of(text, "+-");
  std::size_t digits = skip_digits(text);
  if (skip_one_of(text, ".")) digits += skip_digits(text);
  if (digits == 0) return false;
  if (skip_one_of(text, "eE")) {
    skip_one_of(text, "+-");
    const std::size_t exponent = skip_digits(text);
    if (exponent == 0 || exponent > most_exponent_digits) return false;
  }
  return text.empty();
}

std::optional<Exact> parse_decimal(std::string_view text) {
  if (!is_decimal(text)) return std::nullopt;
  return Exact(std::string(text));
}

}  // namespace

std::optional<Exact> parse_exact(std::string_view text) {
  const std::size_t slash = text.find('/');
  auto value = parse_decimal(text.substr(0, slash));
  if (slash == std::string_view::npos || !value) return value;
  const auto divisor = parse_decimal(text.substr(slash + 1));
  if (!divisor || *divisor == 0) return std::nullopt;
  return *value / *divisor;
}

}  // namespace patchgrip::cli
