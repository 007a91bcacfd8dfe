// A motion y' = f(t, y) and the times at which something changes sign, by SUNDIALS 6: what dynamics/trajectory.h does,
// and called as it is.
//
//     bdf               CVODE, variable order, Newton's method on a dense Jacobian of difference quotients
//     adams             CVODE, variable order, functional iteration
//     dormand_prince    ARKODE, explicit Runge-Kutta of order 5(4)
//
// All as SUNDIALS sets them, but for the tolerance, relative and absolute, and for the number of steps. Steps do not
// pass the end of a run.
//
// Throws   std::runtime_error where SUNDIALS gives up.
#pragma once

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace patchgrip::bench {

enum class SundialsMethod { bdf, adams, dormand_prince };

template <std::size_t n>
class SundialsFlow {
 public:
  using State = std::array<double, n>;
  using Rates = std::function<void(double t, const State& y, State& rates)>;
  using Watched = std::function<double(double t, const State& y)>;

  SundialsFlow(SundialsMethod method, Rates rates, const State& start, double t, double tolerance)
      : explicit_(method == SundialsMethod::dormand_prince),
        rates_(std::move(rates)),
        t_(t),
        y_(N_VNew_Serial(n, context_)),
        memory_(nullptr, explicit_ ? &free_arkode : &free_cvode) {
    constexpr long most_steps = 100'000'000;
    std::ranges::copy(start, N_VGetArrayPointer(y_.get()));
    if (explicit_) {
      memory_.reset(ERKStepCreate(&SundialsFlow::rates_of, t, y_.get(), context_));
      check(ERKStepSetTableNum(memory_.get(), ARKODE_DORMAND_PRINCE_7_4_5));
      check(ERKStepSStolerances(memory_.get(), tolerance, tolerance));
      check(ERKStepSetUserData(memory_.get(), this));
      check(ERKStepSetMaxNumSteps(memory_.get(), most_steps));
      return;
    }
    memory_.reset(CVodeCreate(method == SundialsMethod::bdf ? CV_BDF : CV_ADAMS, context_));
    check(CVodeInit(memory_.get(), &SundialsFlow::rates_of, t, y_.get()));
    check(CVodeSStolerances(memory_.get(), tolerance, tolerance));
    check(CVodeSetUserData(memory_.get(), this));
    check(CVodeSetMaxNumSteps(memory_.get(), most_steps));
    if (method == SundialsMethod::bdf) {
      matrix_.reset(SUNDenseMatrix(n, n, context_));
      linear_.reset(SUNLinSol_Dense(y_.get(), matrix_.get(), context_));
      check(CVodeSetLinearSolver(memory_.get(), linear_.get(), matrix_.get()));
    } else {
      iteration_.reset(SUNNonlinSol_FixedPoint(y_.get(), 0, context_));
      check(CVodeSetNonlinearSolver(memory_.get(), iteration_.get()));
    }
  }
  SundialsFlow(const SundialsFlow&) = delete;
  SundialsFlow& operator=(const SundialsFlow&) = delete;

  void watch(Watched function) { watched_.push_back(std::move(function)); }

  State state() const { return state_of(y_.get()); }
  double time() const noexcept { return t_; }
  long evaluations() const noexcept { return evaluations_; }

  template <class AtEvent>
  bool run(double end, const AtEvent& at_event) {
    void* const memory = memory_.get();
    const int count = static_cast<int>(watched_.size());
    check(explicit_ ? ERKStepRootInit(memory, count, &SundialsFlow::watched_of)
                    : CVodeRootInit(memory, count, &SundialsFlow::watched_of));
    check(explicit_ ? ERKStepSetStopTime(memory, end) : CVodeSetStopTime(memory, end));
    std::vector<int> roots(watched_.size());
    while (t_ < end) {
      const int answer = explicit_ ? ERKStepEvolve(memory, end, y_.get(), &t_, ARK_NORMAL)
                                   : CVode(memory, end, y_.get(), &t_, CV_NORMAL);
      check(answer);
      if (answer != (explicit_ ? ARK_ROOT_RETURN : CV_ROOT_RETURN)) continue;
      check(explicit_ ? ERKStepGetRootInfo(memory, roots.data()) : CVodeGetRootInfo(memory, roots.data()));
      for (std::size_t i = 0; i < roots.size(); ++i) {
        if (roots[i] != 0 && at_event(t_, state(), i)) return true;
      }
    }
    return false;
  }

 private:
  struct Free {
    void operator()(N_Vector v) const { N_VDestroy(v); }
    void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
    void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
    void operator()(SUNNonlinearSolver s) const { SUNNonlinSolFree(s); }
  };
  template <class T>
  using Owned = std::unique_ptr<std::remove_pointer_t<T>, Free>;

  static void free_cvode(void* memory) { CVodeFree(&memory); }
  static void free_arkode(void* memory) { ERKStepFree(&memory); }

  static void check(int answer) {
    if (answer < 0) throw std::runtime_error("SUNDIALS gives up, by its code " + std::to_string(answer));
  }

  static State state_of(N_Vector v) {
    State y;
    std::copy_n(N_VGetArrayPointer(v), n, y.begin());
    return y;
  }
  static int rates_of(double t, N_Vector v, N_Vector out, void* self) {
    SundialsFlow& me = *static_cast<SundialsFlow*>(self);
    ++me.evaluations_;
    State rates;
    me.rates_(t, state_of(v), rates);
    std::ranges::copy(rates, N_VGetArrayPointer(out));
    return 0;
  }
  static int watched_of(double t, N_Vector v, double* out, void* self) {
    const SundialsFlow& me = *static_cast<SundialsFlow*>(self);
    const State y = state_of(v);
    for (const Watched& w : me.watched_) *out++ = w(t, y);
    return 0;
  }

  sundials::Context context_;
  bool explicit_;
  Rates rates_;
  std::vector<Watched> watched_;
  double t_;
  long evaluations_ = 0;
  Owned<N_Vector> y_;
  Owned<SUNMatrix> matrix_;
  Owned<SUNLinearSolver> linear_;
  Owned<SUNNonlinearSolver> iteration_;
  std::unique_ptr<void, void (*)(void*)> memory_;  // freed before what it uses
};

}  // namespace patchgrip::bench
