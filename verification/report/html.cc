#include <patchgrip/verification/report/html.h>

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include <patchgrip/cli/output_file.h>
#include <patchgrip/cli/picture/escaped.h>
#include <patchgrip/verification/claims/all_claims.h>
#include <patchgrip/verification/report/figures.h>
#include <patchgrip/verification/report/result_json.h>

namespace patchgrip::verification {
namespace {

using cli::escaped;

std::string run_row(const Run& run) {
  return fmt::format("<tr><td>{:g}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.2f}</td></tr>\n", run.setting.elements,
                     run.setting.extent > 0 ? fmt::format("{:g} a", run.setting.extent) : "whole", run.unknowns,
                     run.iterations, run.seconds);
}

std::string comparison_row(const Comparison& c) {
  const bool agrees = c.quantity.claim == Claim::agrees;
  return fmt::format(
      "<tr{}><td>{}</td><td>{:.3g} %</td><td>{:.3g} %</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
      c.is_as_claimed() ? "" : " class=\"bad\"", escaped(c.quantity.name), 100 * c.difference, 100 * c.relative_error,
      std::isnan(c.order) ? "" : fmt::format("{:.1f}", c.order),
      agrees ? fmt::format("{:.2g} %", 100 * c.quantity.tolerance) : "claimed to differ", name_of(c.verdict),
      escaped(c.quantity.reason));
}

void write(const std::filesystem::path& file, const std::string& text) {
  cli::OutputFile out(file.string());
  out.write(text);
  out.commit();
}

std::string csv_of(const Curve& curve) {
  std::string text = fmt::format("line,{},{}\n", curve.x_label, curve.y_label);
  for (const Line& line : curve.lines) {
    for (std::size_t i = 0; i < line.x.size(); ++i) {
      text += fmt::format("\"{}\",{:.10g},{:.10g}\n", line.name, line.x[i], line.y[i]);
    }
  }
  return text;
}

}  // namespace

std::string csv_of(const PlaneField& field) {
  std::string text = "x1_m,y1_m,x2_m,y2_m,x3_m,y3_m,von_mises_Pa\n";
  for (const auto& triangle : field.triangles) {
    double mean = 0;
    for (const std::size_t i : triangle) {
      text += fmt::format("{:.6g},{:.6g},", field.points[i][0], field.points[i][1]);
      mean += field.values[i] / 3;
    }
    text += fmt::format("{:.6g}\n", mean);
  }
  return text;
}

std::string html_of(const Case& one, const Study& study) {
  constexpr double shown_reach = 2;  // of a half-space, in contact radii
  std::string html =
      fmt::format("<h2 id=\"{0}\">{1}</h2>\n<p><code>{0}</code></p>\n", one.name, escaped(claims_of(one.name).title));
  html +=
      "<table><tr><th>quantity</th><th>difference</th><th>FE's own error</th><th>order</th><th>tolerance</th>"
      "<th>verdict</th><th>why</th></tr>\n";
  for (const Comparison& c : study.comparisons) html += comparison_row(c);
  html +=
      "</table>\n<table><tr><th>elements</th><th>body</th><th>unknowns</th><th>iterations</th><th>time [s]</th></tr>\n";
  for (const Run& run : study.runs) html += run_row(run);
  if (study.larger_body) html += run_row(*study.larger_body);
  html += "</table>\n<div class=\"figures\">\n";
  for (const Curve& curve : study.finest.curves) html += curve_figure(curve);
  html += convergence_figure(study);
  if (study.stress) html += stress_figure(*study.stress, shown_reach);
  return html + "</div>\n";
}

std::string html_of_failure(const Case& one, std::string_view what) {
  return fmt::format("<h2 id=\"{0}\">{1}</h2>\n<p class=\"bad\">Not solved: {2}</p>\n", one.name,
                     escaped(claims_of(one.name).title), escaped(what));
}

std::string html_of_solvers(const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string html = "<h2>Two solvers</h2>\n<ul>\n";
  for (const auto& line : lines) html += fmt::format("<li>{}</li>\n", escaped(line));
  return html + "</ul>\n";
}

std::string html_page(std::string_view level, const std::string& parts) {
  std::string of_what;
  for (const auto& [name, version] : versions()) of_what += fmt::format("{} {}, ", name, version);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>patchgrip against finite "
      "elements</title>\n"
      "<style>body{{font-family:sans-serif;margin:2em auto;max-width:75em;line-height:1.4}}"
      "table{{border-collapse:collapse;margin:0.8em 0}}td,th{{border:1px solid #ccc;padding:0.2em "
      "0.6em;text-align:left;"
      "font-size:0.9em}}.bad{{background:#fdd}}.figures svg{{margin:0.5em;vertical-align:top}}</style></head><body>\n"
      "<h1>patchgrip against finite elements</h1>\n<p>{}level {}. Difference: of the library from the finest mesh, "
      "relative to the scale of the quantity. FE's own error: by refinement, and by a body twice as large.</p>\n{}"
      "</body></html>\n",
      of_what, level, parts);
}

void write_fields(const std::filesystem::path& folder, const Case& one, const Study& study) {
  for (const Curve& curve : study.finest.curves) {
    write(folder / fmt::format("{}_{}.csv", one.name, curve.name), csv_of(curve));
  }
  if (study.stress) write(folder / fmt::format("{}_von_mises.csv", one.name), csv_of(*study.stress));
  if (study.finest.vtk) study.finest.vtk((folder / fmt::format("{}.vtk", one.name)).string());
}

}  // namespace patchgrip::verification
