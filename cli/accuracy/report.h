// What the comparison with one reference table found: errors by kind, and what is not covered.
//
// A kind is a quantity of a type of contact in a section of the table.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/accuracy/inputs.h>

namespace patchgrip::cli {

class AccuracyReport {
 public:
  struct Kind {
    std::string section;
    std::string contact;
    std::string quantity;
    bool operator==(const Kind&) const = default;
  };

  // `stated` is the accuracy that the table claims for the entry, relative to the same scale: as much is let pass.
  void add(const Kind& kind, const Deviation& error, std::string_view place, double stated = 0);

  // `what` of `section`, once more.
  void not_covered(std::string_view section, std::string_view what);

  std::size_t entries() const noexcept;
  std::size_t kinds_beyond(double tolerance) const noexcept;
  std::size_t not_covered() const noexcept { return not_covered_.size(); }

  void print(std::ostream& out, double tolerance) const;

 private:
  struct Line {
    Kind kind;
    std::size_t entries = 0;
    double worst = 0;  // error as it is
    double sum = 0;
    double own = 0;          // worst without the rounding of the inputs
    double judged = 0;       // worst of the smaller of the two, beyond what is stated
    double stated = 0;       // largest
    std::string worst_at{};  // place of `judged`
  };

  struct Gap {
    std::string section;
    std::string what;
    std::size_t times = 0;
  };

  std::vector<Line>::iterator end_of_group(const Kind& kind);  // of the lines for the same contact in the same section
  void print_errors(std::ostream& out) const;
  void print_stated(std::ostream& out) const;
  void print_beyond(std::ostream& out, double tolerance) const;
  void print_gaps(std::ostream& out) const;

  std::vector<Line> lines_;
  std::vector<Gap> not_covered_;
};

}  // namespace patchgrip::cli
