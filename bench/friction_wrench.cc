// Friction force and moment against the pole: time and error of every method, in one run.
//
//     friction_wrench [--output CSV] [--short] [--patches] [--benchmark_...]
//
// --short    measures only what the chart of error against time needs (plots/speed_accuracy_wrench.py), less often
// --patches  measures the methods that work on every patch (plots/speed_accuracy_patches.py) in place of the rest

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
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

using patchgrip::bench::Case;

struct Options {
  bool is_short = false;
  bool patches = false;
  std::string output;
};

// What is not an option of ours is one of Google Benchmark's, and goes behind defaults of ours.
Options parse(int argc, char** argv) {
  Options options;
  patchgrip::bench::CommandLine line("friction_wrench",
                                     "Friction force and moment against the pole: time and error of every method.",
                                     "only what the chart of error against time needs, and less often");
  line.app.add_flag("--patches", options.patches, "the methods that work on every patch, in place of the rest");
  line.app.footer("Options --benchmark_... go to Google Benchmark.");
  line.app.allow_extras();
  line.read(argc, argv);
  options.is_short = line.is_short;
  options.output = line.output;

  std::vector<std::string> words{argv[0], "--benchmark_enable_random_interleaving=true",
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
  return options;
}

std::vector<Case> cases_to_run(const Options& options) {
  if (options.patches) return patchgrip::bench::zone_cases();
  std::vector<Case> cases = patchgrip::bench::work_precision_cases();
  if (options.is_short) return cases;
  for (auto* more : {patchgrip::bench::hertz_cases, patchgrip::bench::batch_cases, patchgrip::bench::round_cases,
                     patchgrip::bench::ellipse_cases, patchgrip::bench::polygon_cases}) {
    std::ranges::move(more(), std::back_inserter(cases));
  }
  return cases;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = parse(argc, argv);
  const std::vector<Case> cases = cases_to_run(options);
  const std::vector<double> times = patchgrip::bench::least_times(cases);

  std::vector<patchgrip::bench::Measurement> measurements;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    measurements.push_back({cases[i].label, cases[i].error, cases[i].judged, times[i]});
  }
  patchgrip::bench::print_measurements(std::cout, measurements);
  if (!options.is_short && !options.patches) patchgrip::bench::print_ratios(std::cout, measurements);
  if (options.output.empty()) return 0;
  std::ofstream file(options.output);
  patchgrip::bench::write_csv(file, measurements);
  file.flush();
  if (!file) {
    std::cerr << "friction_wrench: cannot write " << options.output << '\n';
    return 1;
  }
}
