// Sections grasps and cases: optima of grasp analysis; forces and escape twists where they are unique.
//
// Errors are relative to the value, to the largest force, and to the size of the twist with spins times the distance of
// the farthest contact. A bracket wider than that of the answer's own claim is an error too: `bracket` is its width.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/grasp/grasp.h>
#include <patchgrip/grasp/growing_grip.h>
#include <patchgrip/grasp/held_ball.h>
#include <patchgrip/grasp/inertial_load.h>
#include <patchgrip/grasp/internal_forces.h>
#include <patchgrip/grasp/worst_load.h>

namespace patchgrip::cli {
namespace {

using grasp::Contact;
using grasp::FrictionCone;
using grasp::Grasp;
using grasp::GripAnswer;
using grasp::Vector3;
using grasp::Vector6;
using grasp::Verdict;

constexpr std::string_view section = "cases";

std::vector<Exact> all_numbers(const TableNode& list) { return list.numbers(list.items().size()); }

// Planar vectors leave out z.
Vector3 read_vector3(const TableNode& list, Inputs inputs) {
  const auto x = all_numbers(list);
  if (x.size() < 2 || x.size() > 3) list.fail("two or three numbers are expected");
  return {as_double(x[0], inputs), as_double(x[1], inputs), x.size() == 3 ? as_double(x[2], inputs) : 0};
}

// Planar loads are (fx, fy, mz).
Vector6 read_vector6(const TableNode& list, Inputs inputs) {
  const auto x = all_numbers(list);
  if (x.size() != 3 && x.size() != 6) list.fail("three or six numbers are expected");
  Vector6 w = Vector6::Zero();
  for (std::size_t i = 0; i < x.size(); ++i) {
    w[static_cast<Eigen::Index>(x.size() == 3 && i == 2 ? 5 : i)] = as_double(x[i], inputs);
  }
  return w;
}

// Of a model whose radius follows the load: a^3 / F.
std::optional<double> read_growth(TableObject& contact, Inputs inputs) {
  if (contact["model"].text() != "hertz_disc_load") return std::nullopt;
  return 3 * as_double(contact["R"].number(), inputs) / (4 * as_double(contact["E_star"].number(), inputs));
}

// Nothing where the library does not have the model.
std::optional<FrictionCone> read_cone(TableObject& contact, Inputs inputs) {
  using namespace friction;
  const std::string model = contact["model"].text();
  const auto value = [&](const char* name) { return as_double(contact[name].number(), inputs); };
  if (model == "frictionless") return FrictionCone::frictionless();
  if (model == "point") return FrictionCone::point(value("mu"));
  if (model == "soft_elliptic") return FrictionCone::soft_elliptic(value("mu"), value("e_m"));
  if (model == "soft_linear") return FrictionCone::soft_linear(value("mu"), value("e_m"));
  if (model == "hertz_disc") return FrictionCone::patch(value("mu"), HertzDisc::of_radius(value("a")));
  if (model == "uniform_disc") return FrictionCone::patch(value("mu"), UniformDisc::of_radius(value("a")));
  if (model == "flat_punch_disc") return FrictionCone::patch(value("mu"), FlatPunchDisc::of_radius(value("a")));
  if (model == "hertz_ellipse") {
    return FrictionCone::patch(value("mu"), HertzEllipse::of_semi_axes(value("a"), value("b")));
  }
  if (model == "uniform_rectangle") {
    return FrictionCone::patch(value("mu"), Rectangle::of_sides(value("l_u"), value("l_v")));
  }
  return std::nullopt;
}

grasp::ContactFrame read_contact_frame(TableObject& contact, Inputs inputs) {
  return {read_vector3(contact["position"], inputs), read_vector3(contact["normal_out"], inputs),
          read_vector3(contact["u"], inputs)};
}

// Empty where a model is not covered.
std::vector<Contact> read_contacts(const TableNode& list, Inputs inputs) {
  std::vector<Contact> contacts;
  for (const TableNode& node : list.filled()) {
    TableObject contact(node);
    const auto cone = read_cone(contact, inputs);
    if (!cone) return {};
    contacts.emplace_back(read_contact_frame(contact, inputs), *cone);
  }
  return contacts;
}

// The same where some grow with the load.
std::vector<grasp::GrowingContact> read_growing_contacts(const TableNode& list, Inputs inputs) {
  std::vector<grasp::GrowingContact> contacts;
  for (const TableNode& node : list.filled()) {
    TableObject contact(node);
    const grasp::ContactFrame frame = read_contact_frame(contact, inputs);
    if (const auto growth = read_growth(contact, inputs)) {
      const double mu = as_double(contact["mu"].number(), inputs);
      contacts.emplace_back([frame, mu, cube = *growth](double F) {
        return Contact(frame, FrictionCone::patch(mu, friction::HertzDisc::of_radius(std::cbrt(cube * F))));
      });
    } else if (const auto cone = read_cone(contact, inputs)) {
      contacts.emplace_back([fixed = Contact(frame, *cone)](double) { return fixed; });
    } else {
      return {};
    }
  }
  return contacts;
}

struct Case {
  std::string problem;
  TableObject fields;
  TableObject result;
  std::optional<TableNode> contacts;  // of its grasp
  bool planar = false;
};

void add(AccuracyReport& report, const Case& c, std::string_view quantity, const Deviation& error) {
  report.add({std::string(section), c.problem, std::string(quantity)}, error, c.fields.node().place());
}

Vector6 load_of(Case& c, const char* name, Inputs inputs) { return read_vector6(c.fields[name], inputs); }

const GripAnswer& answer(Case& c, Grasp& g, Inputs inputs) {
  if (c.problem == "min_quadratic") {
    return g.least_quadratic_grip(load_of(c, "load", inputs), as_double(c.fields["epsilon"].positive(), inputs),
                                  as_double(c.fields["length"].positive(), inputs));
  }
  if (c.problem == "min_max_normal") return g.least_grip(load_of(c, "load", inputs));
  if (c.problem == "min_sum_normal") return g.least_total_grip(load_of(c, "load", inputs));
  std::vector<double> limits;
  for (const Exact& x : all_numbers(c.fields["caps"])) limits.push_back(as_double(x, inputs));
  return g.load_factor(load_of(c, "load", inputs), load_of(c, "load_step", inputs), limits);
}

bool is_true(const TableNode& node) { return node.value().text == "true"; }

// Where it is unique, the force of each contact and the twist.
void compare_solution(Case& c, const GripAnswer& a, double reach, AccuracyReport& report) {
  const auto unique_node = c.result.find("unique");
  const auto forces = c.result.find("F_n");
  const auto frictions = c.result.find("t");
  const auto twist = c.result.find("escape_twist");
  if (!unique_node) return;
  TableObject unique(*unique_node);
  if (forces && is_true(unique["F"])) {
    const auto reference = forces->numbers(a.contacts.size());
    double largest = 0, error = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
      largest = std::max(largest, static_cast<double>(abs(reference[i])));
      error = std::max(error, static_cast<double>(abs(a.contacts[i].normal_force - reference[i])));
    }
    add(report, c, "unique normal forces", {error / largest, error / largest});
    if (frictions && is_true(unique["t"])) {
      error = 0;
      const auto rows = frictions->items(a.contacts.size());
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto t = all_numbers(rows[i]);
        for (std::size_t k = 0; k < t.size(); ++k) {
          const double own = a.contacts[i].friction[static_cast<Eigen::Index>(k)];
          error = std::max(error, static_cast<double>(abs(own - t[k])) / (k == 2 ? reach : 1));
        }
      }
      add(report, c, "unique friction", {error / largest, error / largest});
    }
  }
  if (twist && is_true(unique["twist"])) {
    Vector6 W = a.escape_twist, reference = read_vector6(*twist, Inputs::rounded);
    if (c.planar) W.segment<3>(2).setZero();
    W.tail<3>() *= reach;
    reference.tail<3>() *= reach;
    const double error = (W - reference).norm() / reference.norm();
    add(report, c, "unique escape twist", {error, error});
  }
}

