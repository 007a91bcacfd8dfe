// A motion y' = f(t, y), or F(t, y, y') = 0, and the times at which something changes sign, by SUNDIALS 6: what
// dynamics/trajectory.h does, and called as it is.
//
//     bdf               CVODE, variable order, Newton's method on a dense Jacobian of difference quotients
//     adams             CVODE, variable order, functional iteration
//     dormand_prince    ARKODE, explicit Runge-Kutta of order 5(4)
//     kvaerno           ARKODE, diagonally implicit Runge-Kutta of order 5(4), Newton's method as of bdf, with a new
//                       Jacobian at every step: with an old one it takes errors beyond a kink for solved
//     of a residual F   IDA, BDF of variable order, Newton's method as of bdf; y' at the start of a run by its own
//                       search, from y' = 0. dF/dy' regular
//
// All else as SUNDIALS sets it, but for the tolerance, relative and absolute, and for the number of steps. Steps do not
// pass the end of a run.
//
// Throws   std::runtime_error where SUNDIALS gives up.
#pragma once

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <ida/ida.h>
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

enum class SundialsMethod { bdf, adams, dormand_prince, kvaerno };

template <std::size_t n>
class SundialsFlow {
 public:
  using State = std::array<double, n>;
  using Rates = std::function<void(double t, const State& y, State& rates)>;
  using Residual = std::function<void(double t, const State& y, const State& rates, State& residual)>;
  using Watched = std::function<double(double t, const State& y)>;

