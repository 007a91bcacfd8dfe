// Sections viscous (4.49) and local_stribeck: wrenches of the laws of friction on a patch, Stribeck's in the mean
// (4.48) and at each point.
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>

#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/law.h>
#include <patchgrip/friction/local_stribeck.h>

namespace patchgrip::cli {
namespace {

using friction::Law;
using friction::PressureMoments;

// A law and a normal force of the table, with their numbers rounded or moved.
struct TableLaw {
  std::function<Law(Inputs)> law;
  Exact normal_force;

  void check(const TableNode& owner) const {
    try {
      law(Inputs::rounded);
    } catch (const std::invalid_argument& error) {
      owner.fail(error.what());
    }
  }
};

struct WrenchScale {
  double force, moment;
};

PressureMoments moments_of(const TableContact& contact, Inputs inputs = Inputs::rounded) {
  return contact.visit(inputs, [](const auto& patch) { return patch.moments(); });
}

double second_moment(const PressureMoments& s) { return s.x * s.x + s.y * s.y + s.polar; }

// `wrench(patch, law, F_N, v)` gives a BoundedWrench.
template <class Friction>
void compare_wrench(const AccuracyReport::Kind& kind, const TableContact& contact, const TableLaw& law,
                    const ExactTwist& v, std::span<const Exact> reference, const WrenchScale& scale,
                    std::string_view place, AccuracyReport& report, const Friction& wrench) {
  const auto q = measure([&](Inputs inputs) {
    return contact.visit(inputs, [&](const auto& patch) {
      const auto t = wrench(patch, law.law(inputs), as_double(law.normal_force, inputs), v.twist(inputs)).value;
      return std::array{t.fx, t.fy, t.m};
    });
  });
  const auto add = [&](std::string_view quantity, std::size_t first, std::size_t count, double size) {
    report.add({kind.section, kind.contact, kind.quantity + std::string(quantity)},
               deviation(q, first, reference.subspan(first, count), size > 0 ? size : 1), place);
  };
  add("force", 0, 2, scale.force);
  add("moment", 2, 1, scale.moment);
}

constexpr auto in_the_mean = [](const auto& patch, const Law& law, double normal_force, const friction::Twist& v) {
  return friction_wrench(law, normal_force, patch, v);
};

bool has_local_law(const TableContact& contact) {
  return contact.visit(Inputs::rounded,
                       [](const auto& patch) { return friction::LocalPatch<std::decay_t<decltype(patch)>>; });
}

// Only where has_local_law().
constexpr auto at_each_point = [](const auto& patch, const Law& law, double normal_force, const friction::Twist& v) {
  if constexpr (friction::LocalPatch<std::decay_t<decltype(patch)>>) {
    return local_friction_wrench(law, normal_force, patch, v);
  } else {
    return friction::BoundedWrench{};
  }
};

// Centroid s_0 and second moment s_1 about the origin, relative to the radius of gyration and to s_1.
void compare_moments(const TableContact& contact, TableObject& fields, AccuracyReport& report) {
  const auto s0 = fields.length("s0");
  const Exact s1 = fields["s1_m2"].positive();
  const auto xy = s0.node.numbers(2);
  const std::array<Exact, 3> reference{xy[0] * s0.factor, xy[1] * s0.factor, s1};
  const auto q = measure([&](Inputs inputs) {
    const PressureMoments s = moments_of(contact, inputs);
    return std::array{s.x, s.y, second_moment(s)};
  });
  const auto add = [&](const char* quantity, std::size_t first, std::size_t count, const Exact& scale) {
    report.add({"viscous", contact.type(), quantity},
               deviation(q, first, std::span(reference).subspan(first, count), scale), fields.node().place());
  };
  add("centroid", 0, 2, sqrt(s1));
  add("second moment", 2, 1, s1);
}

}  // namespace

void compare_viscous(const TableNode& node, AccuracyReport& report) {
  constexpr std::string_view section = "viscous";
  TableObject fields(node);
  const auto contact = TableContact::read(fields["contact"], section, report);
  if (!contact) return;
  compare_moments(*contact, fields, report);
  const Exact mu = fields["mu_V_s_per_m"].positive();
  const TableLaw law{[=](Inputs inputs) { return Law::viscous(as_double(mu, inputs)); }, fields["F_N"].positive()};
  law.check(fields["mu_V_s_per_m"]);
  const PressureMoments moments = moments_of(*contact);
  for (const TableNode& row_node : fields["rows"].filled()) {
    TableObject row(row_node);
    const ExactTwist v = ExactTwist::read(row["twist"]);
    const std::array<Exact, 3> reference{row["t1_N"].number(), row["t2_N"].number(), row["t3_Nm"].number()};
    const double force =
        static_cast<double>(mu * law.normal_force) * std::sqrt(mean_square_speed(moments, v.twist(Inputs::rounded)));
    compare_wrench({std::string(section), contact->type(), ""}, *contact, law, v, reference,
                   {force, force * std::sqrt(second_moment(moments))}, row_node.place(), report, in_the_mean);
    name_unread(row, section, report);
  }
  name_unread(fields, section, report);
}

void compare_local_stribeck(const TableNode& node, AccuracyReport& report) {
  constexpr std::string_view section = "local_stribeck";
  TableObject fields(node);
  const Exact mu_static = fields["mu_H"].number();
  const Exact mu_kinetic = fields["mu_Gl"].number();
  const Exact velocity = fields["v_S"].number();
  const TableLaw law{[=](Inputs inputs) {
                       return Law::stribeck(as_double(mu_static, inputs), as_double(mu_kinetic, inputs),
                                            as_double(velocity, inputs));
                     },
                     fields["F_N"].positive()};
  law.check(node);
  for (const TableNode& row_node : fields["rows"].filled()) {
    TableObject row(row_node);
    const auto contact = TableContact::read(row["contact"], section, report);
    if (!contact) continue;
    const ExactTwist v = ExactTwist::read(row["twist"]);
    const double mu = coefficient(law.law(Inputs::rounded), moments_of(*contact), v.twist(Inputs::rounded));
    const double force = mu * as_double(law.normal_force, Inputs::rounded);
    const double a_K = contact->visit(Inputs::rounded, [](const auto& patch) { return patch.area_radius(); });
    const auto compare = [&](const char* field, const char* name, const auto& wrench) {
      const auto reference = row[field].numbers(3);
      compare_wrench({std::string(section), contact->type(), name}, *contact, law, v, reference, {force, force * a_K},
                     row_node.place(), report, wrench);
    };
    compare("mean_4_48", "mean ", in_the_mean);
    if (has_local_law(*contact) && row.find("local")) compare("local", "local ", at_each_point);
    name_unread(row, section, report);
  }
  name_unread(fields, section, report);
}

}  // namespace patchgrip::cli