// Distance of the farthest contact from the origin, to compare moments with forces.
double reach_of(const Grasp& g) {
  double reach = 0;
  for (const Contact& k : g.contacts()) reach = std::max(reach, k.position().norm());
  return reach > 0 ? reach : 1;
}

// A grip beyond the limit of the settings is not computed: what the library says of it is that it is beyond.
bool is_beyond_limit(Case& c, const Exact& reference, AccuracyReport& report) {
  if (c.problem != "min_max_normal" && c.problem != "min_sum_normal") return false;
  const Vector6 load = load_of(c, "load", Inputs::rounded);
  Grasp g(read_contacts(*c.contacts, Inputs::rounded));
  const double size = load.head<3>().norm() + load.tail<3>().norm() / reach_of(g);
  if (reference <= grasp::GripSettings{}.force_limit * size) return false;
  const GripAnswer& a = answer(c, g, Inputs::rounded);
  const bool right = a.lower <= reference && a.upper >= reference && a.verdict != Verdict::holds;
  add(report, c, "grip beyond the limit", right ? Deviation{} : failed);
  for (const std::string_view read : {"feasible", "closed_form", "unique", "F_n", "t", "escape_twist"}) {
    c.result.find(read);
  }
  return true;
}

void compare_optimum(Case& c, AccuracyReport& report) {
  const Exact reference = c.result["value"].number();
  if (is_beyond_limit(c, reference, report)) return;
  const Exact scale = reference == 0 ? Exact(1) : Exact(abs(reference));
  const auto q = measure([&](Inputs inputs) {
    Grasp g(read_contacts(*c.contacts, inputs));
    return std::array{answer(c, g, inputs).value};
  });
  add(report, c, "value", deviation(q, 0, reference, scale));
  Grasp g(read_contacts(*c.contacts, Inputs::rounded));
  const GripAnswer& a = answer(c, g, Inputs::rounded);
  const double width = (a.upper - a.lower) / static_cast<double>(scale);
  add(report, c, "width of the bracket", {width, width});
  const bool held = a.verdict == Verdict::holds;
  if (const auto feasible = c.result.find("feasible")) {
    add(report, c, "verdict", held == is_true(*feasible) ? Deviation{} : failed);
  }
  compare_solution(c, a, reach_of(g), report);
}

