#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <patchgrip/bench/batch_cases.h>
#include <patchgrip/bench/report.h>
#include <patchgrip/bench/vector_set.h>

namespace patchgrip::bench {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

class Ratios {
 public:
  Ratios(std::ostream& out, std::span<const Measurement> measurements) : out_(out), measurements_(measurements) {}

  double ns(const Label& label) const {
    const auto at = std::ranges::find(measurements_, label, &Measurement::label);
    return at == measurements_.end() ? unknown : at->ns;
  }

  double hertz(const std::string& method, double parameter, const std::string& mix) const {
    return ns({method, parameter, "hertz_disc", mix});
  }

  void at_most(const std::string& what, double limit, double measured) const {
    line(what, "<=", limit, measured, measured <= limit);
  }
  void at_least(const std::string& what, double limit, double measured) const {
    line(what, ">=", limit, measured, measured >= limit);
  }

 private:
  void line(const std::string& what, const char* relation, double limit, double measured, bool met) const {
    if (std::isnan(measured)) return;
    fmt::print(out_, "{:66} {} {:<8g} {:>10.4g}  {}\n", what, relation, limit, measured, met ? "" : "missed");
  }

  std::ostream& out_;
  std::span<const Measurement> measurements_;
};

// Largest error of force and moment of one method on one patch, over all its poles, in units of rounding.
double worst_units(std::span<const Measurement> measurements, const std::string& method, const std::string& patch) {
  double worst = 0;
  for (const auto& [label, error, judged, ns] : measurements) {
    if (judged == 0 || label.method != method || label.patch != patch) continue;
    for (const double relative : {error.force, error.moment}) {
      if (!(relative * 0x1p53 <= worst)) worst = relative * 0x1p53;
    }
  }
  return worst;
}

void print_hertz(const Ratios& r) {
  const double exact = r.hertz("exact", 0, "mixed");
  const double batch = r.hertz("batch", small_table, "mixed");
  r.at_most("exact Hertz disc / the seed's polynomials, mixed poles", 2.5,
            exact / r.hertz("seed_polynomial", 0, "mixed"));
  r.at_most("exact Hertz disc / the seed's polynomials, outside", 4,
            r.hertz("exact", 0, "outside") / r.hertz("seed_polynomial", 0, "outside"));
  r.at_least("naive 21 x 21 sum / exact Hertz disc, mixed poles", 50, r.hertz("naive_sum", 21, "mixed") / exact);
  r.at_least("naive 21 x 21 sum / batch, mixed poles", 150, r.hertz("naive_sum", 21, "mixed") / batch);
  r.at_least("quadrature to 1e-10 / exact Hertz disc, mixed poles", 1e4,
             r.hertz("gsl_quadrature", 1e-10, "mixed") / exact);
}

void print_batch(const Ratios& r) {
  const auto ratio = [&](const char* method, std::size_t rows) {
    const auto parameter = static_cast<double>(rows);
    return r.hertz(method, parameter, "mixed") / r.hertz("batch", parameter, "mixed");
  };
  const VectorSet set = vector_set();
  const double speed_up = set == VectorSet::avx512 ? 3.5 : set == VectorSet::avx2 ? 2.5 : 1;
  r.at_least(fmt::format("scalar loop / batch with {}, table in the cache", name_of(set)), speed_up,
             ratio("scalar_loop", small_table));
  r.at_most("batch / copy of its 40 bytes a pole, table of 320 MiB", 2, 1 / ratio("copy", large_table));
}

void print_patches(const Ratios& r) {
  const double hertz = r.hertz("exact", 0, "mixed");
  for (const char* patch : {"flat_punch_disc", "uniform_disc", "ring", "power_disc", "xydas_kao_disc"}) {
    r.at_most(fmt::format("{} / Hertz disc, mixed poles", patch), 1.5, r.ns({"exact", 0, patch, "mixed"}) / hertz);
  }
  for (const double aspect : {2.0, 100.0}) {
    for (const auto& [mix, limit] : {std::pair{"inside", 2.0}, std::pair{"near", 5.0}, std::pair{"outside", 5.0}}) {
      r.at_most(fmt::format("Hertz ellipse {}:1, {} poles / Hertz disc, mixed poles", aspect, mix), limit,
                r.ns({"exact", aspect, "hertz_ellipse", mix}) / hertz);
    }
  }
  for (const auto& [edges, limit] : {std::pair{3, 2.5}, std::pair{8, 2.5}, std::pair{64, 1.5}}) {
    const double an_edge = r.ns({"exact", double(edges), "polygon", "box"}) / edges;
    r.at_most(fmt::format("polygon of {} edges, per edge / std::asinh", edges), limit,
              an_edge / r.ns({"asinh", double(edges), "polygon", "box"}));
  }
}

}  // namespace

void print_ratios(std::ostream& out, std::span<const Measurement> measurements) {
  const Ratios ratios(out, measurements);
  fmt::print(out, "{:66} {:11} {:>10}\n", "Ratios of times", "target", "measured");
  print_hertz(ratios);
  print_batch(ratios);
  print_patches(ratios);
  fmt::print(out, "\nWorst error of force and moment, each relative to itself, in units of 2^-53\n");
  for (const char* patch : {"hertz_disc", "flat_punch_disc", "uniform_disc", "ring", "power_disc", "xydas_kao_disc"}) {
    ratios.at_most(patch, 8, worst_units(measurements, "exact", patch));
  }
  ratios.at_most("hertz_ellipse", 20, worst_units(measurements, "exact", "hertz_ellipse"));
  ratios.at_most("hertz_disc, batch", 8, worst_units(measurements, "batch", "hertz_disc"));
}

}  // namespace patchgrip::bench
