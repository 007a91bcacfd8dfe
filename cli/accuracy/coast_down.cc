// misc.coast_down_limit_x and misc.coast_down_stop: a puck without a load, on a round patch under its centre.
//
// In the units of the table a = 1, m = 1, mu F_N = 1 and omega_0 = 1. All relative to itself.
#include <fmt/format.h>

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/dynamics/coast_down.h>
#include <patchgrip/dynamics/rigid_motion.h>
#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/uniform_disc.h>

namespace patchgrip::cli {
namespace {

// f(disc) of radius 1; false where there is no such disc.
template <class F>
bool with_disc(const std::string& name, F&& f) {
  using namespace friction;
  if (name == "hertz_disc") return f(HertzDisc::of_radius(1)), true;
  if (name == "uniform_disc") return f(UniformDisc::of_radius(1)), true;
  if (name == "flat_punch_disc") return f(FlatPunchDisc::of_radius(1)), true;
  if (name == "ring_line_load") return f(Ring::of_radius(1)), true;
  return false;
}

template <class P>
double stop_time(const P& disc, double q, double x0) {
  const dynamics::RigidMotion motion(disc, 1, 1 / q, friction::Law::coulomb(1));
  const dynamics::PlanarLoad load{[](double) { return dynamics::Vector3(dynamics::Vector3::Zero()); },
                                  [](double) { return 1.; }};
  dynamics::PlanarState from;
  from.twist = {x0, 0, 1};
  const double end = 1e3 * (1 + x0) * (1 + 1 / q);  // long after the stop
  const auto events = motion(load, from, 0, end, {.tolerance = 1e-14, .longest_step = end}).events;
  if (events.empty()) throw std::runtime_error("it does not stop");
  return events[0].time;
}

// `compare(entry, disc, q)` for every entry whose disc is known.
template <class Compare>
void compare_pucks(const TableNode& node, std::string_view section, AccuracyReport& report, const Compare& compare) {
  for (const TableNode& entry_node : node.filled()) {
    TableObject entry(entry_node);
    const std::string name = entry["contact"].text();
    const Exact q = entry["m a^2/J"].positive();
    if (with_disc(name, [&](const auto& disc) { compare(entry, name, disc, q); })) {
      name_unread(entry, section, report);
    } else {
      report.not_covered(section, fmt::format("contact type '{}'", printable(name)));
    }
  }
}

// x of the pole of the stop.
template <class P>
void compare_pole(TableObject& entry, std::string_view field, const AccuracyReport::Kind& kind, const P& disc,
                  const Exact& q, AccuracyReport& report) {
  const Exact x = entry[field].positive();
  const auto found = measure_entry(
      entry.node(), [&](Inputs inputs) { return std::array{dynamics::coast_down_pole(disc, as_double(q, inputs))}; });
  report.add(kind, deviation(found, 0, x, x), entry.node().place());
}

}  // namespace

void compare_coast_down_limit(const TableNode& node, AccuracyReport& report) {
  constexpr std::string_view section = "misc.coast_down_limit_x";
  compare_pucks(node, section, report,
                [&](TableObject& entry, const std::string& name, const auto& disc, const Exact& q) {
                  compare_pole(entry, "x", {std::string(section), name, "pole of the stop"}, disc, q, report);
                });
}

void compare_coast_down_stop(const TableNode& node, AccuracyReport& report) {
  constexpr std::string_view section = "misc.coast_down_stop";
  compare_pucks(node, section, report,
                [&](TableObject& entry, const std::string& name, const auto& disc, const Exact& q) {
                  const Exact x0 = entry["x0"].positive(), tau = entry["tau_stop"].positive();
                  const auto found = measure_entry(entry.node(), [&](Inputs inputs) {
                    return std::array{stop_time(disc, as_double(q, inputs), as_double(x0, inputs))};
                  });
                  report.add({std::string(section), name, "time of the stop"}, deviation(found, 0, tau, tau),
                             entry.node().place());
                  if (entry.find("x_limit"))
                    compare_pole(entry, "x_limit", {std::string(section), name, "pole of the stop"}, disc, q, report);
                });
}

}  // namespace patchgrip::cli
