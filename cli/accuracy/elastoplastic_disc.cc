// misc.disc_example_fig_4_30: a Hertz disc on elastoplastic bristles under a steady force, and a moment for some time.
//
// Places (x, y, a phi) are relative to the farthest of the table, speeds (v_x, v_y, a w) to the fastest, deflections to
// mu_s F_N / k, and turns of the bristles to a mu_s F_N / k_r. The entry states how far two integrators agreed in the
// states; the time of the stop is then known as well as that over the rate at which the speed falls there.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/dynamics/bristle_motion.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>

namespace patchgrip::cli {
namespace {

using dynamics::Vector3;
using friction::HertzDisc;
using Surface = friction::RoundLimitSurface<HertzDisc>;
using Motion = dynamics::BristleMotion<dynamics::PatchBristle<Surface>>;

constexpr std::string_view section = "misc.disc_example_fig_4_30";

double rounded(const TableNode& node) { return as_double(node.number(), Inputs::rounded); }
double rounded_positive(const TableNode& node) { return as_double(node.positive(), Inputs::rounded); }

Vector3 vector(const TableNode& node) {
  const auto x = node.numbers(3);
  return {static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2])};
}

struct Disc {
  static Disc of(TableObject& fields) {
    TableObject p(fields["parameters"]);
    const double a = rounded_positive(p["aK"]), limit = rounded_positive(fields["mu_H_F_N"]);
    const Vector3 K = vector(p["K"]);
    const dynamics::PatchBristle<Surface> bristle(
        Surface(HertzDisc::of_radius(a)), {K, vector(p["D"]), a},
        friction::Law::stribeck(limit, rounded(fields["mu_Gl_F_N"]), rounded_positive(p["vS"])), 1);
    return {Motion(bristle, rounded_positive(p["m"]), rounded_positive(p["J"])),
            a,
            limit,
            rounded(fields["F_x_N"]),
            rounded(p["Mz"]),
            rounded(p["t1"]),
            rounded(p["t2"])};
  }

  Motion::State initial() const {
    Motion::State y{};
    y[6] = force / motion.bristle().parameters().stiffness[0];
    return y;
  }
  double speed(const Motion::State& y) const { return std::sqrt(y[3] * y[3] + y[4] * y[4] + a * a * y[5] * y[5]); }

  Motion motion;
  double a, limit;  // a_K, mu_s F_N
  double force, moment, on, off;
};

struct Mark {
  double time;
  TableNode node;
  std::vector<Exact> state;
};

std::vector<Mark> marks_of(const TableNode& states) {
  if (!states.is_object()) states.fail("an object of states by their times is expected");
  std::vector<Mark> marks;
  for (const auto& [name, value] : states.value().members) {
    const TableNode node = states.member(name, value);
    const auto t = parse_exact(name);
    if (!t || *t < 0) node.fail("its name must tell a time");
    marks.push_back({static_cast<double>(*t), node, node.numbers(9)});
  }
  std::ranges::sort(marks, {}, &Mark::time);
  return marks;
}

double stated_accuracy(TableObject& fields) {
  double stated = 0;
  if (const auto tolerance = fields.find("tolerance")) stated = rounded_positive(*tolerance);
  if (const auto agreement = fields.find("solver_agreement")) {
    if (!agreement->is_object()) agreement->fail("an object of errors by their times is expected");
    for (const auto& [name, value] : agreement->value().members)
      stated = std::max(stated, rounded(agreement->member(name, value)));
  }
  return stated;
}

// last_time_speed_...>1e-3: the last time at which the speed passes that.
struct Stop {
  TableNode time;
  double speed;
};

std::optional<Stop> find_stop(TableObject& fields) {
  for (const auto& member : fields.node().value().members) {
    const std::size_t above = member.name.find('>');
    if (!member.name.starts_with("last_time_speed") || above == std::string::npos) continue;
    const auto speed = parse_exact(std::string_view(member.name).substr(above + 1));
    const TableNode node = *fields.find(member.name);
    if (!speed || !(*speed > 0)) node.fail("its name must end with a speed in m/s");
    return Stop{node, static_cast<double>(*speed)};
  }
  return std::nullopt;
}

