#include <patchgrip/cli/scene/toml_scan.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

constexpr std::size_t deepest_key = 16;

bool is_word_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '+' ||
         c == '-' || c == '.';
}

bool fits_double(std::string word) {
  std::erase(word, '_');
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  return std::from_chars(digits.data(), digits.data() + digits.size(), value).ec != std::errc::result_out_of_range;
}

// Length of the string at the start of `text`, its quotes included; all of `text` when it never ends.
std::size_t string_length(std::string_view text) {
  const char quote = text[0];
  const std::string triple(3, quote);
  const bool multi_line = text.starts_with(triple);
  const std::string_view close = multi_line ? std::string_view(triple) : text.substr(0, 1);
  for (std::size_t i = close.size(); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text.substr(i).starts_with(close)) {
      std::size_t end = i + close.size();
      for (int extra = 0; multi_line && extra < 2 && end < text.size() && text[end] == quote; ++extra) ++end;
      return end;
    } else if (text[i] == '\n' && !multi_line) {
      return i;
    }
  }
  return text.size();
}

}  // namespace

std::optional<TomlProblem> scan_toml(std::string_view text) {
  std::size_t line = 1;
  std::size_t dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    std::size_t length = 1;
    if (c == '#') {
      length = std::min(text.find('\n', i), text.size()) - i;
    } else if (c == '"' || c == '\'') {
      length = string_length(text.substr(i));
      line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                                  text.begin() + static_cast<std::ptrdiff_t>(i + length), '\n'));
    } else if (is_word_character(c)) {
      const auto* const end = std::find_if_not(text.begin() + i, text.end(), is_word_character);
      const std::string_view word(text.begin() + i, end);
      length = word.size();
      dots += static_cast<std::size_t>(std::count(word.begin(), word.end(), '.'));
      if (dots > deepest_key) return TomlProblem{line, fmt::format("a key may have at most {} dots", deepest_key)};
      if (word.find_first_of(".eE") != std::string_view::npos && !fits_double(std::string(word))) {
        return TomlProblem{line, fmt::format("{} is beyond the range of a double", printable(word))};
      }
    } else if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') {
      line += c == '\n' ? 1 : 0;
      dots = 0;
    }
    i += length;
  }
  return std::nullopt;
}

}  // namespace patchgrip::cli
