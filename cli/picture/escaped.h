// Text as it stands in SVG and HTML.
#pragma once

#include <string>
#include <string_view>

namespace patchgrip::cli {

inline std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace patchgrip::cli
