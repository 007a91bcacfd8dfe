// gsl_integration_qags (QUADPACK) of any function, its workspaces freed by themselves.
#pragma once

#include <gsl/gsl_integration.h>

#include <cstddef>
#include <memory>

namespace patchgrip::bench {

struct FreeWorkspace {
  void operator()(gsl_integration_workspace* w) const noexcept { gsl_integration_workspace_free(w); }
};
using GslWorkspace = std::unique_ptr<gsl_integration_workspace, FreeWorkspace>;

constexpr std::size_t gsl_intervals = 2000;

inline GslWorkspace gsl_workspace() { return GslWorkspace(gsl_integration_workspace_alloc(gsl_intervals)); }

// The tolerance is absolute and relative: what is met first ends the quadrature. Where rounding ends the refinement,
// the value is kept as it is: call gsl_set_error_handler_off() before.
template <class F>
double adaptive(const F& f, double from, double to, double tolerance, const GslWorkspace& workspace) {
  gsl_function function{[](double x, void* self) { return (*static_cast<const F*>(self))(x); }, const_cast<F*>(&f)};
  double value = 0;
  double error = 0;
  gsl_integration_qags(&function, from, to, tolerance, tolerance, gsl_intervals, workspace.get(), &value, &error);
  return value;
}

}  // namespace patchgrip::bench
