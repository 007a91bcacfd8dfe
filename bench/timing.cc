#include <patchgrip/bench/timing.h>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

namespace patchgrip::bench {
namespace {

std::string name_of(const Label& label) {
  return fmt::format("{}/{}/{}/{:g}", label.method, label.patch, label.mix, label.parameter);
}

// Keeps the fastest repetition of every benchmark.
class FastestRuns : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const double seconds = run.cpu_accumulated_time / static_cast<double>(run.iterations);
      const auto [at, first] = seconds_.try_emplace(run.run_name.function_name, seconds);
      if (!first) at->second = std::min(at->second, seconds);
    }
  }

  double seconds(const std::string& name) const {
    const auto at = seconds_.find(name);
    return at == seconds_.end() ? std::numeric_limits<double>::quiet_NaN() : at->second;
  }

 private:
  std::map<std::string, double> seconds_;  // of one pass
};

}  // namespace

std::vector<double> least_times(std::span<const Case> cases) {
  for (const Case& c : cases) {
    benchmark::RegisterBenchmark(name_of(c.label).c_str(), [&c](benchmark::State& state) {
      for (auto _ : state) c.pass();
    });
  }
  FastestRuns fastest;
  benchmark::RunSpecifiedBenchmarks(&fastest);
  benchmark::ClearRegisteredBenchmarks();
  std::vector<double> times;
  for (const Case& c : cases)
    times.push_back(1e9 * fastest.seconds(name_of(c.label)) / static_cast<double>(c.evaluations));
  return times;
}

}  // namespace patchgrip::bench
