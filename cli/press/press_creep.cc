#include <patchgrip/cli/press/press_creep.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/press/press_ellipse.h>
#include <patchgrip/cli/press/rounding.h>
#include <patchgrip/cli/scene/profile_of.h>
#include <patchgrip/contact/creep/contact_creep.h>
#include <patchgrip/contact/creep/cycles.h>
#include <patchgrip/contact/creep/growing_ellipse.h>
#include <patchgrip/contact/creep/press_under_force.h>
#include <patchgrip/contact/creep/seed_creep.h>
#include <patchgrip/contact/creep/spring_press.h>

namespace patchgrip::cli {
namespace {

using contact::ContactCreep;
using contact::ViscoelasticMaterial;

ContactCreep creep_of(const BodyPair& pair) {
  const auto relaxing = [](const Body& body) -> std::optional<ViscoelasticMaterial> {
    if (body.relaxing) return body.relaxing;
    if (std::isinf(body.material.youngs_modulus)) return std::nullopt;
    return ViscoelasticMaterial::elastic(body.material);
  };
  const auto first = relaxing(pair.first);
  const auto second = relaxing(pair.second);
  if (first && second) return ContactCreep::between(*first, *second);
  if (!first && !second) throw std::invalid_argument("two rigid bodies do not touch in an area");
  return ContactCreep::against_rigid(first ? *first : *second);
}

// One moment of a round contact.
struct Moment {
  Estimate radius, approach, force;
  std::optional<Estimate> central_pressure;  // nothing where it is infinite, or not defined
  bool stress_falls = true;                  // else the pressure may be negative somewhere (cycles.h)
};

template <class P>
class UnderForce {
 public:
  UnderForce(const P& profile, const ContactCreep& creep, const TimedLoad& load)
      : profile_(profile),
        creep_(creep),
        force_(load.history),
        times_(load.times_place),
        press_(contact::PressUnderForce<P>::of(profile, creep, load.history, last(load))) {}

  Moment at(double t) const {
    if (t > press_.valid_until()) return by_springs(t);
    const double a = press_.radius(t);
    Moment moment{{a, 64 * unit * a}, press_.approach(t), {force_(t), 16 * unit * force_(t)}, std::nullopt};
    if (creep_.compliance.instantaneous() > 0) moment.central_pressure = press_.pressure(0, t);
    return moment;
  }

  Estimate pressure(double r, double t) const { return press_.pressure(r, t); }

  // The surface outside is the elastic one while the contact grows: no spring there was ever pressed.
  Estimate displacement(double r, double t) const {
    if (t > press_.grows_until()) {
      throw std::invalid_argument(fmt::format(
          "after {} s the contact shrinks, and the surface outside under a given force is not covered; give the "
          "approach",
          press_.grows_until()));
    }
    const double a = press_.radius(t);
    const double u = a > 0 ? profile_.displacement(r, a) : 0;
    return {u, 128 * unit * (u + press_.approach(t).value)};
  }

  bool by_closed_form(double t) const { return t <= press_.valid_until(); }
  // Why not.
  std::string end_in_words() const {
    const double end = press_.valid_until();
    return fmt::format("at {:.6g} s the contact {}", end, force_(end) > 0 ? "grew again" : "was lost");
  }
  double grows_until() const { return press_.grows_until(); }

 private:
  static double last(const TimedLoad& load) { return load.times[load.times.size() - 1]; }

  // A contact that was lost or grows again: springs as wide as the largest contact that the load so far can make.
  Moment by_springs(double t) const {
    double largest = 0;
    for (const double s : look_times(t)) largest = std::max(largest, force_(s) * creep_.compliance(t));
    constexpr double margin = 1.05;
    const double widest =
        std::min(margin * static_cast<double>(profile_.radius_of_force(largest)), profile_.max_radius());
    constexpr int springs = 1000;
    const auto press = contact::press_springs(profile_, creep_, force_, t, widest, springs, steps_to(t));
    if (!press.springs.is_one_circle()) throw std::runtime_error("load: the contact is no longer one circle");
    return {press.radius, press.approach, {force_(t), 0}, std::nullopt};
  }

