// The format of reference tables: how they may be written, what is named, what is refused.
#include <patchgrip/cli/accuracy/accuracy.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "accuracy_tables.h"

namespace patchgrip::cli {
namespace {

using test::flat_punch;
using test::Outcome;
using test::ring_on_the_rim;
using test::usual;
using test::with;
using ::testing::AllOf;
using ::testing::HasSubstr;

class AccuracyFormat : public test::AccuracyTest {};

TEST_F(AccuracyFormat, NumbersMayBeJsonNumbersOfAnyLength) {
  std::string bare = flat_punch;
  for (const char* digits : {"1", "1.0", "0.5", "0", "0.0", "-0.3926990816987241548078304229",
                             "0.6872233929727672709137032401", "0.8835729338221293483176184516"}) {
    bare = with(bare, '"' + std::string(digits) + '"', digits);
  }
  const Outcome outcome = compare(bare);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, compare(flat_punch).out);
}

TEST_F(AccuracyFormat, LengthsMayComeInOtherUnits) {
  std::string small = with(flat_punch, R"("radius_m": "1")", R"("radius_mm": "1000")");
  small = with(small, R"("a_K_m": "1.0")", R"("a_K_cm": 100)");
  EXPECT_EQ(compare(small).code, 0);
  EXPECT_EQ(compare(with(small, R"("radius_mm")", R"("radius_um")")).code, 1);
  EXPECT_THAT(refusal(with(small, R"("radius_mm": "1000")", R"("radius_mm": "1000", "radius_m": "1")")),
              HasSubstr("another unit"));
}

TEST_F(AccuracyFormat, ContactsMayLieAwayFromTheOrigin) {
  // I3 grows by c x F = (2, -3) x (0, I2): 2 I2
  std::string moved = with(flat_punch, R"("radius_m": "1")", R"("radius_m": "1", "centre_m": [2, -3])");
  moved = with(moved, R"("xi_M": "0.5", "eta_M": "0")", R"("xi_M": "2.5", "eta_M": "-3")");
  EXPECT_EQ(compare(moved).code, 1);
  moved = with(moved, "0.6872233929727672709137032401", "-0.0981747704246810387019576057");
  EXPECT_EQ(compare(moved).code, 0);
  EXPECT_THAT(refusal(with(moved, R"("centre_m")", R"("centre": [0, 0], "centre_m")")), HasSubstr("twice"));
}

TEST_F(AccuracyFormat, WhatIsUnknownIsNamed) {
  struct Unknown {
    std::string table, named;
  };
  const Unknown unknown[] = {
      {with(flat_punch, R"({
  "wrench)",
            R"({"third_law": {"x": 1}, "wrench)"),
       "third_law: all of it"},
      {with(flat_punch, R"({
  "wrench)",
            R"({"misc": {"drift": [1, 2]}, "wrench)"),
       "misc.drift: all of it"},
      {with(flat_punch, R"("name": "punch")", R"("name": "punch", "temperature": "20")"),
       "wrench_integrals: field 'temperature'"},
      {with(flat_punch, R"("xi_M")", R"("S_xixi": "1", "xi_M")"), "wrench_integrals: field 'S_xixi'"},
      {with(flat_punch, "flat_punch_disc", "conical_disc"), "wrench_integrals: contact type 'conical_disc'"},
      {with(flat_punch, R"("radius_m")", R"("angle": "0.1", "radius_m")"),
       "wrench_integrals: field 'angle' of contact type 'flat_punch_disc'"},
      {with(flat_punch, R"("flat_punch_disc")", R"("power_disc", "n": "1e3")"),
       "contact type 'power_disc': exponent = 1000"},
  };
  for (const auto& [table, named] : unknown) {
    const Outcome outcome = compare(table);
    EXPECT_EQ(outcome.code, 1) << named;
    EXPECT_THAT(outcome.out, HasSubstr("Not covered: "));
    EXPECT_THAT(outcome.out, HasSubstr(named));
    EXPECT_EQ(compare(table, usual, true).code, 0) << named;
  }
}

TEST_F(AccuracyFormat, RemarksAreNoFields) {
  EXPECT_EQ(compare(with(flat_punch, R"("name": "punch")",
                         R"("name": "punch", "note": "n", "a_K_note": "n", "definition": "d")"))
                .code,
            0);
}

TEST_F(AccuracyFormat, ContactsOfOtherTablesAreNamedByTheirKind) {
  const Outcome outcome = compare(R"({"entries": [{"id": "a", "name": "jkrs"}, {"id": "b", "name": "jkrs"}]})");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("Not covered: entries: 'jkrs' (2 entries)"));
}

