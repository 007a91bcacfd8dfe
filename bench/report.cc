#include <patchgrip/bench/report.h>

#include <fmt/ostream.h>

#include <patchgrip/bench/vector_set.h>
#include <patchgrip/version.h>

namespace patchgrip::bench {
namespace {

// An error, or nothing where none was taken.
std::string number(double error, bool judged) { return judged ? fmt::format("{:.1e}", error) : "-"; }

}  // namespace

void print_measurements(std::ostream& out, std::span<const Measurement> measurements) {
  fmt::print(out,
             "Time of one evaluation, and the worst error of force and moment against 50 digits: relative to the true\n"
             "value, and in units of mu F_N and mu F_N a_K. This CPU has {}.\n\n",
             name_of(vector_set()));
  fmt::print(out, "{:16} {:>8} {:16} {:8} {:>12}   {:>8} {:>8}   {:>8} {:>8}\n", "method", "", "patch", "poles", "ns",
             "force", "moment", "/ mu F_N", "/ .. a_K");
  for (const auto& [label, error, judged, ns] : measurements) {
    fmt::print(out, "{:16} {:>8} {:16} {:8} {:>12.4g}   {:>8} {:>8}   {:>8} {:>8}\n", label.method,
               label.parameter == 0 ? "" : fmt::format("{:g}", label.parameter), label.patch, label.mix, ns,
               number(error.force, judged), number(error.moment, judged), number(error.force_of_scale, judged),
               number(error.moment_of_scale, judged));
  }
  fmt::print(out, "\n");
}

void write_csv(std::ostream& out, std::span<const Measurement> measurements) {
  fmt::print(out, "# patchgrip {} friction_wrench, {}\n", version, name_of(vector_set()));
  fmt::print(out,
             "# ns: fastest of several repetitions, per evaluation; errors: the worst over `judged` poles against 50 "
             "digits\n");
  fmt::print(out,
             "# error_wrench: of (force, moment / a_K) as one vector; with --patches M_0 / (mu F_N) in place of a_K\n");
  fmt::print(out,
             "method,parameter,patch,mix,ns,judged,error_force,error_moment,error_force_of_scale,error_moment_of_scale,"
             "error_wrench\n");
  for (const auto& [label, error, judged, ns] : measurements) {
    fmt::print(out, "{},{:.17g},{},{},{:.6g},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", label.method, label.parameter,
               label.patch, label.mix, ns, judged, error.force, error.moment, error.force_of_scale,
               error.moment_of_scale, error.wrench);
  }
}

}  // namespace patchgrip::bench
