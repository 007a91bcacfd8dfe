#include <patchgrip/cli/accuracy/contact_kinds.h>

#include <fmt/format.h>

#include <array>
#include <limits>

namespace patchgrip::cli {
namespace {

std::vector<ContactKind> collected() {
  const std::array parts{adhesion_kinds(), creep_kinds(), half_space_kinds(), hertz_kinds(), round_kinds()};
  std::vector<ContactKind> kinds;
  for (const auto& part : parts) kinds.insert(kinds.end(), part.begin(), part.end());
  return kinds;
}

}  // namespace

std::span<const ContactKind> contact_kinds() {
  static const std::vector<ContactKind> kinds = collected();
  return kinds;
}

Exact EntryInputs::exact(std::string_view name) const {
  TableObject input(fields_[name]);
  input.find("unit");
  return input["value"].number();
}

double EntryInputs::operator[](std::string_view name) const { return as_double(exact(name), inputs_); }

int EntryInputs::integer(std::string_view name) const {
  const Exact value = exact(name);
  if (value != trunc(value) || abs(value) > std::numeric_limits<int>::max()) {
    fields_[name].fail("a whole number is expected");
  }
  return static_cast<int>(value);
}

bool EntryInputs::has(std::string_view name) const { return fields_.find(name).has_value(); }

std::vector<double> EntryInputs::series(std::string_view stem) const {
  std::vector<double> values;
  for (std::size_t i = 1;; ++i) {
    const std::string name = fmt::format("{}_{}", stem, i);
    if (!has(name)) return values;
    values.push_back((*this)[name]);
  }
}

}  // namespace patchgrip::cli
