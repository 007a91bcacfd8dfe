// Friction force and moment against the pole: time and error of every method, in one run.
//
//     friction_wrench [--output CSV] [--short] [--patches] [--benchmark_...]
//
// --short    measures only what the chart of error against time needs (plots/speed_accuracy_wrench.py), less often
// --patches  measures the methods that work on every patch (plots/speed_accuracy_patches.py) in place of the rest

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include <patchgrip/bench/batch_cases.h>
#include <patchgrip/bench/command_line.h>
#include <patchgrip/bench/hertz_cases.h>
#include <patchgrip/bench/patch_cases.h>
#include <patchgrip/bench/report.h>
#include <patchgrip/bench/timing.h>
#include <patchgrip/bench/zone_cases.h>

namespace {

using patchgrip::bench::Case, patchgrip::bench::CommandLine;

// What is not an option of ours is one of Google Benchmark's, and goes behind defaults of ours.
void initialise_benchmark(const CommandLine& line, char* program) {
  std::vector<std::string> words{program, "--benchmark_enable_random_interleaving=true",
                                 line.is_short ? "--benchmark_repetitions=5" : "--benchmark_repetitions=15",
                                 line.is_short ? "--benchmark_min_time=0.005" : "--benchmark_min_time=0.02"};
  const std::vector<std::string> others = line.app.remaining();
  words.insert(words.end(), others.begin(), others.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  int count = static_cast<int>(pointers.size());
  pointers.push_back(nullptr);
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) std::exit(2);
}

std::vector<Case> cases_to_run(bool patches, bool is_short) {
  if (patches) return patchgrip::bench::zone_cases();
  std::vector<Case> cases = patchgrip::bench::work_precision_cases();
  if (is_short) return cases;
  for (auto* more : {patchgrip::bench::hertz_cases, patchgrip::bench::batch_cases, patchgrip::bench::round_cases,
                     patchgrip::bench::ellipse_cases, patchgrip::bench::polygon_cases}) {
    std::ranges::move(more(), std::back_inserter(cases));
  }
  return cases;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("friction_wrench", "Friction force and moment against the pole: time and error of every method.",
                   "only what the chart of error against time needs, and less often");
  bool patches = false;
  line.app.add_flag("--patches", patches, "the methods that work on every patch, in place of the rest");
  line.app.footer("Options --benchmark_... go to Google Benchmark.");
  line.app.allow_extras();
  line.read(argc, argv);
  initialise_benchmark(line, argv[0]);

  const std::vector<Case> cases = cases_to_run(patches, line.is_short);
  const std::vector<double> times = patchgrip::bench::least_times(cases);
  std::vector<patchgrip::bench::Measurement> measurements;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    measurements.push_back({cases[i].label, cases[i].error, cases[i].judged, times[i]});
  }
  patchgrip::bench::print_measurements(std::cout, measurements);
  if (!line.is_short && !patches) patchgrip::bench::print_ratios(std::cout, measurements);
  return line.write([&](std::ostream& csv) { patchgrip::bench::write_csv(csv, measurements); });
}
