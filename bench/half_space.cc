// Contact of a half-space: time, memory and error of press_half_space against the number of cells, in one run.
//
//     half_space [--output CSV] [--short]
//
// Times are CPU times in P: one real FFT of 2N x 2N numbers and back, the least of its runs here. --short prints
// nothing and leaves out the hard cases: what the charts need (plots/half_space.py).

#include <fftw3.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <numbers>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/contact/half_space/press.h>
#include <patchgrip/tests/contact/half_space_shapes.h>

namespace {

using namespace patchgrip::contact;  // NOLINT: a program of its own

constexpr double pi = std::numbers::pi;
constexpr double width = 2.5;  // of the square, in contact radii: a = R = E* = 1, F = 4/3, delta = 1

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Of this process: less disturbed by others than the wall clock.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <class Run>
double least_time(double (*seconds)(), int runs, const Run& run) {
  double least = INFINITY;
  for (int i = 0; i < runs; ++i) {
    const double start = seconds();
    run();
    least = std::min(least, seconds() - start);
  }
  return least;
}

// P: r2c and c2r of n x n numbers in place.
class FftPair {
 public:
  explicit FftPair(int n) : data_(fftw_alloc_real(static_cast<std::size_t>(n) * static_cast<std::size_t>(n + 2))) {
    auto* spectrum = reinterpret_cast<fftw_complex*>(data_);
    const int sizes[] = {n, n}, real[] = {n, n + 2}, half[] = {n, n / 2 + 1};
    forward_ = fftw_plan_many_dft_r2c(2, sizes, 1, data_, real, 1, 0, spectrum, half, 1, 0, FFTW_MEASURE);
    back_ = fftw_plan_many_dft_c2r(2, sizes, 1, spectrum, half, 1, 0, data_, real, 1, 0, FFTW_MEASURE);
    std::fill_n(data_, static_cast<std::size_t>(n) * static_cast<std::size_t>(n + 2), 0.);
  }
  ~FftPair() {
    fftw_destroy_plan(forward_);
    fftw_destroy_plan(back_);
    fftw_free(data_);
  }
  FftPair(const FftPair&) = delete;
  FftPair& operator=(const FftPair&) = delete;

  void run() const {
    fftw_execute(forward_);
    fftw_execute(back_);
  }

 private:
  double* data_;
  fftw_plan forward_, back_;
};

PressedHalfSpace press_hertz(const Grid& grid, const std::vector<double>& gap, const Press& press, int threads) {
  PressSettings settings;
  settings.threads = threads;
  return press_half_space(grid, Surface::free, gap, 1, press, settings);
}

// Resident memory of this process [byte], now or at most so far.
double resident(const char* key) {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line)) {
    if (line.starts_with(key)) return 1024 * std::stod(line.substr(std::strlen(key) + 1));
  }
  return NAN;
}

// Bytes a cell of a solution, gap and result included: in a process of its own.
double memory_per_cell(int cells) {
  int ends[2];
  if (pipe(ends) != 0) return NAN;
  const pid_t child = fork();
  if (child == 0) {
    const double before = resident("VmRSS:");
    const Grid grid = Grid::square(cells, width);
    press_hertz(grid, sample(grid, paraboloid()), Press::by_force(4. / 3.), 1);
    const double bytes = (resident("VmHWM:") - before) / cells / cells;
    _exit(write(ends[1], &bytes, sizeof bytes) == sizeof bytes ? 0 : 1);
  }
  double bytes = NAN;
  if (child < 0 || read(ends[0], &bytes, sizeof bytes) != sizeof bytes) bytes = NAN;
  if (child > 0) waitpid(child, nullptr, 0);
  close(ends[0]);
  close(ends[1]);
  return bytes;
}

