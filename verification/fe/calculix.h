// CalculiX, the second solver, as a program of its own: an input file goes in, tables come out.
//
// Throws   std::runtime_error, with the end of its log, where ccx cannot be started, does not end with success, or has
//          not told what is asked for.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace patchgrip::verification {

struct CalculixResult {
  // What *NODE PRINT tells after each heading, e.g. "total force" or "displacements": the numbers of the first line.
  std::vector<std::vector<double>> printed(std::string_view heading) const;
  double total_force(int component) const;  // the last that *NODE PRINT, TOTALS=ONLY of RF tells
  // At the nodes, by their numbers, as *NODE FILE or *EL FILE tells it last, e.g. "STRESS".
  std::map<int, double> field(std::string_view name, std::size_t component) const;

  std::filesystem::path table;   // .dat
  std::filesystem::path fields;  // .frd
};

std::string calculix_version();

CalculixResult run_calculix(const std::string& input);

}  // namespace patchgrip::verification
