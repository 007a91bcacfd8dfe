// Outputs of one call: none is its scene, and no two are the same file.
//
// Throws   OutputError, naming file or options.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace patchgrip::cli {

struct NamedOutput {
  std::string_view option;  // "--table"
  const std::string& file;  // empty for none
};

void refuse_clashes(const std::string& scene, std::span<const NamedOutput> outputs);

}  // namespace patchgrip::cli