void compare_worst_case(Case& c, AccuracyReport& report) {
  const Exact reference = c.result["value"].positive();
  const auto loads = c.fields["loads"].filled();
  const auto each = c.result["values"].numbers(loads.size());
  const auto index = static_cast<std::size_t>(c.result["worst_index"].number());
  double error = 0;
  const auto contacts = read_contacts(*c.contacts, Inputs::rounded);
  Grasp g(contacts);
  grasp::LoadSet set;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    set.corners.push_back(read_vector6(loads[i], Inputs::rounded));
    const double value = g.least_grip(set.corners.back()).value;
    error = std::max(error, static_cast<double>(abs(value - each[i]) / each[i]));
  }
  const double worst = worst_grip(contacts, set, grasp::GripMeasure::largest_force).answer.value;
  const double worst_error = static_cast<double>(abs(worst - reference) / reference);
  add(report, c, "value", {worst_error, worst_error});
  add(report, c, "value of each load", {error, error});
  add(report, c, "worst load", index < each.size() && each[index] == reference ? Deviation{} : failed);
}

// The verdict that no limit on the forces lets it hold, and the distance of the load, relative to the load's force.
void compare_verdict(Case& c, AccuracyReport& report) {
  const Exact distance = c.result["distance"].number();
  const auto q = measure([&](Inputs inputs) {
    Grasp grasp(read_contacts(*c.contacts, inputs));
    const double length = as_double(c.fields["length"].positive(), inputs);
    return std::array{grasp.distance(load_of(c, "load", inputs), length).value};
  });
  // A distance of 0 that no finite forces reach is bracketed, not computed.
  const double load = load_of(c, "load", Inputs::rounded).head<3>().norm();
  if (distance > 0) add(report, c, "distance", deviation(q, 0, distance, load > 0 ? Exact(load) : distance));
  Grasp g(read_contacts(*c.contacts, Inputs::rounded));
  const Verdict verdict = g.least_grip(load_of(c, "load", Inputs::rounded)).verdict;
  const bool feasible = is_true(c.result["feasible"]);
  const bool weakly = c.result.find("weakly").has_value();  // nothing but a limit on the forces decides
  const bool right = feasible ? verdict == Verdict::holds : verdict == Verdict::cannot_hold || weakly;
  add(report, c, "verdict", right && !(weakly && verdict == Verdict::holds) ? Deviation{} : failed);
}

