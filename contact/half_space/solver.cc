#include <patchgrip/contact/half_space/solver.h>
#include <patchgrip/contact/half_space/solver_kernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace patchgrip::contact {
namespace {

constexpr double inner_reduction = 0.1;  // of the residual in a set, before the set is chosen anew
constexpr double inner_floor = 0.3;      // times the tolerance: no further
constexpr double drift = 1e-11;          // of the residual in a step that updates g: rounding, with much to spare

[[noreturn]] void not_converged(const Grid& grid, double residual, double tolerance, int iterations) {
  std::ostringstream text;
  text << "pressure on " << grid.nx << " x " << grid.ny << " cells did not converge: residual " << residual << " after "
       << iterations << " iterations, tolerance " << tolerance;
  throw std::runtime_error(text.str());
}

std::array<double, 2> first_two(const Tally& tally) { return {tally.sums[0], tally.sums[1]}; }

}  // namespace

ContactSolver::ContactSolver(const Grid& grid, Surface surface, std::span<const double> gap, Resources resources)
    : grid_(grid),
      surface_(surface),
      gap_(gap),
      least_gap_(kernels::least(gap.size(), gap.data())),
      workers_(resources.workers),
      pieces_(grid.size(), workers_),
      product_(grid, surface, resources),
      preconditioner_(grid, surface, resources),
      g_(grid.size(), resources.memory),
      direction_(grid.size(), resources.memory),
      work_(grid.size(), resources.memory),
      on_(grid.size(), resources.memory),
      uniform_(grid.size(), resources.memory) {}

SolverStatus ContactSolver::solve(Prescribed prescribed, double value, double tolerance, int max_iterations,
                                  const SolverObserver& observer, std::span<double> pressure) {
  begin(prescribed, value, pressure);
  int iterations = 0, sets = 0, steps = 0;  // steps since g was formed from p
  bool fresh = true;                        // g is to be formed from p
  while (true) {
    if (fresh) form_displacement(prescribed, pressure);
    const bool changed = choose_set(fresh, pressure);
    ++sets;
    if (fresh) steps = 0;
    if (residual_ <= tolerance) {
      if (steps * drift <= tolerance) break;
      fresh = true;
      continue;
    }
    const bool keep = !fresh && !changed;
    if (!keep && prescribed == Prescribed::load) prepare_load_projection();
    const double start = set_residual_;
    for (int k = 0; k == 0 || set_residual_ > std::max(inner_reduction * start, inner_floor * tolerance * scale_);
         ++k) {
      if (iterations == max_iterations) not_converged(grid_, residual_, tolerance, iterations);
      step(prescribed, keep || k > 0, pressure);
      ++iterations;
      ++steps;
      if (observer) observer({grid_, iterations, set_residual_ / scale_});
    }
    fresh = cut(prescribed, value, pressure);
  }
  return {residual_, iterations, sets, products_, approach_};
}

double ContactSolver::residual_of(Prescribed prescribed, double value, std::span<double> pressure) {
  begin(prescribed, value, pressure);
  form_displacement(prescribed, pressure);
  choose_set(true, pressure);
  return residual_;
}

double ContactSolver::stiffness(std::span<const double> pressure, double tolerance, int max_iterations,
                                const SolverObserver& observer) {
  std::vector<double> q(grid_.size());
  std::ranges::fill(g_, -1.);
  std::ranges::transform(pressure, on_.begin(), [](double p) { return p > 0 ? 1. : 0.; });
  std::ranges::copy(on_, work_.begin());
  set_size_ = std::accumulate(on_.begin(), on_.end(), 0.);
  set_residual_ = 1;
  for (int iteration = 0; set_residual_ > tolerance; ++iteration) {
    if (iteration == max_iterations) not_converged(grid_, set_residual_, tolerance, iteration);
    step(Prescribed::approach, iteration > 0, q);
    if (observer) observer({grid_, iteration + 1, set_residual_});
  }
  return std::accumulate(q.begin(), q.end(), 0.);
}

void ContactSolver::begin(Prescribed prescribed, double value, std::span<double> p) {
  pieces_.each([&](std::size_t i, std::size_t n) { std::fill_n(&on_[i], n, 0.); });
  approach_ = value;  // a given load forms it from the pressure
  if (prescribed == Prescribed::approach) return;
  const double sum = pieces_.total([&](std::size_t i, std::size_t n) { return kernels::sum(n, &p[i]); }).sums[0];
  pieces_.each([&](std::size_t i, std::size_t n) {
    if (sum > 0) {
      kernels::scale(n, value / sum, &p[i]);
    } else {
      std::fill_n(&p[i], n, value / static_cast<double>(p.size()));
    }
  });
}