double inverse_error(int cells) {
  const Grid grid = Grid::square(cells, width);
  const auto pressure =
      sample(grid, [](double x, double y) { return 2 / pi * std::sqrt(std::max(0., 1 - x * x - y * y)); });
  const auto u = half_space_displacement(grid, Surface::free, pressure, 1);
  const auto exact = sample(grid, [](double x, double y) {
    const double r = std::hypot(x, y);
    return r <= 1 ? 1 - r * r / 2 : ((2 - r * r) * std::asin(1 / r) + std::sqrt(r * r - 1)) / pi;
  });
  double squares = 0;
  for (std::size_t k = 0; k < u.size(); ++k) squares += (u[k] - exact[k]) * (u[k] - exact[k]);
  return std::sqrt(squares / static_cast<double>(u.size()));
}

struct Row {
  int cells;
  double pair;                   // P [s]
  double by_approach, by_force;  // [s] of CPU, one thread
  double one_thread;             // by force, wall time [s]
  double two_threads;            // the same
  double memory;                 // [byte a cell]
  double inverse;                // rms of u, of delta
  PressedHalfSpace approach, force;
};

// Two independent products at once, in times of one alone: 1 on two free cores, 2 on one. Two threads cannot win more.
double slowdown_of_two() {
  const Grid grid = Grid::square(256, width);
  const auto products = [&grid](int count) {
    Workers workers(1);
    Convolution convolution(grid, Surface::free, {workers});
    std::vector<double> field(grid.size(), 1.), u(grid.size());
    for (int i = 0; i < count; ++i) convolution.apply(field.data(), u.data(), workers);
  };
  const double alone = least_time(wall_seconds, 5, [&] { products(100); });
  const double together = least_time(wall_seconds, 5, [&] {
    std::thread other(products, 100);
    products(100);
    other.join();
  });
  return together / alone;
}

// All that is timed takes turns, so that a disturbance meets all alike.
Row measure(int cells, double memory, int rounds) {
  const FftPair pair(2 * cells);
  const Grid grid = Grid::square(cells, width);
  const auto gap = sample(grid, paraboloid());
  Row row{.cells = cells,
          .pair = INFINITY,
          .by_approach = INFINITY,
          .by_force = INFINITY,
          .one_thread = INFINITY,
          .two_threads = INFINITY,
          .memory = memory,
          .inverse = inverse_error(cells),
          .approach = {},
          .force = {}};
  const auto shorten = [](double& least, double time) { least = std::min(least, time); };
  const auto by_force = [&](int threads) { row.force = press_hertz(grid, gap, Press::by_force(4. / 3.), threads); };
  for (int round = 0; round < rounds; ++round) {
    shorten(row.pair, least_time(cpu_seconds, 3, [&] { pair.run(); }));
    shorten(row.by_approach,
            least_time(cpu_seconds, 1, [&] { row.approach = press_hertz(grid, gap, Press::by_approach(1), 1); }));
    shorten(row.pair, least_time(cpu_seconds, 3, [&] { pair.run(); }));
    shorten(row.by_force, least_time(cpu_seconds, 1, [&] { by_force(1); }));
    shorten(row.one_thread, least_time(wall_seconds, 1, [&] { by_force(1); }));
    shorten(row.two_threads, least_time(wall_seconds, 1, [&] { by_force(2); }));
  }
  return row;
}

void report(const char* what, int cells, double measured, double target) {
  const std::string name = cells > 0 ? fmt::format("{}, N = {}", what, cells) : what;
  const char* verdict = std::isnan(target) ? "" : measured <= target ? "yes" : "NO";
  fmt::print("{:<58} {:>10.3g} {:>10} {:>4}\n", name, measured, std::isnan(target) ? "" : fmt::format("{:.3g}", target),
             verdict);
}

double deviation(double value, double exact) { return std::abs(value / exact - 1); }

// Order of convergence: the slope of a line through the logarithms.
double fitted_order(const std::vector<Row>& rows, const std::function<double(const Row&)>& error) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Row& row : rows) {
    const double u = std::log(row.cells), v = std::log(error(row));
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  return -(n * xy - x * y) / (n * xx - x * x);
}

