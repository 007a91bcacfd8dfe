// What the library says about a case, and how near a finite-element solution should come to it.
//
// A quantity is one number or a history of numbers; differences are taken relative to its scale:
//
//     difference = max_k |fe_k - library_k| / scale
//
// The tolerance comes with its reason. Where the claim is that both differ (a model outside its domain, an equation of
// the seed that is wrong), the difference has to exceed FE's own error, and the tolerance is not asked for.
#pragma once

#include <string>
#include <vector>

namespace patchgrip::verification {

enum class Claim { agrees, differs };

struct Quantity {
  std::string name;
  std::string unit;
  std::vector<double> library;
  double scale;
  double tolerance;
  std::string reason;
  Claim claim = Claim::agrees;
};

// A number, relative to itself.
inline Quantity number(std::string name, std::string unit, double library, double tolerance, std::string reason) {
  return {std::move(name), std::move(unit), {library}, library, tolerance, std::move(reason)};
}

// The L2 distance of FE's pressure from the library's, over the L2 norm of that.
inline Quantity pressure_distance(double tolerance, std::string reason) {
  return {"pressure, L2 distance", "1", {0}, 1, tolerance, std::move(reason)};
}

}  // namespace patchgrip::verification
