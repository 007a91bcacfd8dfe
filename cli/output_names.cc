#include <patchgrip/cli/output_names.h>

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include <patchgrip/cli/output_file.h>
#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {

void refuse_clashes(const std::string& scene, std::span<const NamedOutput> outputs) {
  for (const NamedOutput& output : outputs) {
    std::error_code no_such_output;
    if (std::filesystem::equivalent(scene, output.file, no_such_output)) {
      throw OutputError(printable(output.file, std::string::npos) + ": is the scene itself");
    }
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (outputs[i].file.empty() || outputs[i].file != outputs[j].file) continue;
      throw OutputError(fmt::format("{} and {} name the same file", outputs[i].option, outputs[j].option));
    }
  }
}

}  // namespace patchgrip::cli
