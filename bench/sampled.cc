// Sampled pressures: what exact integrals cost against the naive sum, and how time grows with the number of cells.
//
//     sampled [--short] [--output CSV]
//
// One run: times are the least of many, of one gradient at poles spread evenly over 1.2 times the patch's box. Errors
// of trees are the largest difference from the exact sum, force and moment over the radius.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/bench/naive_sum.h>
#include <patchgrip/friction/sampled/grid_pieces.h>
#include <patchgrip/friction/sampled/pressure_grid.h>
#include <patchgrip/friction/sampled/pressure_mesh.h>

namespace {

using namespace patchgrip::friction;  // NOLINT: a program of its own
using kernels::Lanes;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double dome(double x, double y) { return std::sqrt(std::max(0.0, 1 - x * x - y * y)); }

PressureCells cells_of(std::size_t n) {
  const double h = 2 / static_cast<double>(n);
  PressureCells cells{n, n, h, h, -1, -1, {}};
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i)
      cells.pressures.push_back(dome(-1 + (static_cast<double>(i) + 0.5) * h, -1 + (static_cast<double>(j) + 0.5) * h));
  }
  return cells;
}

Triangulation mesh_of(std::size_t n) {
  Triangulation mesh;
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i)
      mesh.points.push_back({2 * static_cast<double>(i) / static_cast<double>(n) - 1,
                             2 * static_cast<double>(j) / static_cast<double>(n) - 1});
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = j * (n + 1) + i, b = a + n + 1;
      mesh.triangles.push_back({a, a + 1, b});
      mesh.triangles.push_back({a + 1, b + 1, b});
    }
  }
  return mesh;
}

std::vector<Twist> poles(std::size_t count) {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<> place(-1.2, 1.2);
  std::vector<Twist> result(count);
  for (Twist& v : result) v = twist_about({place(engine), place(engine)}, 1);
  return result;
}

// Least time of one evaluation [ns].
template <class Evaluate>
double least_time(const std::vector<Twist>& twists, double enough, const Evaluate& evaluate) {
  double least = std::numeric_limits<double>::infinity();
  volatile double kept = 0;
  for (const double end = seconds() + enough; seconds() < end;) {
    const double start = seconds();
    double sum = 0;
    for (const Twist& v : twists) {
      const Wrench g = evaluate(v);
      sum += g.fx + g.fy + g.m;
    }
    least = std::min(least, seconds() - start);
    kept = kept + sum;
  }
  return 1e9 * least / static_cast<double>(twists.size());
}

struct Row {
  std::string method;
  std::size_t pieces;
  double ns;
  double error;
};

class Bench {
 public:
  explicit Bench(bool brief) : enough_(brief ? 0.05 : 0.5) {}

  template <class Evaluate>
  double time(const std::string& method, std::size_t pieces, const std::vector<Twist>& twists, double error,
              const Evaluate& evaluate) {
    const double ns = least_time(twists, enough_, evaluate);
    rows_.push_back({method, pieces, ns, error});
    fmt::print("{:34} {:>9} {:>12.1f} ns   error {:.1e}\n", method, pieces, ns, error);
    std::fflush(stdout);
    return ns;
  }

  void write(std::ostream& out) const {
    out << "method,pieces,ns,error\n";
    for (const Row& r : rows_) out << fmt::format("{},{},{:.17g},{:.17g}\n", r.method, r.pieces, r.ns, r.error);
  }

 private:
  double enough_;
  std::vector<Row> rows_;
};

void ratio(std::string_view what, double limit, double measured) {
  fmt::print("{:58} <= {:<5g} {:8.2f}  {}\n", what, limit, measured, measured <= limit ? "" : "missed");
}

// The corner sums of a grid alone, with the vectors of one kind.
class CornerSums {
 public:
  CornerSums(const PressureCells& cells, Lanes lanes)
      : pieces_(lines(cells.nx), lines(cells.ny), unit_force(cells), lanes) {
    pieces_.make_tree(cells.nx, cells.ny);
  }

  Wrench gradient(const Twist& v) const noexcept {
    const double X = -v.vy / v.w, Y = v.vx / v.w;
    kernels::DistanceSums s;
    pieces_.add(0, X, Y, kernels::Derivatives::first, s);
    return {s.gy, -s.gx, s.S - X * s.gx - Y * s.gy};
  }

