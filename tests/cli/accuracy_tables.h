// Small reference tables, and the comparison with them, for the tests of `accuracy`.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include <patchgrip/cli/accuracy/accuracy.h>
#include <patchgrip/cli/accuracy/value.h>

#include "scenes.h"

namespace patchgrip::cli::test {

using json = nlohmann::ordered_json;

constexpr double usual = 1e-12;

// A flat punch (S = pi/4 + pi x^2/8, f = pi x/4, m = pi/4 - pi x^2/8) with the pole at x = 1/2.
inline const std::string flat_punch = R"({
  "wrench_integrals": [{
    "name": "punch",
    "contact": {"type": "flat_punch_disc", "radius_m": "1"},
    "a_K_m": "1.0",
    "rows": [{"xi_M": "0.5", "eta_M": "0", "I1": "0.0", "I2": "-0.3926990816987241548078304229",
              "I3": "0.6872233929727672709137032401", "S_m": "0.8835729338221293483176184516"}]
  }]
})";

// A ring with the pole on it.
inline const std::string ring_on_the_rim = R"({
  "hessian_S": [{
    "contact": {"type": "ring_line_load", "radius_m": "1"},
    "rows": [{"xi_M": "1", "eta_M": "0", "S_xixi": "inf", "S_xieta": "0", "S_etaeta": null}]
  }],
  "hessian_D": [{
    "contact": {"type": "ring_line_load", "radius_m": "1"},
    "rows": [{"twist": ["0", "-2", "2"], "D": "2.546479089470325372302140214",
              "H_11_12_13_22_23_33": ["0", "0", "0", "inf", "inf", "inf"]}]
  }]
})";

struct Outcome {
  int code;
  std::string out;
};

class AccuracyTest : public ::testing::Test {
 protected:
  AccuracyTest()
      : file_(std::filesystem::path(::testing::TempDir()) / ("table_" + std::to_string(::getpid()) + ".json")) {}
  ~AccuracyTest() override { std::filesystem::remove(file_); }

  Outcome compare(const std::string& table, double tolerance = usual, bool allow_uncovered = false) const {
    std::ofstream(file_) << table;
    return compare_file(file_.string(), tolerance, allow_uncovered);
  }

  static Outcome compare_file(const std::string& file, double tolerance = usual, bool allow_uncovered = false) {
    std::ostringstream out;
    const int code = run_accuracy({file}, tolerance, allow_uncovered, out);
    return {code, out.str()};
  }

  std::string refusal(const std::string& table) const {
    try {
      compare(table);
    } catch (const TableError& error) {
      return error.what();
    }
    return "(accepted)";
  }

  std::filesystem::path file_;
};

inline std::string committed() { return (data_folder / "reference" / "friction.json").string(); }

inline json committed_json() {
  std::ifstream in(committed());
  return json::parse(in);
}

}  // namespace patchgrip::cli::test
