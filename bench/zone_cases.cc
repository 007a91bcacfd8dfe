#include <patchgrip/bench/zone_cases.h>

#include <algorithm>
#include <concepts>

#include <patchgrip/bench/patches.h>
#include <patchgrip/bench/reference_truth.h>
#include <patchgrip/bench/zone_quadrature.h>
#include <patchgrip/friction/sampled/pressure_grid.h>
#include <patchgrip/friction/seed_hertz_disc.h>

namespace patchgrip::bench {
namespace {

using Twists = std::shared_ptr<const std::vector<friction::Twist>>;

// One patch with one set of poles.
class Bench {
 public:
  Bench(std::string patch, const PoleSet& poles, const friction::Gradient50& gradient, std::size_t judged, double scale)
      : patch_(std::move(patch)),
        mix_(poles.mix),
        twists_(twists_about(poles)),
        truth_(reference_truth(gradient, std::span(twists_).first(judged))),
        scale_(scale) {}

  // Over the first `count` poles.
  template <class P>
  Case run(const std::string& method, double parameter, std::size_t count, std::shared_ptr<const P> patch) const {
    const auto n = static_cast<std::ptrdiff_t>(count), judged = std::min(n, std::ssize(truth_));
    return scalar_case<P>({method, parameter, patch_, mix_}, std::move(patch),
                          std::make_shared<const std::vector<friction::Twist>>(twists_.begin(), twists_.begin() + n),
                          {truth_.begin(), truth_.begin() + judged}, scale_);
  }

 private:
  std::string patch_, mix_;
  std::vector<friction::Twist> twists_;
  Truth truth_;
  double scale_;
};

template <class P, class... Arguments>
std::shared_ptr<const P> shared(Arguments&&... arguments) {
  return std::make_shared<const P>(std::forward<Arguments>(arguments)...);
}

}  // namespace

std::vector<Case> zone_cases() {
  constexpr std::size_t fast = 4096, slow = 300, slowest = 4;
  std::vector<Case> cases;
  const auto visit = [&]<class P>(const std::string& name, const P& patch, const Zone& zone,
                                  const friction::Gradient50& gradient, std::size_t judged) {
    std::vector<Bench> benches;
    for (const PoleSet& poles : poles_about(zone, fast)) {
      benches.emplace_back(name, poles, gradient, judged, patch.gradient({0, 0, 1}).m);
    }
    const auto add = [&]<class Q>(const std::string& method, double parameter, std::size_t count,
                                  const std::shared_ptr<const Q>& other) {
      for (const Bench& bench : benches) cases.push_back(bench.run(method, parameter, count, other));
    };
    add("exact", 0, fast, shared<P>(patch));
    if constexpr (std::same_as<P, friction::HertzDisc>) {
      add("seed_polynomial", 0, fast,
          shared<friction::SeedHertzDisc>(friction::SeedHertzDisc::of_radius(patch.radius())));
    }
    for (const std::size_t n : {21UL, 41UL, 81UL}) {
      add("point_sum", static_cast<double>(n), slow, shared<PointSum>(point_sum(zone, n)));
      if (zone.strips.empty()) continue;
      add("sampled", static_cast<double>(n), slow,
          shared<friction::PressureGrid>(friction::PressureGrid::exact(cells_of(zone, n))));
    }
    for (const double tolerance : {1e-3, 1e-6}) {
      add("gsl_quadrature", tolerance, slowest, shared<ZoneQuadrature>(zone, tolerance));
    }
  };
  for_every_round_patch(visit);
  for_every_other_patch(visit);
  return cases;
}

}  // namespace patchgrip::bench
