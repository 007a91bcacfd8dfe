// A claim held against finite elements.
//
// Verdict  agrees, or differs, where FE's error allows to tell; else cannot_judge: FE's error exceeds the tolerance, or
//          the difference that is claimed. What is claimed to agree must not differ; a claimed difference must be seen.
// Throws   std::runtime_error where FE found another number of values, or one that is not finite: a maximum would pass
//          over it.
#pragma once

#include <string_view>
#include <vector>

#include <patchgrip/verification/claims/claim.h>

namespace patchgrip::verification {

enum class Verdict { agrees, differs, cannot_judge };

struct Comparison {
  Quantity quantity;
  std::vector<double> fe;  // on the finest mesh
  std::vector<double> fe_error;
  double difference;      // relative to the scale, the largest
  double relative_error;  // of FE, relative to the scale, the largest
  double order;           // observed; NaN where it was not
  Verdict verdict;

  bool is_as_claimed() const noexcept {
    return quantity.claim == Claim::agrees ? verdict != Verdict::differs : verdict == Verdict::differs;
  }
};

Comparison compare(const Quantity& quantity, const std::vector<double>& fe, const std::vector<double>& fe_error,
                   double order);

void require_complete(const Quantity& quantity, const std::vector<double>& fe);

// Their absolute values' largest; absolute differences, element by element.
double largest_of(const std::vector<double>& values);
std::vector<double> distances(const std::vector<double>& one, const std::vector<double>& other);

std::string_view name_of(Verdict verdict);

}  // namespace patchgrip::verification
