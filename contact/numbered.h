// Names of numbered parameters in refusals: tau_2.
#pragma once

#include <string>
#include <string_view>

namespace patchgrip::contact {

inline std::string numbered(std::string_view stem, std::size_t number) {
  return std::string(stem).append("_").append(std::to_string(number));
}

}  // namespace patchgrip::contact
