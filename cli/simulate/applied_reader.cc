#include <patchgrip/cli/simulate/applied_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include <patchgrip/cli/scene/sequence_reader.h>
#include <patchgrip/cli/simulate/moving_body.h>

namespace patchgrip::cli {
namespace {

constexpr Quantity time_range = non_negative("a time in s");
constexpr Quantity component = any_sign("a component of a force in N");

std::array<double, 2> read_span(const TomlReader& load, std::string_view key) {
  constexpr std::string_view allowed = "two times [t1, t2] in s, the second later";
  const toml::array& times = load.array(load.node(key), key, allowed);
  if (times.size() != 2) load.refuse(key, allowed);
  const double from = load.number(times[0], fmt::format("{}[0]", key), time_range);
  const double to = load.number(times[1], fmt::format("{}[1]", key), time_range);
  if (!(to > from)) load.refuse(key, allowed);
  return {from, to};
}

}  // namespace

Course read_course(const TomlReader& load, const Factor& factor) {
  const auto has = [&](std::string_view key) { return load.has(key); };
  if (std::ranges::count_if(courses, has) > 1)
    load.refuse(*std::ranges::find_if(courses, has), "one of 'during', 'ramp', 'sine' and 'course'");
  if (has("during")) {
    const auto [from, to] = read_span(load, "during");
    return DuringCourse{from, to};
  }
  if (has("ramp")) {
    const auto [from, to] = read_span(load, "ramp");
    return RampCourse{from, to};
  }
  if (has("sine")) {
    const TomlReader sine = load.table("sine", {"angular_frequency", "phase", "mean"});
    SineCourse c{0, sine.number("angular_frequency", factor.angular_frequency), 0};
    if (sine.has("mean") || !factor.mean.admits(0)) c.mean = sine.number("mean", factor.mean);
    if (sine.has("phase")) c.phase = sine.number("phase", any_angle("a phase in rad"));
    return c;
  }
  if (has("course")) {
    constexpr std::string_view allowed = "points [[t, factor], ...] over time in s, t not falling";
    PointCourse c{read_pairs(load, "course", allowed, time_range, factor.value)};
    if (!std::ranges::is_sorted(c.points, {}, [](const auto& p) { return p[0]; })) load.refuse("course", allowed);
    return c;
  }
  return ConstantCourse{};
}

std::vector<Applied> read_applied(const TomlReader& scene, bool point, const Quantity& angular_frequency) {
  std::vector<Applied> loads;
  if (!scene.has("applied")) return loads;
  for (const TomlReader& load : scene.tables("applied", {"force", "moment", "during", "ramp", "sine", "course"})) {
    if (!load.has("force") && !load.has("moment")) load.refuse_table("needs 'force' or 'moment'");
    dynamics::Vector3 wrench = read_pair(load, "force", component, "a force [x, y] in N");
    if (point && wrench[1] != 0) load.refuse("force", "a point moves along x: the second component is 0");
    if (point && load.has("moment")) load.refuse("moment", "a point does not turn");
    if (load.has("moment")) wrench[2] = load.number("moment", any_sign("a moment in N m"));
    loads.push_back(
        {wrench, read_course(load, {any_sign("a factor of the load"), any_sign("a mean"), angular_frequency})});
  }
  return loads;
}

}  // namespace patchgrip::cli
