#include <patchgrip/grasp/grip_solver.h>

#include <algorithm>

namespace patchgrip::grasp {

GripSolver::GripSolver(const ScaledGrasp& grasp, const GripSettings& settings)
    : grasp_(&grasp),
      settings_(settings),
      interior_(grasp),
      polish_(grasp),
      path_(polish_.solution_size()),
      extended_(grasp),
      quadratic_(grasp),
      bracket_(grasp),
      forces_(grasp.parts().size()) {}

bool GripSolver::cannot() const noexcept {
  const bool bounded = problem_.objective == Objective::max_force || problem_.objective == Objective::total_force;
  return bounded && bracket_.lower() > settings_.force_limit;
}

bool GripSolver::decided() const noexcept {
  return cannot() || (bracket_.upper() <= settings_.force_limit && bracket_.charged() <= largest_charge);
}

void GripSolver::solve(const GripProblem& problem, bool warm) noexcept {
  const bool follows = warm && polished_ && problem.objective == problem_.objective;
  if (!follows || effort_.repairs > 0) path_.forget();  // other states
  if (follows) polish_.solution(path_.add(problem_.load));
  problem_ = problem;
  bracket_.reset(problem);
  effort_ = {};
  if (problem.objective != Objective::load_factor && problem.load.isZero(0)) {
    std::ranges::fill(forces_, PartForce{});
    bracket_.add_forces(forces_, 0);
    polished_ = false;
    effort_.route = Route::no_load;
    return;
  }
  if (follows && try_warm()) return;
  polished_ = false;
  path_.forget();
  if (grasp_->rank() < 6 && problem.objective != Objective::distance) {
    const Vector6 off =
        grasp_->unresisted() * (problem.objective == Objective::load_factor ? problem.step : problem.load);
    if (off.norm() > 100 * grasp_->rounding()) {
      bracket_.add_twist(off);
      effort_.route = Route::range;
      if (cannot()) return;
    }
  }
  solve_conic();
  const bool sized = problem.objective == Objective::max_force || problem.objective == Objective::total_force;
  if (sized && !closed() && !cannot()) bracket_extended();
  if (sized && !decided()) bracket_quadratic();
}

// Patches quickly first; with care where that does not do.
void GripSolver::solve_conic() noexcept {
  if (interior_.has_patches()) {
    solve_conic(1e-2);
    if (closed() || cannot()) return;
  }
  solve_conic(1e-4);
}

void GripSolver::solve_conic(double settled_gap) noexcept {
  using Status = InteriorPoint::Status;
  interior_.start(problem_, settled_gap);
  const int before = effort_.iterations;
  double tolerance = settings_.interior_tolerance / static_cast<double>(grasp_->contacts()), ray_tolerance = 0.1;
  for (int attempt = 0; attempt < 5; ++attempt, tolerance *= 1e-2) {
    Status status = Status::infeasible;
    while (status == Status::infeasible && ray_tolerance > 1e-2 * tolerance) {
      status = interior_.run(tolerance, ray_tolerance, settings_.max_iterations);
      effort_.iterations = before + interior_.iterations();
      if (status != Status::infeasible) break;
      bracket_.add_twist(interior_.twist());
      effort_.route = Route::ray;
      if (cannot()) return;
      ray_tolerance *= 1e-2;
    }
    if (status == Status::infeasible) continue;
    polish_.identify(problem_, interior_);
    effort_.route = Route::polished;
    polish(settings_.max_repairs);
    if (closed()) return;
    bracket_interior();
    if (closed()) {
      effort_.route = Route::interior;
      return;
    }
    if (status == Status::stalled) return;
  }
}

// A bracket that closes is the best proof that the guess was right.
void GripSolver::polish(int max_repairs) noexcept {
  polished_ = polish_.converge(problem_);
  bracket_polish();
  if (polished_ && !closed()) {
    polished_ = polish_.run(problem_, max_repairs);
    if (polish_.repairs() > 0) bracket_polish();
  }
  effort_.newton_steps += polish_.steps();
  effort_.repairs += polish_.repairs();
}

bool GripSolver::try_warm() noexcept {
  polish_.restart(path_.lead(problem_.load));
  effort_.route = Route::warm;
  polish(4);
  if (closed()) return true;
  bracket_.reset(problem_);
  return false;
}

void GripSolver::bracket_polish() noexcept {
  if (!polish_.twist().allFinite()) return;
  bracket_.add_twist(polish_.twist());
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const PartState& state = polish_.parts()[i];
    const Element& element = grasp_->parts()[i].element;
    forces_[i] = {};
    if (!state.active) continue;
    const bool slips = state.slide == Slide::slips;
    // Rounding leaves a free force that is 0 a little on the wrong side.
    const double force = std::max(state.force, 0.0);
    if (element.kind() == Element::Kind::normal) {
      forces_[i].force = force;
    } else if (slips) {
      forces_[i] = {force, -element.mu() * force * element.gradient(state.v), true};
    } else {
      forces_[i] = {force, state.friction, false};
    }
  }
  bracket_.add_forces(forces_, polish_.value());
}

void GripSolver::bracket_extended() noexcept {
  if (effort_.newton_steps == 0) return;  // there are no states to refine
  if (extended_.run(problem_, polish_, bracket_)) effort_.route = Route::extended;
}

void GripSolver::bracket_quadratic() noexcept {
  quadratic_.solve(problem_.load, {}, settings_.max_iterations, settings_.force_limit);
  effort_.route = Route::quadratic;
  effort_.newton_steps += quadratic_.iterations();
  bracket_.add_twist(quadratic_.twist());
  bracket_.add_forces(quadratic_.forces(), 0);
  constexpr int most_steps = 6;
  Vector6 certificate = quadratic_.twist();
  for (int step = 0; step < most_steps && !decided() && quadratic_.sharpen(certificate); ++step) {
    bracket_.add_twist(certificate);
  }
}

void GripSolver::bracket_interior() noexcept {
  bracket_.add_twist(interior_.twist());
  if (!interior_.balance()) return;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const InteriorPoint::PartPoint p = interior_.part(i);
    const Element& element = grasp_->parts()[i].element;
    forces_[i] = {std::max(p.force, 0.0), p.friction, false};
    if (element.kind() == Element::Kind::normal) forces_[i].friction.setZero();
  }
  bracket_.add_forces(forces_, interior_.value());
}

}  // namespace patchgrip::grasp
