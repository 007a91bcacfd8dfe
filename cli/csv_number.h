// Numbers of CSV tables: 17 significant digits, which read back as the same double; -0 is written as 0.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace patchgrip::cli {

inline void append_number(std::string& text, double value) {
  constexpr int digits = 17;
  std::array<char, 32> written;
  const auto end =
      std::to_chars(written.data(), written.data() + written.size(), value + 0.0, std::chars_format::general, digits)
          .ptr;
  text.append(written.data(), end);
}

}  // namespace patchgrip::cli
