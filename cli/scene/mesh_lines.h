// Where a triangle stands in a mesh file, for what is said of it.
#pragma once

#include <cstddef>
#include <filesystem>

namespace patchgrip::cli {

// Line of a triangle, counted from 0, in an OFF or STL file as text; 0 in other files, and where corners and triangles
// have no lines of their own.
std::size_t line_of_triangle(const std::filesystem::path& file, std::size_t triangle);

}  // namespace patchgrip::cli