void compare_closure(Case& c, AccuracyReport& report) {
  Grasp g(read_contacts(*c.contacts, Inputs::rounded));
  const bool closed = g.force_closure().verdict == Verdict::holds;
  add(report, c, "verdict", closed == is_true(c.result["force_closure"]) ? Deviation{} : failed);
  c.result.find("escape_twist");
}

void compare_inertial_load(Case& c, AccuracyReport& report) {
  const auto reference = c.result["load"].numbers(6);
  const auto q = measure([&](Inputs inputs) {
    const auto vector = [&](const char* name) { return read_vector3(c.fields[name], inputs); };
    const auto J = c.fields["J_xx_yy_zz_xy_xz_yz"].numbers(6);
    const auto j = [&](std::size_t i) { return as_double(J[i], inputs); };
    grasp::CarriedBody body{as_double(c.fields["mass"].number(), inputs), vector("r_S"), {}};
    body.inertia << j(0), j(3), j(4), j(3), j(1), j(5), j(4), j(5), j(2);
    const Vector6 w = grasp::inertial_load(body, vector("gravity"),
                                           {vector("v"), vector("omega"), vector("v_dot"), vector("omega_dot")});
    return std::array{w[0], w[1], w[2], w[3], w[4], w[5]};
  });
  Exact force = 0, moment = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    force = std::max<Exact>(force, abs(reference[i]));
    moment = std::max<Exact>(moment, abs(reference[i + 3]));
  }
  const std::span all(reference);
  add(report, c, "force", deviation(q, 0, all.first(3), force));
  add(report, c, "moment", deviation(q, 3, all.last(3), moment == 0 ? Exact(1) : moment));
}

void compare_growing(Case& c, AccuracyReport& report) {
  const Vector6 load = load_of(c, "load", Inputs::rounded);
  const auto grip = least_growing_grip(read_growing_contacts(*c.contacts, Inputs::rounded), load);
  const auto error = [](double value, const Exact& reference) {
    const double e = static_cast<double>(abs(value - reference) / reference);
    return Deviation{e, e};
  };
  add(report, c, "verdict", (grip.verdict == Verdict::holds) == is_true(c.result["feasible"]) ? Deviation{} : failed);
  if (const auto value = c.result.find("value")) {
    add(report, c, "lower bound", error(grip.lower, value->positive()));
    add(report, c, "upper bound", error(grip.upper, value->positive()));
  } else {
    // A bracket of its own, to the digits that it is printed with: ours has to lie in it.
    const Exact lower = c.result["lower"].positive(), upper = c.result["upper"].positive();
    const double digits = 1e-9;
    const bool within = grip.lower >= lower * (1 - digits) && grip.upper <= upper * (1 + digits);
    add(report, c, "bracket", within && grip.lower <= grip.upper ? Deviation{} : failed);
  }
  for (const std::string_view read : {"radius", "pole_distance_over_a", "upper_F_n"}) c.result.find(read);
}

// The value is an upper bound that many starts agree on, and nobody knows a closer lower one: ours has to be below.
void compare_ball(Case& c, AccuracyReport& report) {
  const Exact reference = c.result["value"].positive();
  const auto measure_of =
      c.problem == "epsilon_l1" ? grasp::GripMeasure::total_force : grasp::GripMeasure::largest_force;
  constexpr int simplices = 2000;
  const auto q = measure([&](Inputs inputs) {
    const grasp::HeldBall ball =
        held_ball(read_contacts(*c.contacts, inputs), measure_of, as_double(c.fields["length"].positive(), inputs),
                  {.max_simplices = inputs == Inputs::rounded ? simplices : 0, .planar = c.planar});
    return std::array{ball.upper, ball.lower};
  });
  add(report, c, "upper bound", deviation(q, 0, reference, reference));
  const bool below = q.value[1] <= reference * (1 + 1e-12) && q.value[1] > 0;
  add(report, c, "lower bound", below ? Deviation{} : failed);
}