double distance(const Motion::State& y, const std::vector<Exact>& state, std::size_t first, double a) {
  Exact sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Exact d = (y[first + i] - state[first + i]) * (i == 2 ? a : 1);
    sum += d * d;
  }
  return static_cast<double>(sqrt(sum));
}

double largest(const std::vector<Mark>& marks, std::size_t first, double a) {
  double size = 0;
  for (const Mark& m : marks) size = std::max(size, distance({}, m.state, first, a));
  return size > 0 ? size : 1;
}

void compare_state(const Disc& disc, const Mark& mark, const Motion::State& y, double way, double pace, double stated,
                   AccuracyReport& report) {
  const auto add = [&](const char* quantity, double error, double scale) {
    report.add({std::string(section), "hertz_disc", quantity}, {error / scale, error / scale}, mark.node.place(),
               stated / scale);
  };
  add("place", distance(y, mark.state, 0, disc.a), way);
  add("speed", distance(y, mark.state, 3, disc.a), pace);
  const Vector3& K = disc.motion.bristle().parameters().stiffness;
  const auto off = [&](std::size_t i) { return static_cast<double>(abs(y[i] - mark.state[i])); };
  add("deflection", std::hypot(off(6), off(7)), disc.limit / K[0]);
  add("deflection, turn", off(8), disc.a * disc.limit / K[2]);
}

void compare_motion(const Disc& disc, TableObject& fields, AccuracyReport& report) {
  const auto marks = marks_of(fields["states_x_y_phi_vx_vy_w_k1_k2_k3"]);
  if (marks.empty()) fields.node().fail("states are expected");
  const auto stop = find_stop(fields);
  const double stated = stated_accuracy(fields), end = marks.back().time;
  const double way = largest(marks, 0, disc.a), pace = largest(marks, 3, disc.a);
  double stopped = std::nan(""), braking = 0;
  auto mark = marks.begin();
  Motion::State y = disc.initial();
  double t = 0;
  for (const auto& [until, moment] :
       {std::pair{std::min(disc.on, end), 0.}, {std::min(disc.off, end), disc.moment}, {end, 0.}}) {
    const Vector3 load(disc.force, 0, moment);
    Motion::Flow flow([&](double, const Motion::State& s, Motion::State& dy) { dy = disc.motion(load, s); }, y, t,
                      {.tolerance = 1e-12});
    if (stop) flow.watch([&](double, const Motion::State& s) { return disc.speed(s) - stop->speed; });
    const auto note = [&](double at, const Motion::State& s, std::size_t) {
      const Motion::State rate = disc.motion(load, s);
      stopped = at;
      braking = std::fabs(s[3] * rate[3] + s[4] * rate[4] + disc.a * disc.a * s[5] * rate[5]) / disc.speed(s);
      return false;
    };
    for (; mark != marks.end() && mark->time <= until; ++mark) {
      flow.run(mark->time, note);
      compare_state(disc, *mark, flow.state(), way, pace, stated, report);
    }
    flow.run(until, note);
    y = flow.state();
    t = until;
  }
  if (!stop) return;
  const Exact time = stop->time.positive();
  const double error = static_cast<double>(abs(stopped - time) / time);
  report.add({std::string(section), "hertz_disc", "time of the stop"}, {error, error}, stop->time.place(),
             stated / braking / static_cast<double>(time));
}

}  // namespace

void compare_elastoplastic_disc(const TableNode& node, AccuracyReport& report) {
  TableObject fields(node);
  try {
    compare_motion(Disc::of(fields), fields, report);
  } catch (const TableError&) {
    throw;
  } catch (const std::exception& error) {
    node.fail(error.what());
  }
  fields.find("initial");  // in words
  TableObject parameters(fields["parameters"]);
  for (const std::string_view read : {"aK", "m", "J", "K", "D", "vS", "Mz", "t1", "t2"}) parameters.find(read);
  name_unread(parameters, section, report);
  name_unread(fields, section, report);
}

}  // namespace patchgrip::cli
