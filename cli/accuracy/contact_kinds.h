// Kinds of entries in tables like data/reference/contact.json, and what the library says to each.
//
// An entry states a problem by name, its inputs, and the outputs that are right:
//
//     {"name": "dmt", "inputs": {"R": {"value": "0.01", "unit": "m"}, ...}, "outputs": {"a_K": {"value": ...}}}
//
// A kind maps the inputs to outputs by the names of the table. It may give more than an entry asks for; what it does
// not give is named as not covered. An evaluation that throws for the entry's own inputs counts as infinitely wrong.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/accuracy/inputs.h>
#include <patchgrip/cli/accuracy/node.h>

namespace patchgrip::cli {

// The inputs of one entry, rounded to double or moved (inputs.h).
class EntryInputs {
 public:
  EntryInputs(TableObject& fields, std::vector<std::string> asked, Inputs inputs)
      : fields_(fields), asked_(std::move(asked)), inputs_(inputs) {}

  // Throw TableError where the input is missing or not such a number.
  double operator[](std::string_view name) const;
  int integer(std::string_view name) const;

  bool has(std::string_view name) const;

  // Inputs <stem>_1, <stem>_2, ... as far as they go.
  std::vector<double> series(std::string_view stem) const;

  // Names of the outputs that the entry asks for.
  const std::vector<std::string>& asked() const noexcept { return asked_; }

 private:
  Exact exact(std::string_view name) const;

  TableObject& fields_;
  std::vector<std::string> asked_;
  Inputs inputs_;
};

struct Output {
  std::string name;
  double value;  // 1 and 0 for true and false
};

struct ContactKind {
  std::string_view name;
  std::vector<Output> (*evaluate)(const EntryInputs&);
};

// Every kind that the library covers.
std::span<const ContactKind> contact_kinds();

// Its parts, one file each.
std::span<const ContactKind> adhesion_kinds();
std::span<const ContactKind> creep_kinds();
std::span<const ContactKind> half_space_kinds();
std::span<const ContactKind> hertz_kinds();
std::span<const ContactKind> round_kinds();

}  // namespace patchgrip::cli
