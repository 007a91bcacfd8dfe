// CalculiX, the second solver, as a program of its own: an input file goes in, tables come out.
//
// Throws   std::runtime_error, with the end of its log, where ccx cannot be started or does not end with success.
#pragma once

#include <filesystem>
#include <string>

namespace patchgrip::verification {

struct CalculixResult {
  double total_force(int component) const;  // the last that *NODE PRINT, TOTALS=ONLY of RF tells

  std::filesystem::path table;  // .dat
};

std::string calculix_version();

CalculixResult run_calculix(const std::string& input);

}  // namespace patchgrip::verification