// g becomes u_z; the approach that a given load starts from is the mean over the pressure.
void ContactSolver::form_displacement(Prescribed prescribed, std::span<const double> p) {
  product_.apply(p.data(), g_.data(), workers_);
  ++products_;
  if (prescribed == Prescribed::approach) return;
  const auto [moment, sum] = first_two(
      pieces_.total([&](std::size_t i, std::size_t n) { return kernels::weighted_gap(n, &p[i], &g_[i], &gap_[i]); }));
  approach_ = moment / sum;
}

// Forms g from u_z if that is fresh, A and the residual; true if A is another set than before.
bool ContactSolver::choose_set(bool fresh, std::span<const double> p) {
  const Tally tally = pieces_.total([&](std::size_t i, std::size_t n) {
    return kernels::choose_set(n, fresh ? 1 : 0, approach_, least_gap_, &gap_[i], &p[i], &g_[i], &on_[i], &work_[i]);
  });
  const auto [changes, size, pressed_squares, pressed, squares, heights, height_squares] = tally.sums;
  const double mean = heights / size;
  scale_ = std::max(std::abs(approach_ - least_gap_), std::sqrt(std::max(0., height_squares / size - mean * mean)));
  set_size_ = size;
  set_residual_ = std::sqrt(squares / size);
  const double worst = std::max(pressed > 0 ? std::sqrt(pressed_squares / pressed) : 0, tally.largest);
  residual_ = worst == 0 ? 0 : worst / scale_;  // not a number stays so, and is no convergence
  return changes > 0;
}

// One step of conjugate gradients in A. A given load: the gradient is shifted by the change of the approach that keeps
// the sum of the direction at zero.
void ContactSolver::step(Prescribed prescribed, bool with_last_direction, std::span<double> p) {
  apply_preconditioner(work_.data(), work_.data());
  double shift = 0;
  if (prescribed == Prescribed::load) {
    const Tally tally =
        pieces_.total([&](std::size_t i, std::size_t n) { return kernels::masked_sum(n, &on_[i], &work_[i]); });
    shift = tally.sums[0] / uniform_sum_;
    approach_ -= shift;
  }
  const double last = residual_product_;
  residual_product_ = pieces_
                          .total([&](std::size_t i, std::size_t n) {
                            return kernels::project(n, shift, uniform_.data() + i, &on_[i], &g_[i], &work_[i]);
                          })
                          .sums[0];
  const double beta = with_last_direction ? residual_product_ / last : 0;
  pieces_.each([&](std::size_t i, std::size_t n) { kernels::turn(n, beta, &work_[i], &direction_[i]); });

  product_.apply(direction_.data(), work_.data(), workers_);
  ++products_;
  const auto [slope, curvature] = first_two(pieces_.total(
      [&](std::size_t i, std::size_t n) { return kernels::slopes(n, &direction_[i], &g_[i], &work_[i]); }));
  const double length = curvature > 0 ? slope / curvature : 0;  // no direction is left in a set of one cell
  const Tally tally = pieces_.total([&](std::size_t i, std::size_t n) {
    return kernels::advance(n, length, shift, &direction_[i], &on_[i], &p[i], &g_[i], &work_[i]);
  });
  set_residual_ = std::sqrt(tally.sums[0] / set_size_);
}

// Negative pressure becomes none, and the load is restored; true if p was changed.
bool ContactSolver::cut(Prescribed prescribed, double load, std::span<double> p) {
  const auto [negative, sum] =
      first_two(pieces_.total([&](std::size_t i, std::size_t n) { return kernels::cut(n, &p[i]); }));
  if (negative > 0 && prescribed == Prescribed::load) {
    pieces_.each([&, factor = load / sum](std::size_t i, std::size_t n) { kernels::scale(n, factor, &p[i]); });
  }
  return negative > 0;
}

void ContactSolver::apply_preconditioner(const double* r, double* Mr) {
  preconditioner_.apply(r, Mr, workers_);
  products_ += surface_ == Surface::free ? 0.25 : 1;
}

void ContactSolver::prepare_load_projection() {
  apply_preconditioner(on_.data(), uniform_.data());
  uniform_sum_ =
      pieces_.total([&](std::size_t i, std::size_t n) { return kernels::mask(n, &on_[i], &uniform_[i]); }).sums[0];
}

}  // namespace patchgrip::contact
