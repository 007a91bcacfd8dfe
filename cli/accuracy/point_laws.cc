// Section point_laws: the laws of a point (seed 4.31 to 4.38, corrected) at given velocity and deflection.
//
// Forces are relative to mu_s F_N, rates to the velocity (of nu_0: times that), slope and nu to themselves.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/dynamics/point_bristle.h>

namespace patchgrip::cli {
namespace {

constexpr std::string_view section = "point_laws";

constexpr std::array<std::string_view, 13> quantities{"coulomb",
                                                      "stribeck",
                                                      "viscous",
                                                      "tanh_stribeck",
                                                      "R_F_elastoplastic",
                                                      "R_F_nu0",
                                                      "kdot_elastoplastic",
                                                      "kdot_dahl_lugre_beta1",
                                                      "kdot_nu0",
                                                      "beta",
                                                      "slope_SV",
                                                      "nu_4_36",
                                                      "kdot_half_dof_linearised_alpha1"};
constexpr std::size_t forces = 6, rates = 9;  // ends

std::array<double, 13> laws(TableObject& p, const Exact& velocity, const Exact& deflection, Inputs inputs) {
  using namespace dynamics;
  const auto value = [&](std::string_view name) { return as_double(p[name].number(), inputs); };
  const Law law = Law::stribeck(value("muH"), value("muG"), value("vS")).with_viscous(value("muV"));
  const PointBristle b{value("c0"), value("c1"), 0, value("k1f"), value("nu0")};
  b.check();
  const double F = value("FN"), v = as_double(velocity, inputs), kappa = as_double(deflection, inputs);
  const double elastoplastic = elastoplastic_rate(b, law, F, kappa, v), extended = extended_rate(b, law, F, kappa, v);
  return {coulomb_force(law, F, v),
          stribeck_force(law, F, v),
          viscous_force(law, F, v),
          tanh_force(law, F, value("a"), v),
          bristle_force(b, law, F, kappa, elastoplastic, v),
          bristle_force(b, law, F, kappa, extended, v),
          elastoplastic,
          dahl_rate(b, law, F, kappa, v),
          extended,
          plastic_share(b, stribeck_force(law, F, v), kappa, v),
          friction_slope(law, F, v),
          half_freedom_gain(b, law, F, v),
          half_freedom_rate(b, law, F, 1, kappa, v)};
}

}  // namespace

void compare_point_laws(const TableNode& node, AccuracyReport& report) {
  TableObject fields(node);
  TableObject p(fields["parameters"]);
  const Exact limit = p["muH"].positive() * p["FN"].positive();
  for (const TableNode& row_node : fields["rows"].filled()) {
    TableObject row(row_node);
    const Exact v = row["v"].number(), kappa = row["kappa"].number();
    if (v == 0) row["v"].fail("a velocity other than 0 is expected");
    const auto q = measure_entry(fields["parameters"], [&](Inputs inputs) { return laws(p, v, kappa, inputs); });
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const Exact reference = row[quantities[i]].number(), own = reference == 0 ? Exact(1) : Exact(abs(reference));
      const Exact speed = quantities[i] == "kdot_nu0" ? Exact(abs(v) * std::max<Exact>(1, p["nu0"].number())) : abs(v);
      const Exact scale = i < forces ? limit : i < rates ? speed : own;
      report.add({std::string(section), "point", std::string(quantities[i])}, deviation(q, i, reference, scale),
                 row_node.place());
    }
    name_unread(row, section, report);
  }
  for (const std::string_view listed : {"v", "k"}) p.find(listed);  // those of the rows
  name_unread(p, section, report);
  name_unread(fields, section, report);
}

}  // namespace patchgrip::cli
