// Bounds of random sampled patches against 80 digits: PATCHGRIP_TEST_SCALE=250 draws 1e5 and more a kind.
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/friction/sampled_cases.h>
#include <patchgrip/tests/friction/sampled_reference.h>

namespace patchgrip::friction {
namespace {

using testing::cases;

struct Drawn {
  std::function<BoundedWrench(const Twist&)> computed;
  SampledReference exact;
  double x, y, radius;          // centroid, a_K
  std::vector<Pole> landmarks;  // corners and nodes
};

template <class P>
Drawn drawn(const P& patch, SampledReference exact, std::vector<Pole> landmarks) {
  const PressureMoments s = patch.moments();
  return {[patch](const Twist& v) { return patch.bounded_gradient(v); },
          std::move(exact),
          s.x,
          s.y,
          patch.area_radius(),
          std::move(landmarks)};
}

double pressure(std::mt19937_64& engine) {
  return engine() % 4 == 0 ? 0 : engine() % 2 == 0 ? uniform(engine, 0, 1) : log_uniform(engine, 1e-6, 1);
}

double offset(std::mt19937_64& engine) { return engine() % 2 == 0 ? 0 : uniform(engine, -30, 30); }

Drawn draw_grid(std::mt19937_64& engine) {
  const double size = log_uniform(engine, 1e-6, 1e2);
  const double aspect = log_uniform(engine, 0.05, 20);
  PressureCells cells{1 + engine() % 4,      1 + engine() % 4,      size, size * aspect,
                      size * offset(engine), size * offset(engine), {}};
  for (std::size_t k = 0; k < cells.nx * cells.ny; ++k) cells.pressures.push_back(pressure(engine));
  cells.pressures[engine() % cells.pressures.size()] = 1;
  std::vector<Pole> corners;
  for (std::size_t j = 0; j <= cells.ny; ++j) {
    for (std::size_t i = 0; i <= cells.nx; ++i)
      corners.push_back({cells.x0 + static_cast<double>(i) * cells.dx, cells.y0 + static_cast<double>(j) * cells.dy});
  }
  return drawn(PressureGrid::exact(cells), SampledReference::of(cells), corners);
}

Triangulation draw_mesh(std::mt19937_64& engine) {
  Triangulation mesh =
      shaken_mesh(1 + engine() % 2, 1 + engine() % 3, log_uniform(engine, 0.1, 1), uniform(engine, 0, 0.3), engine);
  const double size = log_uniform(engine, 1e-6, 1e2), x = offset(engine), y = offset(engine);
  for (Point& p : mesh.points) p = {size * (p.x + x), size * (p.y + y)};
  return mesh;
}

std::vector<Pole> nodes_of(const Triangulation& mesh) {
  std::vector<Pole> nodes;
  for (const Point& p : mesh.points) nodes.push_back({p.x, p.y});
  return nodes;
}

Drawn draw_linear(std::mt19937_64& engine) {
  const Triangulation mesh = draw_mesh(engine);
  std::vector<double> p(mesh.points.size());
  std::ranges::generate(p, [&] { return pressure(engine); });
  p[0] = 1;
  return drawn(PressureMesh::linear(mesh, p), SampledReference::linear(mesh, p), nodes_of(mesh));
}

Drawn draw_constant(std::mt19937_64& engine) {
  const Triangulation mesh = draw_mesh(engine);
  std::vector<double> p(mesh.triangles.size());
  std::ranges::generate(p, [&] { return pressure(engine); });
  p[0] = 1;
  return drawn(PressureMesh::constant(mesh, p), SampledReference::constant(mesh, p), nodes_of(mesh));
}

Twist draw_twist(const Drawn& patch, std::mt19937_64& engine) {
  const double angle = uniform(engine, -3.15, 3.15);
  double x = patch.x, y = patch.y, r = 0;
  switch (engine() % 8) {
    case 0:
      return {std::cos(angle), std::sin(angle), 0};
    case 1: {
      const Pole& mark = patch.landmarks[engine() % patch.landmarks.size()];
      x = mark.x;
      y = mark.y;
      r = engine() % 2 == 0 ? 0 : log_uniform(engine, 1e-16, 1e-2);
      break;
    }
    case 2:
    case 3:
      r = log_uniform(engine, 2, 1e8);
      break;
    default:
      r = uniform(engine, 0, 6);
  }
  return motion_about(x + r * patch.radius * std::cos(angle), y + r * patch.radius * std::sin(angle), engine);
}

struct Kind {
  std::string name;
  Drawn (*draw)(std::mt19937_64&);
};

class SampledBounds : public ::testing::TestWithParam<Kind> {};

INSTANTIATE_TEST_SUITE_P(, SampledBounds,
                         ::testing::Values(Kind{"Grid", draw_grid}, Kind{"Linear", draw_linear},
                                           Kind{"Constant", draw_constant}),
                         [](const auto& instance) { return instance.param.name; });

TEST_P(SampledBounds, HoldAndAreNotIdle) {
  std::mt19937_64 engine(11);
  constexpr int uses = 20;  // of one patch: making it takes longer
  std::vector<double> force_slack, moment_slack;
  int broken = 0;
  for (int c = 0; c < cases(20); ++c) {
    const Drawn patch = GetParam().draw(engine);
    for (int i = 0; i < uses; ++i) {
      const Twist v = draw_twist(patch, engine);
      const BoundedWrench g = patch.computed(v);
      const auto [force, moment] = error_of(g.value, patch.exact.gradient(v));
      if (!(force <= g.force_error) || !(moment <= g.moment_error)) ++broken;
      force_slack.push_back(g.force_error / force);
      moment_slack.push_back(g.moment_error / moment);
    }
  }
  EXPECT_EQ(broken, 0);
  for (const auto& [name, slack] : {std::pair{"force", &force_slack}, {"moment", &moment_slack}}) {
    std::ranges::sort(*slack);
    const double median = (*slack)[slack->size() / 2];
    if (testing::all_cases()) {
      EXPECT_LE(median, 100) << name;
    }
    RecordProperty(name, std::to_string(slack->size()) + " cases, tightest " + std::to_string(slack->front()) +
                             ", median " + std::to_string(median));
  }
}

}  // namespace
}  // namespace patchgrip::friction
