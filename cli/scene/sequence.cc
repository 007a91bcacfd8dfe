#include <patchgrip/cli/scene/sequence.h>

#include <cmath>
#include <utility>

namespace patchgrip::cli {

Sequence::Sequence(std::variant<std::vector<double>, Range> values) : values_(std::move(values)) {}

Sequence Sequence::of_values(std::vector<double> values) { return Sequence(std::move(values)); }

Sequence Sequence::equal_steps(double from, double to, std::size_t count) {
  return Sequence(Range{from, to, count, false});
}

Sequence Sequence::equal_ratios(double from, double to, std::size_t count) {
  return Sequence(Range{from, to, count, true});
}

std::size_t Sequence::size() const noexcept {
  const auto* const range = std::get_if<Range>(&values_);
  return range != nullptr ? range->count : std::get_if<std::vector<double>>(&values_)->size();
}

double Sequence::operator[](std::size_t i) const noexcept {
  const auto* const range = std::get_if<Range>(&values_);
  if (range == nullptr) return (*std::get_if<std::vector<double>>(&values_))[i];
  const std::size_t last = range->count - 1;
  if (i == 0) return range->from;
  if (i == last) return range->to;
  const auto before = static_cast<double>(i);
  const auto all = static_cast<double>(last);
  if (range->equal_ratios) return range->from * std::pow(range->to / range->from, before / all);
  return (static_cast<double>(last - i) * range->from + before * range->to) / all;
}

}  // namespace patchgrip::cli