TEST_F(AccuracyFormat, BadTablesAreRefusedAtTheirPlace) {
  const std::string place = "wrench_integrals[0] 'punch'";
  const struct {
    std::string table, message;
  } bad[] = {
      {"", ": no JSON: "},
      {"{", ": no JSON: "},
      {"[1, 2]", ": the table = a list of 2: an object"},
      {"\x01\x02", ": no JSON: "},
      {R"({"a": 1, "a": 2})", "the name 'a' is there twice"},
      {R"({"a": )" + std::string(100, '[') + std::string(100, ']') + "}", "64 deep"},
      {R"({"a": 1e999})", ": no JSON: "},
      {R"({"wrench_integrals": {}})", ": wrench_integrals = an object: a list"},
      {R"({"wrench_integrals": []})", ": wrench_integrals = a list of 0: a list that is not empty"},
      {R"({"conventions": {"F_N": "1 N"}, "misc": {}})", ": the table = an object: nothing to compare"},
      {with(flat_punch, R"("xi_M": "0.5", )", ""), place + " rows[0] = an object: the field 'xi_M' is missing"},
      {with(flat_punch, R"("a_K_m": "1.0",)", ""), place + " = an object: the field 'a_K_m' is missing"},
      {with(flat_punch, R"("type": "flat_punch_disc", )", ""),
       place + " contact = an object: the field 'type' is missing"},
      {with(flat_punch, R"(, "radius_m": "1")", ""), place + " contact = an object: the field 'radius_m' is missing"},
      {with(flat_punch, "\"0.5\"", "\"0.5.1\""), place + " rows[0].xi_M = '0.5.1': not a number"},
      {with(flat_punch, "\"0.5\"", "\"nan\""), place + " rows[0].xi_M = 'nan': not a number"},
      {with(flat_punch, "\"0.5\"", "\"inf\""), place + " rows[0].xi_M = 'inf': not a number"},
      {with(flat_punch, "\"0.5\"", "\"1e400\""), place + " rows[0].xi_M = '1e400': "},
      {with(flat_punch, "\"0.5\"", "true"), place + " rows[0].xi_M = 'true': not a number"},
      {with(flat_punch, "\"0.5\"", "[0.5]"), place + " rows[0].xi_M = a list of 1: not a number"},
      {with(flat_punch, R"("a_K_m": "1.0")", R"("a_K_m": "-1.0")"), place + " a_K_m = '-1.0': a positive number"},
      {with(flat_punch, R"("radius_m": "1")", R"("radius_m": "-1")"), place + " contact = an object: radius = -1"},
      {with(flat_punch, R"("flat_punch_disc")", R"("power_disc", "n": "-0.5")"),
       "contact.n = '-0.5': a number above -0.5"},
      {with(flat_punch, R"("flat_punch_disc", "radius_m": "1")",
            R"("rectangle_uniform", "l_xi_m": "0", "l_eta_m": "1")"),
       " contact = "},
      {with(flat_punch, R"("flat_punch_disc", "radius_m": "1")",
            R"("polygon_uniform", "vertices_m": [[0, 0], [1, 1], [1, 0], [0, 1]])"),
       " contact = "},
      {with(flat_punch, R"("radius_m": "1")", R"("radius_m": "1", "centre_m": [1])"),
       "centre_m = a list of 1: a list of 2"},
      {R"({"wrench_integrals": [{"contact": {"type": "hertz_disc", "radius_m": 1}, "a_K_m": 1, "rows": []}]})",
       "rows = a list of 0"},
      {with(ring_on_the_rim, R"(["0", "-2", "2"])", R"(["0", "-2"])"), "twist = a list of 2: a list of 3"},
      {with(ring_on_the_rim, R"(["0", "0", "0", )", R"(["0", "0", )"), "33 = a list of 5: a list of 6"},
      {R"({"limit_curve": [{"name": "hertz_disc", "points": [{"r_M_over_a": "-1", "f": 0, "m": 0}]}]})", "r_M_over_a"},
      {R"+({"misc": {"example_4_8": {"l_xi": "2M", "l_eta": "L", "pole": "(0,L)"}}})+", "l_xi = '2M': a multiple of L"},
      {R"({"misc": {"example_4_8": {"l_xi": "2L", "l_eta": "L", "pole": "0,L"}}})", "pole = '0,L': a pole such as"},
      {R"({"local_stribeck": {"mu_H": "0.9", "mu_Gl": "0.5", "v_S": "-1", "F_N": "1", "rows": []}})",
       "local_stribeck = an object: "},
      {R"({"belt_stick_slip": {"cases": [{"parameters": {"m": "-2", "k": 1, "v0": 1, "Fs": 2, "Fk": 1}}]}})",
       "belt_stick_slip.cases[0].parameters.m = '-2': a positive number"},
      {R"({"belt_stick_slip": {"cases": [{"parameters": {"m": 2, "k": 1, "v0": 1, "Fs": 1, "Fk": 2}}]}})",
       "belt_stick_slip.cases[0].parameters = an object: mu_hold = 1"},
      {R"({"karnopp": {"parameters": {"m": 1, "FN": 1, "dv": 1, "v0": 2}}})", "'x_at_10_s', or of another time"},
      {R"({"return_mapping_hertz_disc": {"radius_m": 1, "K": [1, 1, 0], "F_N": 1, "rows": []}})",
       "return_mapping_hertz_disc.K = a list of 3: positive stiffnesses"},
      {R"({"return_mapping_hertz_disc": {"radius_m": 1, "K": [1, 1, 1], "F_N": 1, "rows": [{"mode": "glide"}]}})",
       "rows[0].mode = 'glide': 'stick' or 'slip'"},
      {R"({"misc": {"coast_down_stop": [{"contact": "hertz_disc", "m a^2/J": -1}]}})",
       "misc.coast_down_stop[0].m a^2/J = '-1': a positive number"},
      {R"({"misc": {"disc_example_fig_4_30": {"parameters": {"aK": 0}}}})",
       "misc.disc_example_fig_4_30.parameters.aK = '0': a positive number"},
  };
  for (const auto& [table, message] : bad) {
    EXPECT_THAT(refusal(table), AllOf(HasSubstr(file_.string() + ":"), HasSubstr(message))) << table;
  }
}

TEST_F(AccuracyFormat, FilesThatCannotBeReadAreRefused) {
  EXPECT_THROW(compare_file(file_.string() + ".missing"), TableError);
  EXPECT_THROW(compare_file(::testing::TempDir()), TableError);
}

}  // namespace
}  // namespace patchgrip::cli