void compare_pseudo_inverse(Case& c, AccuracyReport& report) {
  const auto contacts = read_contacts(*c.contacts, Inputs::rounded);
  const auto reference = c.result["F_n"].numbers(contacts.size());
  const auto a = grasp::least_norm_forces(contacts, load_of(c, "load", Inputs::rounded));
  double largest = 0, error = 0;
  bool negative = false;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    largest = std::max(largest, static_cast<double>(abs(reference[i])));
    error = std::max(error, static_cast<double>(abs(a.normal_forces[i] - reference[i])));
    negative = negative || a.normal_forces[i] < 0;
  }
  add(report, c, "normal forces", {error / largest, error / largest});
  const double residual = static_cast<double>(abs(a.residual.norm() - c.result["residual"].number())) / largest;
  add(report, c, "residual", {residual, residual});
  const bool same = Exact(a.rank) == c.result["rank"].number() && negative == is_true(c.result["any_negative"]);
  add(report, c, "rank and sign", same ? Deviation{} : failed);
}

using Compare = void (*)(Case&, AccuracyReport&);

Compare comparison_of(const std::string& problem) {
  if (problem == "min_max_normal" || problem == "min_sum_normal" || problem == "load_factor" ||
      problem == "min_quadratic") {
    return compare_optimum;
  }
  if (problem == "min_max_normal_load_dependent") return compare_growing;
  if (problem == "epsilon_l1" || problem == "epsilon_linf") return compare_ball;
  if (problem == "pseudo_inverse") return compare_pseudo_inverse;
  if (problem == "worst_case_vertices") return compare_worst_case;
  if (problem == "force_closure") return compare_closure;
  if (problem == "inertial_load") return compare_inertial_load;
  if (problem == "feasible") return compare_verdict;
  return nullptr;
}

// The contacts of the grasp that a case names.
std::optional<TableNode> find_contacts(const TableNode& grasps, const TableNode& id, bool& planar) {
  if (id.value().kind == TableValue::Kind::null) return std::nullopt;
  for (const TableNode& node : grasps.filled()) {
    TableObject fields(node);
    if (fields["id"].text() != id.text()) continue;
    const auto space = fields.find("space");
    planar = space && space->text() == "planar";
    return fields["contacts"];
  }
  id.fail("no grasp has this id");
}

}  // namespace

void compare_grasps(const TableNode& grasps, const TableNode& cases, AccuracyReport& report) {
  for (const TableNode& node : cases.filled()) {
    TableObject fields(node);
    const std::string problem = fields["problem"].text();
    const Compare compare = comparison_of(problem);
    bool planar = false;
    const auto contacts = find_contacts(grasps, fields["grasp"], planar);
    const bool grows = compare == compare_growing;
    const bool known_contacts = !contacts || (grows ? !read_growing_contacts(*contacts, Inputs::rounded).empty()
                                                    : !read_contacts(*contacts, Inputs::rounded).empty());
    if (compare == nullptr || !known_contacts) {
      report.not_covered(section, fmt::format("'{}'", printable(problem)));
      continue;
    }
    Case c{problem, TableObject(node.named(fields["id"].text())), TableObject(fields["result"]), contacts, planar};
    compare(c, report);
    for (const std::string_view read : {"id", "grasp", "problem", "result", "route", "check", "length"}) {
      c.fields.find(read);
    }
    for (const std::string_view read : {"feasible", "closed_form", "unique", "F_n", "t", "escape_twist"}) {
      c.result.find(read);
    }
    name_unread(c.fields, section, report);
    name_unread(c.result, section, report);
  }
}

}  // namespace patchgrip::cli
