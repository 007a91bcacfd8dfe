// Files that live as long as the program: meshes, inputs and results of solvers.
#pragma once

#include <filesystem>
#include <string>

namespace patchgrip::verification {

std::filesystem::path new_work_file(const std::string& extension);  // e.g. ".msh"

}  // namespace patchgrip::verification