 private:
  static std::vector<double> lines(std::size_t n) {
    std::vector<double> x;
    for (std::size_t i = 0; i <= n; ++i) x.push_back(2 * static_cast<double>(i) / static_cast<double>(n) - 1);
    return x;
  }
  static std::vector<double> unit_force(const PressureCells& cells) {
    std::vector<double> p = cells.pressures;
    const double force = std::accumulate(p.begin(), p.end(), 0.0) * cells.dx * cells.dy;
    for (double& value : p) value /= force;
    return p;
  }

  kernels::GridPieces pieces_;
};

template <class P, class Q>
double largest_difference(const P& patch, const Q& exact, const std::vector<Twist>& twists, std::size_t count) {
  double worst = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Wrench g = patch.gradient(twists[i]), h = exact.gradient(twists[i]);
    worst = std::max({worst, std::hypot(g.fx - h.fx, g.fy - h.fy), std::fabs(g.m - h.m)});
  }
  return worst;
}

void against_naive(Bench& bench) {
  const auto twists = poles(256);
  const patchgrip::bench::NaiveSum naive(1, 21);
  const PressureCells cells = cells_of(21);
  const PressureGrid grid = PressureGrid::exact(cells);
  const double sum = bench.time("naive sum", 441, twists, largest_difference(naive, grid, twists, 256),
                                [&](const Twist& v) { return naive.gradient(v); });
  const auto corners = [&](const char* name, Lanes lanes) {
    const CornerSums sums(cells, lanes);
    return bench.time(name, 441, twists, largest_difference(sums, grid, twists, 256),
                      [&](const Twist& v) { return sums.gradient(v); });
  };
  const double two = corners("exact grid (SSE2)", Lanes::two);
  if (kernels::widest_lanes() != Lanes::two) corners("exact grid (AVX2)", Lanes::four);
  const double whole =
      bench.time("exact grid (dispatched)", 441, twists, 0, [&](const Twist& v) { return grid.gradient(v); });
  ratio("exact 21 x 21 grid, SSE2 / naive sum", 5, two / sum);
  ratio("exact 21 x 21 grid, dispatched / naive sum", 2.5, whole / sum);
}

void growth(Bench& bench, bool brief) {
  const auto twists = poles(64);
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    double first = 0, last = 0;
    for (const std::size_t n : {32UL, 128UL, 512UL, 1024UL}) {
      const PressureCells cells = cells_of(n);
      const PressureGrid tree = PressureGrid::within(tolerance, cells);
      const PressureGrid exact = PressureGrid::exact(cells);
      const double error = largest_difference(tree, exact, twists, n > 512 ? 8 : 32);
      const double ns = bench.time(fmt::format("grid within {:g}", tolerance), n * n, twists, error,
                                   [&](const Twist& v) { return tree.gradient(v); });
      if (n == 128) first = ns;
      last = ns;
      if (tolerance == 1e-9 && !(brief && n > 512)) {
        const std::vector<Twist> few(twists.begin(), twists.begin() + 4);
        bench.time("exact grid", n * n, few, 0, [&](const Twist& v) { return exact.gradient(v); });
      }
    }
    ratio(fmt::format("grid within {:g}, 1.05e6 cells / 1.6e4 cells", tolerance), 4, last / first);
  }
  double first = 0, last = 0;
  for (const std::size_t n : {91UL, brief ? 256UL : 708UL}) {
    const Triangulation mesh = mesh_of(n);
    std::vector<double> p;
    for (const Point& point : mesh.points) p.push_back(dome(point.x, point.y));
    const double start = seconds();
    const PressureMesh tree = PressureMesh::linear_within(1e-9, mesh, p);
    fmt::print("made in {:.2f} s\n", seconds() - start);
    const PressureMesh exact = PressureMesh::linear(mesh, p);
    const double ns =
        bench.time("mesh within 1e-09", mesh.triangles.size(), twists, largest_difference(tree, exact, twists, 8),
                   [&](const Twist& v) { return tree.gradient(v); });
    const std::vector<Twist> few(twists.begin(), twists.begin() + 4);
    bench.time("exact mesh", mesh.triangles.size(), few, 0, [&](const Twist& v) { return exact.gradient(v); });
    if (first == 0) first = ns;
    last = ns;
  }
  ratio(fmt::format("mesh within 1e-09, {} triangles / 1.6e4", brief ? "1.3e5" : "1e6"), 4, last / first);
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("sampled", "Sampled pressures: time and error against the number of cells.",
                                     "fewer cells, and each measurement less often");
  line.read(argc, argv);
  Bench bench(line.is_short);
  against_naive(bench);
  growth(bench, line.is_short);
  return line.write([&](std::ostream& csv) { bench.write(csv); });
}
