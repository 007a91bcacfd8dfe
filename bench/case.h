// One row of the benchmark: a method on a patch over a set of poles, the error it makes there, and what is timed.
//
// Every scalar method is called alike, through evaluate(): an function of patch and twist that is not inlined.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <patchgrip/bench/truth.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::bench {

struct Label {
  std::string method;
  double parameter;  // what the method can be tuned by: points a side, tolerance; 0 if nothing
  std::string patch;
  std::string mix;

  bool operator==(const Label&) const = default;
};

struct Case {
  Label label;
  WorstError error;
  std::size_t judged;          // poles that the error was taken over; 0 if it was not
  std::size_t evaluations;     // in one pass
  std::function<void()> pass;  // what is timed
};

template <class P>
[[gnu::noinline]] friction::Wrench evaluate(const P& patch, const friction::Twist& v) noexcept {
  return patch.gradient(v);
}

// `truth` belongs to the first of `twists`.
template <class P>
Case scalar_case(Label label, std::shared_ptr<const P> patch,
                 const std::shared_ptr<const std::vector<friction::Twist>>& twists, const Truth& truth,
                 double scale_radius) {
  std::vector<friction::Wrench> computed;
  for (const auto& v : std::span(*twists).first(truth.size())) computed.push_back(evaluate(*patch, v));
  return {std::move(label), worst_error(truth, computed, scale_radius), truth.size(), twists->size(), [patch, twists] {
            for (const auto& v : *twists) {
              friction::Wrench g = evaluate(*patch, v);
              benchmark::DoNotOptimize(g);
            }
          }};
}

}  // namespace patchgrip::bench
