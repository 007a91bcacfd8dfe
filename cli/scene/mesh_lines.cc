#include <patchgrip/cli/scene/mesh_lines.h>

#include <fstream>
#include <sstream>
#include <string>

namespace patchgrip::cli {
namespace {

std::string first_word(const std::string& line) {
  std::string word;
  std::istringstream(line) >> word;
  return word;
}

std::size_t line_in_stl(std::istream& in, std::size_t triangle) {
  std::size_t line = 0, facets = 0;
  for (std::string text; std::getline(in, text);) {
    ++line;
    if (first_word(text) == "facet" && facets++ == triangle) return line;
  }
  return 0;
}

// "OFF", the numbers of corners and triangles, and one line for each of them; comments and empty lines between.
std::size_t line_in_off(std::istream& in, std::size_t triangle) {
  std::size_t line = 0, said = 0, corners = 0, triangles = 0, found = 0;
  for (std::string text; std::getline(in, text);) {
    ++line;
    const std::string word = first_word(text);
    if (word.empty() || word.front() == '#') continue;
    if (said == 0 && word != "OFF") return 0;
    if (said == 1 && !(std::istringstream(text) >> corners >> triangles)) return 0;
    if (said == 2 + corners + triangle) found = line;
    ++said;
  }
  return said == 2 + corners + triangles ? found : 0;
}

}  // namespace

std::size_t line_of_triangle(const std::filesystem::path& file, std::size_t triangle) {
  std::ifstream in(file);
  const std::string kind = file.extension().string();
  if (kind == ".stl" || kind == ".STL") return line_in_stl(in, triangle);
  if (kind == ".off" || kind == ".OFF") return line_in_off(in, triangle);
  return 0;
}

}  // namespace patchgrip::cli