  // Starts of the pieces, and times between.
  std::vector<double> look_times(double t) const {
    constexpr int between = 256;
    std::vector<double> times;
    for (const auto& piece : force_.pieces()) {
      if (piece.start <= t) times.push_back(piece.start);
    }
    for (int i = 0; i <= between; ++i) times.push_back(force_.start() + (t - force_.start()) * i / between);
    return times;
  }

  // Of every piece: some for every swing of it and for the shortest time of relaxation.
  int steps_to(double t) const {
    constexpr double least = 500, most = 20000;
    constexpr double a_swing = 64, a_relaxation = 4;
    double steps = least;
    const auto& pieces = force_.pieces();
    for (std::size_t k = 0; k < pieces.size() && pieces[k].start < t; ++k) {
      const double duration = (k + 1 < pieces.size() ? std::min(t, pieces[k + 1].start) : t) - pieces[k].start;
      steps = std::max(steps, a_swing * duration * pieces[k].frequency / (2 * std::numbers::pi));
      const auto& modes = creep_.modulus.modes();
      if (pieces[k].amplitude != 0 && !modes.empty())
        steps = std::max(steps, a_relaxation * duration / modes.front().time);
    }
    if (steps > most) {
      times_.refuse(fmt::format("{} s is too many swings or relaxation times after the start", t));
    }
    return static_cast<int>(steps);
  }

  P profile_;
  ContactCreep creep_;
  contact::History force_;
  Place times_;
  contact::PressUnderForce<P> press_;
};

template <class P>
class AtApproach {
 public:
  AtApproach(const P& profile, const ContactCreep& creep, const TimedLoad& load)
      : profile_(profile), approach_(load.history), cycles_(contact::Cycles<P>::of(profile, creep, load.history)) {}

  Moment at(double t) const {
    const auto zone = cycles_.zone(t);
    if (!zone.is_one_circle) throw std::runtime_error(fmt::format("load: at {} s the contact is not one circle", t));
    Moment moment{{zone.radius, 64 * unit * zone.radius}, {approach_(t), 0}, zone.force, std::nullopt};
    if (zone.radius > 0) moment.central_pressure = cycles_.pressure(0, t);
    moment.stress_falls = zone.stress_falls;
    return moment;
  }

  Estimate pressure(double r, double t) const { return cycles_.pressure(r, t); }