  SundialsFlow(SundialsMethod method, Rates rates, const State& start, double t, double tolerance)
      : SundialsFlow(calls_of(method), start, t) {
    rates_ = std::move(rates);
    switch (method) {
      case SundialsMethod::bdf:
      case SundialsMethod::adams:
        memory_.reset(CVodeCreate(method == SundialsMethod::bdf ? CV_BDF : CV_ADAMS, context_));
        check(CVodeInit(memory_.get(), &SundialsFlow::rates_of, t, y_.get()));
        break;
      case SundialsMethod::dormand_prince:
        memory_.reset(ERKStepCreate(&SundialsFlow::rates_of, t, y_.get(), context_));
        check(ERKStepSetTableNum(memory_.get(), ARKODE_DORMAND_PRINCE_7_4_5));
        break;
      case SundialsMethod::kvaerno:
        memory_.reset(ARKStepCreate(nullptr, &SundialsFlow::rates_of, t, y_.get(), context_));
        check(ARKStepSetTableNum(memory_.get(), ARKODE_KVAERNO_7_4_5, ARKODE_ERK_NONE));
        break;
    }
    set_up(tolerance);
    if (method == SundialsMethod::bdf || method == SundialsMethod::kvaerno) set_newton();
    if (method == SundialsMethod::kvaerno) {
      check(ARKStepSetLSetupFrequency(memory_.get(), 1));
      check(ARKStepSetJacEvalFrequency(memory_.get(), 1));
    }
    if (method == SundialsMethod::adams) {
      iteration_.reset(SUNNonlinSol_FixedPoint(y_.get(), 0, context_));
      check(CVodeSetNonlinearSolver(memory_.get(), iteration_.get()));
    }
  }
  SundialsFlow(Residual residual, const State& start, double t, double tolerance) : SundialsFlow(ida, start, t) {
    residual_ = std::move(residual);
    dy_.reset(N_VClone(y_.get()));
    N_VConst(0, dy_.get());
    memory_.reset(IDACreate(context_));
    check(IDAInit(memory_.get(), &SundialsFlow::residual_of, t, y_.get(), dy_.get()));
    set_up(tolerance);
    set_newton();
    const Owned<N_Vector> differential(N_VClone(y_.get()));
    N_VConst(1, differential.get());
    check(IDASetId(memory_.get(), differential.get()));
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
    if (dy_) find_rates(end);
    check(calls_.watch(memory, static_cast<int>(watched_.size())));
    check(calls_.stop_at(memory, end));
    std::vector<int> roots(watched_.size());
    while (t_ < end) {
      const int answer = calls_.go_on(*this, end);
      check(answer);
      if (answer != root_return) continue;
      check(calls_.roots(memory, roots.data()));
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

  // What the packages name each for itself.
  struct Calls {
    int (*tolerance)(void* memory, double relative, double absolute);
    int (*user_data)(void* memory, void* user);
    int (*most_steps)(void* memory, long count);
    int (*newton)(void* memory, SUNLinearSolver solver, SUNMatrix jacobian);
    int (*watch)(void* memory, int count);
    int (*stop_at)(void* memory, double end);
    int (*go_on)(SundialsFlow& flow, double end);
    int (*roots)(void* memory, int* found);
    void (*free)(void** memory);
  };
  static constexpr Calls cvode{
      CVodeSStolerances,
      CVodeSetUserData,
      CVodeSetMaxNumSteps,
      CVodeSetLinearSolver,
      [](void* memory, int count) { return CVodeRootInit(memory, count, &SundialsFlow::watched_of); },
      CVodeSetStopTime,
      [](SundialsFlow& f, double end) { return CVode(f.memory_.get(), end, f.y_.get(), &f.t_, CV_NORMAL); },
      CVodeGetRootInfo,
      CVodeFree};
  static constexpr Calls erkstep{
      ERKStepSStolerances,
      ERKStepSetUserData,
      ERKStepSetMaxNumSteps,
      nullptr,
      [](void* memory, int count) { return ERKStepRootInit(memory, count, &SundialsFlow::watched_of); },
      ERKStepSetStopTime,
      [](SundialsFlow& f, double end) { return ERKStepEvolve(f.memory_.get(), end, f.y_.get(), &f.t_, ARK_NORMAL); },
      ERKStepGetRootInfo,
      ERKStepFree};
  static constexpr Calls arkstep{
      ARKStepSStolerances,
      ARKStepSetUserData,
      ARKStepSetMaxNumSteps,
      ARKStepSetLinearSolver,
      [](void* memory, int count) { return ARKStepRootInit(memory, count, &SundialsFlow::watched_of); },
      ARKStepSetStopTime,
      [](SundialsFlow& f, double end) { return ARKStepEvolve(f.memory_.get(), end, f.y_.get(), &f.t_, ARK_NORMAL); },
      ARKStepGetRootInfo,
      ARKStepFree};
  static constexpr Calls ida{
      IDASStolerances,
      IDASetUserData,
      IDASetMaxNumSteps,
      IDASetLinearSolver,
      [](void* memory, int count) { return IDARootInit(memory, count, &SundialsFlow::implicit_watched_of); },
      IDASetStopTime,
      [](SundialsFlow& f, double end) {
        return IDASolve(f.memory_.get(), end, &f.t_, f.y_.get(), f.dy_.get(), IDA_NORMAL);
      },
      IDAGetRootInfo,
      IDAFree};
  static constexpr int root_return = CV_ROOT_RETURN;
  static_assert(root_return == ARK_ROOT_RETURN && root_return == IDA_ROOT_RETURN);

  static constexpr const Calls& calls_of(SundialsMethod method) {
    if (method == SundialsMethod::dormand_prince) return erkstep;
    return method == SundialsMethod::kvaerno ? arkstep : cvode;
  }

  struct FreeMemory {
    void (*free)(void**);
    void operator()(void* memory) const { free(&memory); }
  };

  SundialsFlow(const Calls& calls, const State& start, double t)
      : calls_(calls), t_(t), y_(N_VNew_Serial(n, context_)), memory_(nullptr, FreeMemory{calls.free}) {
    std::ranges::copy(start, N_VGetArrayPointer(y_.get()));
  }

  void set_up(double tolerance) {
    constexpr long most_steps = 100'000'000;
    check(calls_.tolerance(memory_.get(), tolerance, tolerance));
    check(calls_.user_data(memory_.get(), this));
    check(calls_.most_steps(memory_.get(), most_steps));
  }
  void set_newton() {
    matrix_.reset(SUNDenseMatrix(n, n, context_));
    linear_.reset(SUNLinSol_Dense(y_.get(), matrix_.get(), context_));
    check(calls_.newton(memory_.get(), linear_.get(), matrix_.get()));
  }
  void find_rates(double end) {
    check(IDAReInit(memory_.get(), t_, y_.get(), dy_.get()));
    check(IDACalcIC(memory_.get(), IDA_YA_YDP_INIT, end));
    check(IDAGetConsistentIC(memory_.get(), y_.get(), dy_.get()));
  }

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
  static int residual_of(double t, N_Vector v, N_Vector dv, N_Vector out, void* self) {
    SundialsFlow& me = *static_cast<SundialsFlow*>(self);
    ++me.evaluations_;
    State residual;
    me.residual_(t, state_of(v), state_of(dv), residual);
    std::ranges::copy(residual, N_VGetArrayPointer(out));
    return 0;
  }
  static int watched_of(double t, N_Vector v, double* out, void* self) {
    const SundialsFlow& me = *static_cast<SundialsFlow*>(self);
    const State y = state_of(v);
    for (const Watched& w : me.watched_) *out++ = w(t, y);
    return 0;
  }
  static int implicit_watched_of(double t, N_Vector v, N_Vector, double* out, void* self) {
    return watched_of(t, v, out, self);
  }

  sundials::Context context_;
  const Calls& calls_;
  Rates rates_;
  Residual residual_;
  std::vector<Watched> watched_;
  double t_;
  long evaluations_ = 0;
  Owned<N_Vector> y_, dy_;
  Owned<SUNMatrix> matrix_;
  Owned<SUNLinearSolver> linear_;
  Owned<SUNNonlinearSolver> iteration_;
  std::unique_ptr<void, FreeMemory> memory_;  // freed before what it uses
};

}  // namespace patchgrip::bench
