// How far a long run is, on a terminal: "tabulate: 37 %", at most ten times a second, erased at the end.
//
// Silent when standard error is not a terminal, when the result itself goes to a terminal, and in the first half
// second.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace patchgrip::cli {

class Progress {
 public:
  Progress(std::string what, std::size_t total, bool shown);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  static constexpr int no_output = -1;  // where nothing is written while it runs

  // True when standard error is a terminal and `output` is not.
  static bool wanted(int output) noexcept;

  void at(std::size_t done);

 private:
  std::string what_;
  std::size_t total_;
  bool shown_;
  bool written_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace patchgrip::cli