 private:
  P profile_;
  contact::History approach_;
  contact::Cycles<P> cycles_;
};

// At the times of the load; where the scene asks for the surface, at the times of that and then the load's last one.
template <class Press>
std::vector<Moment> moments_of(const Press& press, const PressScene& scene, const TimedLoad& load) {
  std::vector<Moment> moments;
  const auto add = [&](double t) {
    InterruptGuard::check();
    moments.push_back(press.at(t));
  };
  if (const auto& times = scene.profile.times) {
    for (std::size_t i = 0; i < times->size(); ++i) at(*scene.profile.place, [&] { add((*times)[i]); });
    add(load.times[load.times.size() - 1]);
  } else {
    for (std::size_t i = 0; i < load.times.size(); ++i) add(load.times[i]);
  }
  return moments;
}

// Of the largest contact of these.
template <class P>
void warn_if_steep(Answer& answer, const PressScene& scene, const P& profile, const std::vector<Moment>& moments) {
  double largest = 0;
  for (const Moment& moment : moments) largest = std::max(largest, moment.radius.value);
  if (largest == 0) return;
  warn_if_steep(answer, Steepness::of_circle(std::get<BodyPair>(scene.subject), largest,
                                             static_cast<double>(profile.approach(largest))));
}

void push(std::vector<double>& row, const Estimate& e) {
  row.push_back(e.value);
  row.push_back(e.error);
}

constexpr Estimate none{not_known, not_known};

std::vector<Result> results_of(double t, const Moment& m) {
  std::vector<Result> results{{"time", t, 0, "s"},
                              {"contact_radius", m.radius.value, m.radius.error, "m"},
                              {"normal_force", m.force.value, m.force.error, "N"},
                              {"approach", m.approach.value, m.approach.error, "m"}};
  if (m.central_pressure && std::isfinite(m.central_pressure->value)) {
    results.push_back({"central_pressure", m.central_pressure->value, m.central_pressure->error, "Pa"});
  }
  return results;
}

std::vector<double> row_of(double t, const Moment& m) {
  std::vector<double> row{t};
  push(row, m.force);
  push(row, m.approach);
  push(row, m.radius);
  push(row, m.central_pressure.value_or(none));
  return row;
}

Table history_columns() {
  return {{"t_s", "normal_force_N", "normal_force_error_N", "approach_m", "approach_error_m", "contact_radius_m",
           "contact_radius_error_m", "central_pressure_Pa", "central_pressure_error_Pa"},
          {}};
}

// Pressure and, where the load is a force, displacement along a line at the times of the request.
template <class Press>
Table surface_over_time(const Press& press, const ProfileRequest& request, const std::vector<Moment>& moments) {
  constexpr bool knows_displacement = requires { press.displacement(0., 0.); };
  Table table{{"t_s", "x_m", "pressure_Pa", "pressure_error_Pa"}, {}};
  if (knows_displacement) table.columns.insert(table.columns.end(), {"displacement_m", "displacement_error_m"});
  at(*request.place, [&] {
    for (std::size_t k = 0; k < request.times->size(); ++k) {
      const double t = (*request.times)[k];
      const Sequence distance = request.distances(moments[k].radius.value);
      for (std::size_t i = 0; i < distance.size(); ++i) {
        InterruptGuard::check();
        const double r = distance[i];
        auto& row = table.rows.emplace_back(std::vector{t, r});
        push(row, press.pressure(r, t));
        if constexpr (knows_displacement) push(row, press.displacement(r, t));
      }
    }
  });
  return table;
}

void say_rate(const ContactCreep& creep, std::vector<std::string>& head) {
  const auto& modes = creep.compliance.modes();
  if (modes.size() == 1) head.push_back(fmt::format("the contact creeps with alpha = {:.17g} 1/s", 1 / modes[0].time));
}

template <class P>
PressedOverTime under_force(const P& profile, const ProfileName& name, const ContactCreep& creep, const TimedLoad& load,
                            const PressScene& scene) {
  const double start = load.history.start();
  if (load.times[0] < start || load.times[load.times.size() - 1] == start) {
    load.times_place.refuse(fmt::format("times from {} s on, where the force starts, and one after it", start));
  }
  const UnderForce<P> press(profile, creep, load);
  const std::vector<Moment> moments = moments_of(press, scene, load);
  PressedOverTime result;
  say_rate(creep, result.head);
  const double last = load.times[load.times.size() - 1];
  result.answer.main = {
      name.law, results_of(last, moments.back()),
      name.remark + (press.by_closed_form(last) ? "; Lee and Radok while the contact grows, Ting while it shrinks"
                                                : "; independent springs, as " + press.end_in_words())};
  if (press.grows_until() < last) {
    result.answer.main.results.push_back({"grows_until", press.grows_until(), 1e-12 * press.grows_until(), "s"});
  }
  const bool seed = creep.compliance.instantaneous() > 0;
  if (seed) {
    const Estimate e = contact::seed_creep_approach(profile, creep, load.history, last);
    result.answer.beside.push_back({"seed_creep",
                                    {{"approach", e.value, e.error, "m"}},
                                    "Keppler 4.28 and 4.72, linear in F^(2/3): not the solution"});
  }
  warn_if_steep(result.answer, scene, profile, moments);
  if (scene.profile.times) {
    result.table = surface_over_time(press, scene.profile, moments);
    return result;
  }
  result.table = history_columns();
  if (seed) result.table.columns.insert(result.table.columns.end(), {"seed_approach_m", "seed_approach_error_m"});
  for (std::size_t i = 0; i < load.times.size(); ++i) {
    InterruptGuard::check();
    auto row = row_of(load.times[i], moments[i]);
    if (seed) push(row, contact::seed_creep_approach(profile, creep, load.history, load.times[i]));
    result.table.rows.push_back(std::move(row));
  }
  return result;
}

template <class P>
PressedOverTime at_approach(const P& profile, const ProfileName& name, const ContactCreep& creep, const TimedLoad& load,
                            const PressScene& scene) {
  const AtApproach<P> press(profile, creep, load);
  PressedOverTime result;
  say_rate(creep, result.head);
  const double last = load.times[load.times.size() - 1];
  const std::vector<Moment> moments = moments_of(press, scene, load);
  const Moment& end = moments.back();
  if (!end.stress_falls) {
    result.answer.warnings.push_back(
        fmt::format("at {} s the stress of the springs does not fall outward: the pressure may be negative", last));
  }
  result.answer.main = {name.law, results_of(last, end),
                        name.remark + "; a foundation of independent springs in closed form, any number of cycles"};
  warn_if_steep(result.answer, scene, profile, moments);
  if (scene.profile.times) {
    result.table = surface_over_time(press, scene.profile, moments);
    return result;
  }
  result.table = history_columns();
  for (std::size_t i = 0; i < load.times.size(); ++i) {
    result.table.rows.push_back(row_of(load.times[i], moments[i]));
  }
  return result;
}

PressedOverTime growing_ellipse(const CurvedSurface& first, const CurvedSurface& second, const ContactCreep& creep,
                                const TimedLoad& load, const PressScene& scene) {
  if (load.kind != LoadKind::normal_force) {
    load.place.refuse("an ellipse over time is covered under a given force");
  }
  if (scene.profile.times) scene.profile.place->refuse("not covered for an ellipse over time");
  const auto radii = at(scene.subject_place, [&] { return relative_radii_of(first, second); });
  PressedOverTime result;
  say_rate(creep, result.head);
  result.table.columns = {"t_s", "normal_force_N", "approach_m", "semi_axis_a_m", "semi_axis_b_m"};
  for (std::size_t i = 0; i < load.times.size(); ++i) {
    const double t = load.times[i];
    const auto e = contact::GrowingEllipse::under_force(radii, creep, load.history, t);
    result.table.rows.push_back({t, load.history(t), e.approach, e.a, e.b});
    if (i + 1 < load.times.size()) continue;
    const double relative = 32 * unit;
    result.answer.main = {"hertz_ellipse",
                          {{"time", t, 0, "s"},
                           {"normal_force", load.history(t), 16 * unit * load.history(t), "N"},
                           {"semi_axis_a", e.a, relative * e.a, "m"},
                           {"semi_axis_b", e.b, relative * e.b, "m"},
                           {"approach", e.approach, relative * e.approach, "m"}},
                          "Lee and Radok: the shape of the ellipse does not creep while it grows"};
    warn_if_steep(result.answer,
                  Steepness::of_ellipse(first, second, radii, first.direction + radii.angle_a, e.a, e.b));
  }
  return result;
}

}  // namespace

PressedOverTime press_over_time(const PressScene& scene) {
  const auto& load = std::get<TimedLoad>(scene.load);
  const auto* pair = std::get_if<BodyPair>(&scene.subject);
  if (pair == nullptr) load.place.refuse("[load] takes two bodies");
  if (scene.adhesion) scene.adhesion->place.refuse("not covered together with [load]");
  return at(scene.subject_place, [&] {
    const ContactCreep creep = creep_of(*pair);
    const auto first = curved_surface(pair->first.shape);
    const auto second = curved_surface(pair->second.shape);
    if (first && second && !relative_radius_of(*pair)) {
      return at(load.place, [&] { return growing_ellipse(*first, *second, creep, load, scene); });
    }
    return visit_profile(*pair, [&](auto profile, const ProfileName& name) {
      return at(load.place, [&] {
        return load.kind == LoadKind::normal_force ? under_force(profile, name, creep, load, scene)
                                                   : at_approach(profile, name, creep, load, scene);
      });
    });
  });
}

}  // namespace patchgrip::cli
