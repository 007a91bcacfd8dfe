#include <patchgrip/cli/scene/scene_error.h>

#include <fmt/format.h>

#include <iterator>

namespace patchgrip::cli {
namespace {

constexpr std::size_t no_limit = std::string_view::npos;

// Bytes of the UTF-8 character at the start of `text`; 0 if there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xc2 ? 0
                             : lead < 0xe0 ? 2
                             : lead < 0xf0 ? 3
                             : lead < 0xf5 ? 4
                                           : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  return length;
}

bool is_control(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character[0]);
  return lead < 0x20 || lead == 0x7f || (lead == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0);
}

}  // namespace

std::string located(std::string_view file, std::size_t line, std::string_view message) {
  const std::string name = printable(file, no_limit);
  return line == 0 ? fmt::format("{}: {}", name, message) : fmt::format("{}:{}: {}", name, line, message);
}

SceneError::SceneError(std::string_view file, std::size_t line, std::string_view message)
    : std::runtime_error(located(file, line, message)), line_(line) {}

SceneError::SceneError(const SceneError& error, std::string_view more)
    : std::runtime_error(error.what() + std::string(more)), line_(error.line_) {}

std::string printable(std::string_view text, std::size_t limit) {
  std::string out;
  while (!text.empty()) {
    if (out.size() >= limit) return out + "...";
    const std::size_t length = character_length(text);
    const std::string_view character = text.substr(0, length == 0 ? 1 : length);
    if (length != 0 && !is_control(character)) {
      out += character;
    } else {
      for (const char byte : character)
        fmt::format_to(std::back_inserter(out), "\\x{:02x}", static_cast<unsigned char>(byte));
    }
    text.remove_prefix(character.size());
  }
  return out;
}

}  // namespace patchgrip::cli
