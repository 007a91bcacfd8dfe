// A finite sequence of numbers that need not be stored: a list, or a range with equal steps or equal ratios.
//
// The ends of a range are exact; a range with equal steps from -x to x of odd count has an exact 0 in the middle.
//
//     equal steps    ((n - 1 - i) from + i to) / (n - 1),  i = 0 .. n - 1
//     equal ratios   from (to / from)^(i / (n - 1)),       ends of the same sign
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

namespace patchgrip::cli {

class Sequence {
 public:
  static Sequence of_values(std::vector<double> values);
  static Sequence equal_steps(double from, double to, std::size_t count);   // count >= 2
  static Sequence equal_ratios(double from, double to, std::size_t count);  // count >= 2, from / to > 0

  std::size_t size() const noexcept;
  double operator[](std::size_t i) const noexcept;

 private:
  struct Range {
    double from;
    double to;
    std::size_t count;
    bool equal_ratios;
  };

  explicit Sequence(std::variant<std::vector<double>, Range> values);

  std::variant<std::vector<double>, Range> values_;
};

}  // namespace patchgrip::cli
