#include <patchgrip/bench/hertz_cases.h>

#include <algorithm>

#include <patchgrip/bench/batch_cases.h>
#include <patchgrip/bench/gsl_quadrature.h>
#include <patchgrip/bench/naive_sum.h>
#include <patchgrip/bench/poles.h>
#include <patchgrip/bench/textbook_form.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/seed_hertz_disc.h>

namespace patchgrip::bench {
namespace {

constexpr double radius = 5e-3;  // m

// One set of poles with its truth, and a case for every method that is to work on it.
class HertzBench {
 public:
  HertzBench(const PoleSet& poles, std::size_t judged)
      : mix_(poles.mix),
        twists_(twists_about(poles)),
        truth_(power_disc_truth(radius, 1, std::span(twists_).first(judged))) {}

  // Over the first `count` poles.
  template <class P, class... Arguments>
  Case run(std::string method, double parameter, std::size_t count, Arguments&&... arguments) const {
    const auto n = static_cast<std::ptrdiff_t>(std::min(count, twists_.size()));
    const auto judged = static_cast<std::ptrdiff_t>(std::min(count, truth_.size()));
    return scalar_case<P>({std::move(method), parameter, "hertz_disc", mix_},
                          std::make_shared<const P>(P{std::forward<Arguments>(arguments)...}),
                          std::make_shared<const std::vector<friction::Twist>>(twists_.begin(), twists_.begin() + n),
                          {truth_.begin(), truth_.begin() + judged}, radius);
  }

  Case exact(std::size_t count) const {
    return run<friction::HertzDisc>("exact", 0, count, friction::HertzDisc::of_radius(radius));
  }
  Case seed_polynomial(std::size_t count) const {
    return run<friction::SeedHertzDisc>("seed_polynomial", 0, count, friction::SeedHertzDisc::of_radius(radius));
  }
  Case naive_sum(int n, std::size_t count) const { return run<NaiveSum>("naive_sum", n, count, radius, n); }
  Case quadrature(double tolerance, std::size_t count) const {
    return run<GslQuadrature>("gsl_quadrature", tolerance, count, radius, tolerance);
  }

 private:
  std::string mix_;
  std::vector<friction::Twist> twists_;
  Truth truth_;
};

}  // namespace

std::vector<Case> hertz_cases() {
  constexpr std::size_t fast = 65536;  // too many for a branch predictor to learn
  std::vector<Case> cases;
  for (const PoleSet& poles :
       {mixed_poles(radius, fast), inside_poles(radius, fast), outside_poles(radius, fast), rim_poles(radius, fast)}) {
    const HertzBench bench(poles, 2000);
    cases.push_back(bench.exact(fast));
    cases.push_back(bench.seed_polynomial(fast));
    cases.push_back(bench.naive_sum(21, 2048));
    cases.push_back(bench.quadrature(1e-10, 12));
  }
  return cases;
}

std::vector<Case> work_precision_cases() {
  constexpr std::size_t fast = 16384;
  constexpr std::size_t judged = 500;
  const PoleSet poles = near_poles(radius, fast);
  const HertzBench bench(poles, judged);
  std::vector<Case> cases{bench.exact(fast), bench.seed_polynomial(fast)};
  cases.push_back(bench.run<friction::PowerDisc>("table", 0, fast, friction::PowerDisc::of_radius(radius, 1)));
  cases.push_back(bench.run<TextbookForm>("textbook", 0, fast, radius));
  cases.push_back(hertz_batch_case(radius, poles.first(1024), judged));
  for (const int n : {5, 7, 11, 15, 21, 31, 45, 65, 101, 141, 201}) cases.push_back(bench.naive_sum(n, judged));
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    cases.push_back(bench.quadrature(tolerance, 12));
  }
  return cases;
}

}  // namespace patchgrip::bench
