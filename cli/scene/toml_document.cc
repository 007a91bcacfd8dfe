#include <patchgrip/cli/scene/toml_document.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include <patchgrip/cli/scene/toml_scan.h>

namespace patchgrip::cli {
namespace {

constexpr std::size_t largest_file = 16U << 20U;

std::string_view line_of(std::string_view text, std::size_t line) {
  for (; line > 1; --line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t first = text.find_first_not_of(blank);
  return first == std::string_view::npos ? std::string_view{}
                                         : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

// TOML counts columns in characters from 1.
std::size_t offset_in(std::string_view line, std::size_t column) {
  std::size_t offset = 0;
  for (std::size_t seen = 0; offset < line.size(); ++offset) {
    if ((static_cast<unsigned char>(line[offset]) & 0xc0) != 0x80 && ++seen == column) break;
  }
  return offset;
}

std::string read_text(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code status_error;
  const auto status = std::filesystem::status(file, status_error);
  if (status_error) throw SceneError(name, 0, "cannot be read: " + status_error.message());
  if (std::filesystem::is_directory(status)) throw SceneError(name, 0, "is a directory, not a TOML file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(name.c_str(), "rb"), &std::fclose);
  if (!stream) throw SceneError(name, 0, "cannot be read: " + std::generic_category().message(errno));

  std::string text;
  constexpr std::size_t block = 1U << 16U;
  std::size_t count = 0;
  do {
    const std::size_t size = text.size();
    text.resize(size + block);
    count = std::fread(text.data() + size, 1, block, stream.get());
    text.resize(size + count);
    if (text.size() > largest_file)
      throw SceneError(name, 0, "is larger than 16 MiB, the most that a TOML file may have");
  } while (count == block);
  if (std::ferror(stream.get()) != 0)
    throw SceneError(name, 0, "cannot be read: " + std::generic_category().message(errno));
  return text;
}

}  // namespace

TomlDocument::TomlDocument(std::string name, std::string text, toml::table root)
    : name_(std::move(name)), text_(std::move(text)), root_(std::move(root)) {}

TomlDocument TomlDocument::read(const std::filesystem::path& file) { return parse(read_text(file), file.string()); }

TomlDocument TomlDocument::parse(std::string text, std::string name) {
  const auto broken = [&](std::size_t line, std::string_view message) {
    const std::string_view shown = trimmed(line_of(text, line));
    return SceneError(name, line,
                      shown.empty() ? std::string(message) : fmt::format("{}: {}", printable(shown), message));
  };
  if (const auto problem = scan_toml(text)) throw broken(problem->line, problem->message);
  toml::table root;
  try {
    root = toml::parse(std::string_view(text), std::string_view(name));
  } catch (const toml::parse_error& error) {
    throw broken(std::max<std::size_t>(1, error.source().begin.line), printable(error.description(), 300));
  }
  return {std::move(name), std::move(text), std::move(root)};
}

std::string TomlDocument::written(const toml::node& node) const {
  const auto [begin, end] = std::pair(node.source().begin, node.source().end);
  const std::string_view line = line_of(text_, begin.line);
  const std::size_t first = offset_in(line, begin.column);
  if (end.line != begin.line) return printable(trimmed(line.substr(first))) + " ...";
  return printable(trimmed(line.substr(first, offset_in(line, end.column) - first)));
}

}  // namespace patchgrip::cli
