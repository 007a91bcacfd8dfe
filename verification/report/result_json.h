// The result of a case as JSON: versions, runs, and every quantity with FE's value, its error and the library's value.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include <patchgrip/verification/cases/case.h>

namespace patchgrip::verification {

std::map<std::string, std::string> versions();

// Throws std::runtime_error where the file cannot be written.
void write_result(const std::filesystem::path& file, const Case& one, std::string_view level, const Study& study);

}  // namespace patchgrip::verification
