// Motions of a point: belt_stick_slip, karnopp, elastoplastic_scalar and misc.example_4_7_simulation.
//
// Times are relative to themselves (of the belt to its period), places to the largest of their motion, velocities to
// the first one, deflections to mu_s F_N / c_0, energies to themselves.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/dynamics/point_bristle.h>
#include <patchgrip/dynamics/point_motion.h>
#include <patchgrip/dynamics/trajectory.h>

namespace patchgrip::cli {
namespace {

using dynamics::Law;
using dynamics::PointEvent;
using dynamics::Trajectory;

constexpr double to_rounding = 1e-15;  // of a step

struct Parameters {
  TableObject fields;

  Exact exact(std::string_view name) { return fields[name].number(); }
  double operator()(std::string_view name, Inputs inputs) { return as_double(exact(name), inputs); }
};

// Belt.

constexpr std::array<std::string_view, 10> belt_fields{
    "period_s", "stick_s",        "slip_s",          "amplitude_m",      "x_max_m",
    "x_min_m",  "x_slip_start_m", "x_stick_start_m", "loss_per_cycle_J", "belt_work_per_cycle_J"};

// The cycle from the first break-away to the second, in units of m, F_s and sqrt(m / k).
std::array<double, 10> belt_cycle(Parameters& p, Inputs inputs) {
  const double m = p("m", inputs), k = p("k", inputs), Fs = p("Fs", inputs), drop = p("Fk", inputs) / Fs;
  const double second = std::sqrt(m / k), metre = Fs / k, joule = Fs * metre;
  const double v0 = p("v0", inputs) * second / metre;
  const dynamics::PointMotion motion({1, 1, 0, v0}, Law::coulomb(drop), 1);
  const double end = (1 + 4 * (1 - drop)) / std::fabs(v0) + 4 * std::numbers::pi;
  const auto events =
      motion({[](double) { return 0.; }, [](double) { return 1.; }}, {0, v0}, 0, end, {to_rounding, 0.1}).events;
  std::vector<PointEvent> kept;
  std::vector<double> extremes;
  for (const PointEvent& e : events) {
    if (e.kind != PointEvent::Kind::extreme) {
      kept.push_back(e);
    } else if (kept.size() == 1) {
      extremes.push_back(metre * e.state.x);
    }
  }
  if (kept.size() < 3 || kept[1].kind != PointEvent::Kind::stop || extremes.size() != 2)
    throw std::runtime_error("it does not stick and slip");
  const PointEvent &leaves = kept[0], &stops = kept[1], &again = kept[2];
  const auto [lowest, highest] = std::minmax(extremes[0], extremes[1]);
  return {second * (again.time - leaves.time),
          second * (again.time - stops.time),
          second * (stops.time - leaves.time),
          (highest - lowest) / 2,
          highest,
          lowest,
          metre * leaves.state.x,
          metre * stops.state.x,
          joule * (again.state.friction_loss - leaves.state.friction_loss),
          joule * (again.state.support_work - leaves.state.support_work)};
}

// Karnopp: to the dead band, and on in it.

struct KarnoppRun {
  double time, x;    // at the dead band
  double v, x_last;  // later
};

KarnoppRun karnopp(Parameters& p, double later, Inputs inputs) {
  using Flow = Trajectory<2>;
  const Law law = Law::stribeck(p("muH", inputs), p("muG", inputs), 1);
  const double m = p("m", inputs), F = p("FN", inputs), dv = p("dv", inputs), load = p("FT", inputs);
  const auto rates = [&](double, const Flow::State& y, Flow::State& dy) {
    dy = {y[1], (load + dynamics::karnopp_force(law, F, dv, load, y[1])) / m};
  };
  Flow slide(rates, {0, p("v0", inputs)}, 0, {.tolerance = to_rounding});
  slide.watch([&](double, const Flow::State& y) { return y[1] - dv; });
  if (!slide.run(later, [](double, const Flow::State&, std::size_t) { return true; }))
    throw std::runtime_error("it does not reach the dead band");
  Flow drift(rates, slide.state(), slide.time(), {.tolerance = to_rounding});
  drift.run(later);
  return {slide.time(), slide.state()[0], drift.state()[1], drift.state()[0]};
}

// Elastoplastic.

struct Block {
  using Flow = Trajectory<3>;  // x, v, kappa

