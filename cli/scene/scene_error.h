// What is wrong with a scene: file, line, key, value and what is allowed there.
//
//     tilt.toml:7: contact.radius = -0.005: a radius in m, from 1e-60 to 1e60
//
// Line 0 stands for the file as a whole (it cannot be read, say).
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace patchgrip::cli {

class SceneError : public std::runtime_error {
 public:
  SceneError(std::string_view file, std::size_t line, std::string_view message);
  // The same with more to say at its end.
  SceneError(const SceneError& error, std::string_view more);

  std::size_t line() const noexcept { return line_; }

 private:
  std::size_t line_;
};

// "file:line: message", without the line where it is 0.
std::string located(std::string_view file, std::size_t line, std::string_view message);

// Text that is safe on a terminal and in a comment line: control characters and broken UTF-8 become \xNN, and what is
// longer than `limit` bytes is cut ("...").
std::string printable(std::string_view text, std::size_t limit = 60);

}  // namespace patchgrip::cli
