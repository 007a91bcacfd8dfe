#include <patchgrip/cli/scene/materials.h>

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;

bool is_plain(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

double sourced_value(const TomlReader& material, std::string_view key, const Quantity& quantity) {
  const TomlReader entry = material.table(key, {"value", "source"});
  if (entry.text("source").empty()) entry.refuse("source", "where the value is from");
  return entry.number("value", quantity);
}

contact::Material read_material(const fs::path& file) {
  const TomlDocument document = TomlDocument::read(file);
  const TomlReader material(document, document.root(), "", {"title", "youngs_modulus", "poisson_ratio"});
  if (material.has("title")) material.text("title");
  const double modulus = sourced_value(material, "youngs_modulus", youngs_modulus);
  return contact::Material::elastic(modulus, sourced_value(material, "poisson_ratio", poisson_ratio));
}

}  // namespace

MaterialLibrary::MaterialLibrary(std::vector<fs::path> folders) : folders_(std::move(folders)) {}

MaterialLibrary MaterialLibrary::for_scene(const fs::path& scene) {
  const fs::path folder = scene.parent_path();
  std::vector<fs::path> folders{folder / "materials", folder / ".." / "materials"};
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) std::ranges::move(material_folders_of(program), std::back_inserter(folders));
  return MaterialLibrary(std::move(folders));
}

std::vector<fs::path> material_folders_of(const fs::path& program) {
  std::vector<fs::path> folders{program.parent_path().parent_path() / "share" / "patchgrip" / "materials"};
  for (fs::path above = program.parent_path(); above != above.root_path(); above = above.parent_path()) {
    std::error_code error;
    if (fs::is_directory(above / "data" / "materials", error)) folders.push_back(above / "data" / "materials");
  }
  return folders;
}

std::optional<contact::Material> MaterialLibrary::find(std::string_view name) const {
  if (!is_plain(name)) return std::nullopt;
  for (const fs::path& folder : folders_) {
    const fs::path file = folder / (std::string(name) + ".toml");
    std::error_code error;
    if (fs::exists(file, error)) return read_material(file);
  }
  return std::nullopt;
}

std::vector<std::string> MaterialLibrary::names() const {
  std::set<std::string> names;
  for (const fs::path& folder : folders_) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      if (entry->path().extension() == ".toml") names.insert(entry->path().stem().string());
    }
  }
  return {names.begin(), names.end()};
}

}  // namespace patchgrip::cli