  static Block of(Parameters& p, Inputs inputs) {
    Block b{Law::stribeck(p("muH", inputs), p("muG", inputs), p("vS", inputs)),
            {p("c0", inputs), p("c1", inputs), 0, p("k1f", inputs)},
            p("m", inputs),
            p("FN", inputs)};
    b.bristle.check();
    return b;
  }

  void operator()(double, const Flow::State& y, Flow::State& dy) const {
    const double rate = elastoplastic_rate(bristle, law, normal_force, y[2], y[1]);
    dy = {y[1], bristle_force(bristle, law, normal_force, y[2], rate, y[1]) / mass, rate};
  }

  Law law;
  dynamics::PointBristle bristle;
  double mass, normal_force;
};

Block::Flow start(Parameters& p, Inputs inputs) {
  return Block::Flow(Block::of(p, inputs), {0, p("v0", inputs), 0}, 0, {.tolerance = to_rounding});
}

// "0.05", and of state_xvk_at_1s or _at_T what comes behind.
Exact time_of(std::string_view name, const TableNode& node, Parameters& p) {
  if (name == "T") return p.exact("T");
  if (name.ends_with('s')) name.remove_suffix(1);
  const auto t = parse_exact(name);
  if (!t || !(*t > 0)) node.fail("its name must tell a time");
  return *t;
}

struct Mark {
  Exact time;
  TableNode state;
};

std::vector<Mark> marks_of(TableObject& fields, Parameters& p) {
  constexpr std::string_view one = "state_xvk_at_";
  std::vector<Mark> marks;
  for (const auto& [name, value] : fields.node().value().members) {
    if (name.starts_with(one)) marks.push_back({time_of(name.substr(one.size()), fields[name], p), fields[name]});
    if (name != "states_x_v_kappa") continue;
    const TableNode all = fields[name];
    if (!all.is_object()) all.fail("an object of states by their times is expected");
    for (const auto& [time, state] : value.members) {
      const TableNode node = all.member(time, state);
      marks.push_back({time_of(time, node, p), node});
    }
  }
  return marks;
}

}  // namespace

void compare_belt(const TableNode& node, AccuracyReport& report) {
  constexpr std::string_view section = "belt_stick_slip";
  TableObject fields(node);
  for (const TableNode& entry_node : fields["cases"].filled()) {
    TableObject entry(entry_node);
    Parameters p{TableObject(entry["parameters"])};
    for (const std::string_view name : {"m", "k", "Fs", "Fk"}) p.fields[name].positive();
    if (p.exact("v0") == 0) p.fields["v0"].fail("a velocity other than 0 is expected");
    const auto q = measure_entry(entry["parameters"], [&](Inputs inputs) { return belt_cycle(p, inputs); });
    const Exact largest = std::max<Exact>(abs(entry["x_max_m"].number()), abs(entry["x_min_m"].number()));
    const Exact period = entry["period_s"].positive();
    for (std::size_t i = 0; i < belt_fields.size(); ++i) {
      const Exact reference = entry[belt_fields[i]].number();
      const bool is_time = belt_fields[i].ends_with("_s"), is_place = belt_fields[i].starts_with('x');
      const Exact scale = is_time ? period : is_place ? largest : Exact(abs(reference));
      report.add({std::string(section), "point", std::string(belt_fields[i])},
                 deviation(q, i, reference, scale == 0 ? Exact(1) : scale), entry_node.place());
    }
    name_unread(p.fields, section, report);
    name_unread(entry, section, report);
  }
  name_unread(fields, section, report);
}

void compare_karnopp(const TableNode& node, AccuracyReport& report) {
  constexpr std::string_view section = "karnopp", last = "x_at_";
  TableObject fields(node);
  Parameters p{TableObject(fields["parameters"])};
  for (const std::string_view name : {"m", "FN", "dv", "v0"}) p.fields[name].positive();
  std::vector<Mark> marks;
  for (const auto& [name, value] : node.value().members) {
    if (!name.starts_with(last) || !name.ends_with("_s")) continue;
    const std::string_view time = std::string_view(name).substr(last.size(), name.size() - last.size() - 2);
    marks.push_back({time_of(time, fields[name], p), fields[name]});
  }
  if (marks.empty()) node.fail("the field 'x_at_10_s', or of another time, is missing");
  for (const Mark& mark : marks) {
    const auto q = measure_entry(fields["parameters"], [&](Inputs inputs) {
      const KarnoppRun r = karnopp(p, as_double(mark.time, inputs), inputs);
      return std::array{r.time, r.x, r.v, r.x_last};
    });
    const Exact way = abs(mark.state.number());
    const auto add = [&](std::string_view quantity, std::size_t i, const Exact& reference, const Exact& scale) {
      report.add({std::string(section), "point", std::string(quantity)}, deviation(q, i, reference, scale),
                 node.place());
    };
    const Exact time = fields["time_at_dead_band_s"].positive();
    add("time_at_dead_band_s", 0, time, time);
    add("x_at_dead_band_m", 1, fields["x_at_dead_band_m"].number(), way);
    add("drift_speed_after_m_per_s", 2, fields["drift_speed_after_m_per_s"].number(), p.exact("v0"));
    add("x later", 3, mark.state.number(), way);
  }
  name_unread(p.fields, section, report);
  name_unread(fields, section, report);
}

void compare_elastoplastic_point(const TableNode& node, AccuracyReport& report) {
  const std::string& section = node.place();
  TableObject fields(node);
  Parameters p{TableObject(fields["parameters"])};
  for (const std::string_view name : {"c0", "m", "FN", "muH", "vS", "v0", "T"}) p.fields[name].positive();
  p.fields.find("marks");  // those of the states
  const Exact way = fields["x_at_first_v_zero_m"].positive(), time = fields["first_v_zero_s"].positive();
  const auto stated_node = fields.find("tolerance");
  const Exact stated = stated_node ? stated_node->positive() : Exact(0);
  const auto add = [&](std::string_view quantity, const auto& q, std::size_t i, const Exact& reference,
                       const Exact& scale, const TableNode& at) {
    report.add({section, "point", std::string(quantity)}, deviation(q, i, reference, scale), at.place(),
               static_cast<double>(stated / scale));
  };
  const auto stop = measure_entry(fields["parameters"], [&](Inputs inputs) {
    Block::Flow motion = start(p, inputs);
    motion.watch([](double, const Block::Flow::State& y) { return y[1]; });
    if (!motion.run(p("T", inputs), [](double, const Block::Flow::State&, std::size_t) { return true; }))
      throw std::runtime_error("it does not stop");
    return std::array{motion.time(), motion.state()[0]};
  });
  add("time of the first stop", stop, 0, time, time, node);
  add("x at the first stop", stop, 1, way, way, node);
  const std::array<Exact, 3> scales{way, p.exact("v0"), p.exact("muH") * p.exact("FN") / p.exact("c0")};
  for (const Mark& mark : marks_of(fields, p)) {
    const auto state = mark.state.numbers(3);
    const auto q = measure_entry(mark.state, [&](Inputs inputs) {
      Block::Flow motion = start(p, inputs);
      motion.run(as_double(mark.time, inputs));
      return motion.state();
    });
    constexpr std::array<std::string_view, 3> names{"x", "v", "kappa"};
    for (std::size_t i = 0; i < 3; ++i) add(names[i], q, i, state[i], scales[i], mark.state);
  }
  name_unread(p.fields, section, report);
  name_unread(fields, section, report);
}

}  // namespace patchgrip::cli
