// The report of all cases: one HTML file with its figures in it, which needs nothing else.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/verification/cases/case.h>

namespace patchgrip::verification {

// The part of a case: its runs and quantities as tables, then its figures.
std::string html_of(const Case& one, const Study& study);
std::string html_of_failure(const Case& one, std::string_view what);
std::string html_of_solvers(const std::vector<std::string>& lines);  // empty without lines
// All parts as a page.
std::string html_page(std::string_view level, const std::string& parts);

std::string csv_of(const PlaneField& field);  // a line for each triangle: its corners and the mean of the stress

// Curves and the stress as CSV, fields as VTK for ParaView; named after the case.
void write_fields(const std::filesystem::path& folder, const Case& one, const Study& study);

}  // namespace patchgrip::verification
