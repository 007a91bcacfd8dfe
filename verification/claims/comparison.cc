#include <patchgrip/verification/claims/comparison.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace patchgrip::verification {

double largest_of(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::fabs(value));
  return most;
}

std::vector<double> distances(const std::vector<double>& one, const std::vector<double>& other) {
  std::vector<double> apart(one.size());
  for (std::size_t k = 0; k < one.size(); ++k) apart[k] = std::fabs(one[k] - other[k]);
  return apart;
}

void require_complete(const Quantity& quantity, const std::vector<double>& fe) {
  const std::size_t count = quantity.library.size();
  if (fe.size() != count) {
    throw std::runtime_error("of '" + quantity.name + "' " + std::to_string(fe.size()) + " values were found, not " +
                             std::to_string(count));
  }
  if (!std::all_of(fe.begin(), fe.end(), [](double x) { return std::isfinite(x); })) {
    throw std::runtime_error("'" + quantity.name + "' is not finite");
  }
}

Comparison compare(const Quantity& quantity, const std::vector<double>& fe, const std::vector<double>& fe_error,
                   double order) {
  require_complete(quantity, fe);
  require_complete(quantity, fe_error);
  Comparison c{quantity,
               fe,
               fe_error,
               largest_of(distances(fe, quantity.library)) / quantity.scale,
               largest_of(fe_error) / quantity.scale,
               order,
               Verdict::cannot_judge};
  if (quantity.claim == Claim::differs) {
    if (c.difference > c.relative_error) c.verdict = Verdict::differs;
  } else if (c.relative_error <= quantity.tolerance) {
    c.verdict = c.difference <= quantity.tolerance ? Verdict::agrees : Verdict::differs;
  } else if (c.difference > quantity.tolerance + c.relative_error) {
    c.verdict = Verdict::differs;
  }
  return c;
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::agrees:
      return "agrees";
    case Verdict::differs:
      return "differs";
    default:
      return "cannot judge";
  }
}

}  // namespace patchgrip::verification