struct Target {
  int cells;
  double time, memory, force, approach, peak, area, inverse;
};
const std::vector<Target> targets{{64, NAN, NAN, 7e-5, 5e-5, 3e-4, 7e-4, NAN},
                                  {128, NAN, NAN, 2.6e-5, 1.8e-5, 8e-5, 3.5e-4, 6e-5},
                                  {256, 25, 200, 5.5e-6, 3.5e-6, 2.5e-5, 2.5e-4, 2e-5},
                                  {512, 15, 150, 2.2e-6, 1.3e-6, 6e-6, 1e-4, 7e-6},
                                  {1024, 15, 150, NAN, NAN, NAN, NAN, NAN}};

double force_error(const Row& row) { return deviation(row.approach.force.value, 4. / 3.); }
double approach_error(const Row& row) { return deviation(row.force.approach.value, 1); }
double peak_error(const Row& row) { return deviation(row.approach.peak_pressure.value, 2 / pi); }
double area_error(const Row& row) { return deviation(row.approach.area.value, pi); }
double counted_error(const Row& row) { return deviation(row.approach.counted_area, pi); }

void print_hertz(const std::vector<Row>& rows) {
  fmt::print("{:<58} {:>10} {:>10}\n", "Hertz paraboloid, square 2.5 a, tolerance 1e-6", "measured", "target");
  report("two independent products at once, time of one", 0, slowdown_of_two(), NAN);
  for (const Row& row : rows) {
    const Target& target = *std::ranges::find(targets, row.cells, &Target::cells);
    report("P [ms]", row.cells, 1e3 * row.pair, NAN);
    report("approach given, time [P]", row.cells, row.by_approach / row.pair, target.time);
    report("force given, time [P]", row.cells, row.by_force / row.pair, target.time);
    report("two threads, wall time of one", row.cells, row.two_threads / row.one_thread, row.cells < 256 ? NAN : 0.7);
    report("memory [byte a cell]", row.cells, row.memory, target.memory);
    report("force error", row.cells, force_error(row), target.force);
    report("approach error", row.cells, approach_error(row), target.approach);
    report("peak pressure error", row.cells, peak_error(row), target.peak);
    report("area error", row.cells, area_error(row), target.area);
    report("area error of counted cells", row.cells, counted_error(row), NAN);
    report("inverse problem, rms(u) of the approach", row.cells, row.inverse, target.inverse);
    report("force error / estimate", row.cells, force_error(row) * 4. / 3. / row.approach.force.error, 3);
    report("force estimate / error", row.cells, row.approach.force.error / (force_error(row) * 4. / 3.), 3);
    report("approach error / estimate", row.cells, approach_error(row) / row.force.approach.error, 3);
    report("approach estimate / error", row.cells, row.force.approach.error / approach_error(row), 3);
    report("area error / estimate", row.cells, area_error(row) * pi / row.approach.area.error, 3);
    report("iterations on the finest grid", row.cells, row.approach.iterations, NAN);
    report("products, in those of the finest grid", row.cells, row.approach.products, NAN);
  }
  const auto row_of = [&](int cells) { return std::ranges::find(rows, cells, &Row::cells); };
  if (row_of(1024) != rows.end()) {
    report("time a cell at N = 1024, of that at 128", 0, row_of(1024)->by_approach / row_of(128)->by_approach / 64,
           2.5);
  }
  fmt::print("{:<58} {:>10} {:>10}\n", "Fitted order (at least)", "measured", "target");
  const auto order = [&](const char* what, double (*error)(const Row&), double least) {
    const double measured = fitted_order(rows, error);
    fmt::print("{:<58} {:>10.3g} {:>10} {:>4}\n", what, measured, least, measured >= least ? "yes" : "NO");
  };
  order("force", force_error, 1.7);
  order("area", area_error, 1.1);
}

