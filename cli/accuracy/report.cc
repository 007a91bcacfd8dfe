#include <patchgrip/cli/accuracy/report.h>

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

constexpr double unit = 0x1p-53;

constexpr std::string_view row = "{:<{}}  {:<{}}  {:<{}}  {:>7}  {:>8}  {:>8}  {:>8}  {:>8}  {:>8}\n";

std::string number(double error) { return fmt::format("{:.1e}", error); }

std::string units(double error) {
  return error < 1e5 * unit ? fmt::format("{:.2f}", error / unit) : number(error / unit);
}

}  // namespace

void AccuracyReport::add(const Kind& kind, const Deviation& error, std::string_view place, double stated) {
  auto line = std::find_if(lines_.begin(), lines_.end(), [&](const Line& known) { return known.kind == kind; });
  if (line == lines_.end()) line = lines_.insert(end_of_group(kind), Line{kind});
  const double beyond = std::min(error.as_is, error.own) - stated, judged = beyond < 0 ? 0 : beyond;
  if (line->entries == 0 || judged > line->judged) {
    line->judged = judged;
    line->worst_at = place;
  }
  line->worst = std::max(line->worst, error.as_is);
  line->own = std::max(line->own, error.own);
  line->stated = std::max(line->stated, stated);
  line->sum += error.as_is;
  ++line->entries;
}

std::vector<AccuracyReport::Line>::iterator AccuracyReport::end_of_group(const Kind& kind) {
  const auto last = std::find_if(lines_.rbegin(), lines_.rend(), [&](const Line& line) {
    return line.kind.section == kind.section && line.kind.contact == kind.contact;
  });
  return last == lines_.rend() ? lines_.end() : last.base();
}

void AccuracyReport::not_covered(std::string_view section, std::string_view what) {
  auto gap = std::find_if(not_covered_.begin(), not_covered_.end(),
                          [&](const Gap& known) { return known.section == section && known.what == what; });
  if (gap == not_covered_.end()) {
    gap = not_covered_.insert(not_covered_.end(), Gap{std::string(section), std::string(what)});
  }
  ++gap->times;
}

std::size_t AccuracyReport::entries() const noexcept {
  std::size_t n = 0;
  for (const Line& line : lines_) n += line.entries;
  return n;
}

std::size_t AccuracyReport::kinds_beyond(double tolerance) const noexcept {
  return static_cast<std::size_t>(
      std::count_if(lines_.begin(), lines_.end(), [&](const Line& line) { return !(line.judged <= tolerance); }));
}

void AccuracyReport::print(std::ostream& out, double tolerance) const {
  if (!lines_.empty()) print_errors(out);
  print_stated(out);
  print_beyond(out, tolerance);
  print_gaps(out);
}

void AccuracyReport::print_errors(std::ostream& out) const {
  const auto width = [&](std::string Kind::*field, std::size_t least) {
    for (const Line& line : lines_) least = std::max(least, (line.kind.*field).size());
    return least;
  };
  const std::size_t section = width(&Kind::section, 7);
  const std::size_t contact = width(&Kind::contact, 7);
  const std::size_t quantity = width(&Kind::quantity, 8);
  const auto print_row = [&](const Kind& kind, auto... cells) {
    out << fmt::format(fmt::runtime(row), kind.section, section, kind.contact, contact, kind.quantity, quantity,
                       cells...);
  };
  print_row({"section", "contact", "quantity"}, "entries", "worst", "mean", "worst/u", "mean/u", "own/u");
  for (const Line& line : lines_) {
    const double mean = line.sum / static_cast<double>(line.entries);
    print_row(line.kind, line.entries, number(line.worst), number(mean), units(line.worst), units(mean),
              units(line.own));
  }
}

void AccuracyReport::print_stated(std::ostream& out) const {
  for (const Line& line : lines_) {
    if (line.stated == 0) continue;
    out << fmt::format("The table states {:.1e} of {} of {} in {}\n", line.stated, line.kind.quantity,
                       line.kind.contact, line.kind.section);
  }
}

void AccuracyReport::print_beyond(std::ostream& out, double tolerance) const {
  for (const Line& line : lines_) {
    if (line.judged <= tolerance) continue;
    out << fmt::format("Error {:.3g}{} > {:g}: {} of {} at {}\n", line.judged,
                       line.stated > 0 ? " beyond what is stated" : "", tolerance, line.kind.quantity,
                       line.kind.contact, line.worst_at);
  }
}

void AccuracyReport::print_gaps(std::ostream& out) const {
  for (const Gap& gap : not_covered_) {
    out << fmt::format("Not covered: {}: {}", gap.section, gap.what);
    if (gap.times > 1) out << fmt::format(" ({} entries)", gap.times);
    out << '\n';
  }
}

}  // namespace patchgrip::cli
