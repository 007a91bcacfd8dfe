// A TOML file, parsed, with its text kept so that errors can show values as they were written.
//
// Refused before anything is built from it: a folder, more than 16 MiB, broken TOML or UTF-8, duplicate keys, numbers
// that a double cannot hold (1e999, 1e-999), keys of more than 16 dots.
//
// Throws   SceneError with the file and, unless the file as a whole is wrong, the line.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <string_view>

#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {

class TomlDocument {
 public:
  static TomlDocument read(const std::filesystem::path& file);
  static TomlDocument parse(std::string text, std::string name);

  const toml::table& root() const noexcept { return root_; }
  const std::string& name() const noexcept { return name_; }

  // The node as written in the file, on one line.
  std::string written(const toml::node& node) const;

  [[noreturn]] void fail(std::size_t line, std::string_view message) const { throw SceneError(name_, line, message); }

 private:
  TomlDocument(std::string name, std::string text, toml::table root);

  std::string name_;
  std::string text_;
  toml::table root_;
};

}  // namespace patchgrip::cli