void print_hard_cases() {
  fmt::print("{:<58} {:>10} {:>10}\n", "Iterations, N = 256", "measured", "target");
  const auto free = [](const char* what, double side, const GapFunction& gap, const Press& press) {
    const Grid grid = Grid::square(256, side);
    report(what, 0, press_half_space(grid, Surface::free, sample(grid, gap), 1, press).iterations, 60);
  };
  const Grid cell = Grid::square(256, 1);
  const auto wave = sample(cell, [](double x, double) { return 0.01 * (1 - std::cos(2 * pi * x)); });
  report("periodic wave, 0.999 of full contact", 0,
         press_half_space(cell, Surface::periodic, wave, 1, Press::by_force(0.999 * pi * 0.01)).iterations, 60);
  free(
      "two spheres", 5,
      [](double x, double y) { return std::min(paraboloid(-1.3, 0, 1)(x, y), paraboloid(1.3, 0, 0.5)(x, y)); },
      Press::by_approach(0.5));
  free(
      "square flat punch", 8. / 3.,
      [](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 1 ? 0. : 1e3; }, Press::by_approach(1));
  free(
      "round flat punch", 8. / 3., [](double x, double y) { return std::hypot(x, y) < 1 ? 0. : 1e3; },
      Press::by_force(2));
  free("ellipse 10 : 1", 2.5, hertz_ellipse(0.1, 0).gap, Press::by_approach(hertz_ellipse(0.1, 0).approach));
  free("ellipse 10 : 1, turned", 2.5, hertz_ellipse(0.1, 0.4).gap,
       Press::by_approach(hertz_ellipse(0.1, 0.4).approach));
  const auto rough = rough_surface(cell, 1, 1);
  for (const double pressure : {0.02, 0.2, 1., 3.}) {
    report(fmt::format("rough surface, p = {} E* h'", pressure).c_str(), 0,
           press_half_space(cell, Surface::periodic, rough, 1, Press::by_force(pressure)).iterations, 60);
  }

  std::mt19937_64 engine(20061203);
  const Grid grid = Grid::square(64, width);
  int failures = 0, most = 0;
  for (int k = 0; k < 400; ++k) {
    const auto gap = sample(grid, random_shape(engine));
    const bool by_force = patchgrip::testing::uniform(engine, 0, 1) < 0.5;
    const double least = *std::ranges::min_element(gap);
    const Press press = by_force ? Press::by_force(patchgrip::testing::log_uniform(engine, 1e-4, 10))
                                 : Press::by_approach(least + patchgrip::testing::log_uniform(engine, 3e-4, 3));
    PressSettings settings;
    settings.tolerance = 1e-8;
    int iterations = 0;
    settings.observer = [&](const SolverProgress& progress) {
      if (progress.grid.nx == 64) iterations = progress.iteration;
    };
    try {
      press_half_space(grid, Surface::free, gap, 1, press, settings);
    } catch (const std::domain_error&) {  // converged, but touches the border
    } catch (const std::runtime_error&) {
      ++failures;
    }
    most = std::max(most, iterations);
  }
  report("400 random shapes at 1e-8: not converged", 0, failures, 0);
  report("400 random shapes at 1e-8: most iterations", 0, most, NAN);
}

void write_csv(std::ostream& file, const std::vector<Row>& rows) {
  file << "# Hertz paraboloid on a square 2.5 contact radii wide, tolerance 1e-6; errors relative to the exact value\n"
          "cells,pair_s,by_approach_s,by_force_s,force_error,approach_error,peak_error,area_error,counted_area_error,"
          "inverse_error,force_estimate,approach_estimate,area_estimate\n";
  for (const Row& row : rows) {
    file << fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n",
                        row.cells, row.pair, row.by_approach, row.by_force, force_error(row), approach_error(row),
                        peak_error(row), area_error(row), counted_error(row), row.inverse,
                        row.approach.force.error * 0.75, row.force.approach.error, row.approach.area.error / pi);
  }
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("half_space", "Numerical half-space: time, memory and error against its targets.",
                                     "print nothing and leave out the hard cases: for --output");
  line.read(argc, argv);

  const std::vector<int> sizes{64, 128, 256, 512, 1024};
  std::vector<double> memory;  // first, while this process is small
  for (const int cells : sizes) memory.push_back(memory_per_cell(cells));
  std::vector<Row> rows;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    rows.push_back(measure(sizes[k], memory[k], line.is_short ? 2 : sizes[k] > 300 ? 6 : 20));
  if (!line.is_short) {
    print_hertz(rows);
    print_hard_cases();
  }
  return line.write([&](std::ostream& csv) { write_csv(csv, rows); });
}
