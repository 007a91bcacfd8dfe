// Section limit_curve: force f = F / (mu F_N) and moment m = M / (mu F_N a) of a round patch against x = r_M / a, and
// the force at a given moment.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include <patchgrip/cli/accuracy/sections.h>

namespace patchgrip::cli {
namespace {

constexpr std::string_view section = "limit_curve";

using friction::Twist;
using friction::Wrench;

struct CurvePoint {
  double f, m;
};

// At the pole x = V / W.
template <class P>
CurvePoint curve_point(const P& patch, double V, double W) {
  const double a = patch.area_radius();
  const Wrench g = patch.gradient({0, -V, W / a});
  return {std::hypot(g.fx, g.fy), g.m / a};
}

struct PoleAndForce {
  double x, f;
};

// Where the moment is `m`, in [0, moment at the centre]. It falls with x: up to the rim the unknown is x, beyond it 1 /
// x.
template <class P>
PoleAndForce at_moment(const P& patch, double m) {
  const CurvePoint centre = curve_point(patch, 0, 1);
  if (m >= centre.m) return {0, centre.f};
  const bool inside = m >= curve_point(patch, 1, 1).m;
  const auto point = [&](double t) { return inside ? curve_point(patch, t, 1) : curve_point(patch, 1, t); };
  std::uintmax_t steps = 200;
  const auto [lower, upper] = boost::math::tools::toms748_solve([&](double t) { return point(t).m - m; }, 0.0, 1.0,
                                                                boost::math::tools::eps_tolerance<double>(53), steps);
  const double t = lower + (upper - lower) / 2;
  return {inside ? t : 1 / t, point(t).f};
}

AccuracyReport::Kind kind(const TableContact& contact, std::string_view quantity) {
  return {std::string(section), contact.type(), std::string(quantity)};
}

void compare_point(const TableContact& contact, TableObject& row, AccuracyReport& report) {
  const auto x = row["r_M_over_a"].number_unless_infinite();
  if (x && *x < 0) row.node().fail("r_M_over_a: a distance that is not negative is expected");
  const auto q = measure([&](Inputs inputs) {
    return contact.visit(inputs, [&](const auto& patch) {
      const CurvePoint p = x ? curve_point(patch, as_double(*x, inputs), 1) : curve_point(patch, 1, 0);
      return std::array{p.f, p.m};
    });
  });
  const auto add = [&](std::string_view quantity, std::size_t which, const Exact& reference) {
    const auto add_relative_to = [&](const Exact& scale, std::string_view quantity_and_scale) {
      report.add(kind(contact, quantity_and_scale), deviation(q, which, reference, scale), row.node().place());
    };
    add_relative_to(1, quantity);
    if (reference > 0) add_relative_to(reference, std::string(quantity) + ", relative");
  };
  add("force", 0, row.symbol("f").number());
  add("moment", 1, row.symbol("m").number());
}

void compare_at_moment(const TableContact& contact, TableObject& row, AccuracyReport& report) {
  const TableNode ratio = row["m_over_m0"];
  const Exact share = ratio.number();
  if (share < 0 || share > 1) ratio.fail("a number in [0, 1] is expected");
  const auto q = measure([&](Inputs inputs) {
    return contact.visit(inputs, [&](const auto& patch) {
      const double m = as_double(share, inputs) * curve_point(patch, 0, 1).m;
      const PoleAndForce p = at_moment(patch, m);
      return std::array{m, p.f, p.x};
    });
  });
  const auto add = [&](std::string_view quantity, std::size_t which, const Exact& reference, const Exact& scale) {
    report.add(kind(contact, quantity), deviation(q, which, reference, scale), row.node().place());
  };
  add("moment at m / m0", 0, row.symbol("m").number(), 1);
  add("force at m / m0", 1, row.symbol("f").number(), 1);
  const auto x = row["r_M_over_a"].number_unless_infinite();
  if (x) {
    add("pole at m / m0", 2, *x, std::max<Exact>(1, abs(*x)));
  } else {
    report.add(kind(contact, "pole at m / m0"), std::isinf(q.value[2]) ? Deviation{} : failed, row.node().place());
  }
}

// A round contact at the origin; where only a name is given, that type of disc with unit radius.
std::optional<TableContact> read_curve_contact(TableObject& entry, AccuracyReport& report) {
  std::optional<TableContact> contact;
  if (const auto node = entry.find("contact")) {
    contact = TableContact::read(*node, section, report);
  } else {
    TableValue disc{TableValue::Kind::object,
                    {},
                    {},
                    {{"type", entry["name"].value()}, {"radius_m", {TableValue::Kind::number, "1", {}, {}}}}};
    for (const char* parameter : {"n", "alpha"}) {
      if (const auto given = entry.find(parameter)) disc.members.push_back({parameter, given->value()});
    }
    contact = TableContact::read(entry.node().with(disc), section, report);
  }
  if (!contact) return std::nullopt;
  const auto moments = contact->visit(Inputs::rounded, [](const auto& patch) { return patch.moments(); });
  if (contact->is_round() && moments.x == 0 && moments.y == 0) return contact;
  report.not_covered(section, fmt::format("a contact '{}' that is not round about the origin", contact->type()));
  return std::nullopt;
}

}  // namespace

void compare_limit_curve(const TableNode& node, AccuracyReport& report) {
  for (const TableNode& entry_node : node.filled()) {
    TableObject entry(named_entry(entry_node));
    const auto contact = read_curve_contact(entry, report);
    if (!contact) continue;
    for (const TableNode& row_node : entry["points"].filled()) {
      TableObject row(row_node);
      compare_point(*contact, row, report);
      name_unread(row, section, report);
    }
    if (const auto rows = entry.find("f_at_m")) {
      for (const TableNode& row_node : rows->items()) {
        TableObject row(row_node);
        compare_at_moment(*contact, row, report);
        name_unread(row, section, report);
      }
    }
    name_unread(entry, section, report);
  }
}

}  // namespace patchgrip::cli
