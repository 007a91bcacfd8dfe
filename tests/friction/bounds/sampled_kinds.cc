// Sampled pressures: cells, and triangles with linear or constant pressure.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <patchgrip/tests/friction/bounds/kind.h>
#include <patchgrip/tests/friction/sampled_cases.h>
#include <patchgrip/tests/friction/sampled_reference.h>

namespace patchgrip::friction::bounds {
namespace {

double draw_pressure(Draw& draw) {
  return draw.integer(0, 3) == 0 ? 0 : draw.coin() ? draw.uniform(0, 1) : draw.log_uniform(1e-6, 1);
}

double draw_offset(Draw& draw) { return draw.coin() ? 0 : draw.uniform(-30, 30); }

// A pole next to a corner or node, on the patch, some radii away, far away, or at infinity.
DrawnTwist draw_motion(Draw& draw, const PressureMoments& s, double radius, const std::vector<Pole>& landmarks) {
  const int kind = draw.integer(0, 7);
  if (kind == 0) {
    const double angle = draw.angle();
    return {{std::cos(angle), std::sin(angle), 0}, true};
  }
  if (kind <= 2) {
    const double r = radius * draw.uniform(2, 6), angle = draw.angle();
    return {twist_about({s.x + r * std::cos(angle), s.y + r * std::sin(angle)}, draw.sign()), false};
  }
  return draw_twist(draw, s.x, s.y, radius, [&](Draw& d) -> Pole {
    const Pole& mark = landmarks[d.index(landmarks.size())];
    const double r = d.coin() ? 0 : radius * d.log_uniform(1e-16, 1e-2), angle = d.angle();
    return {mark.x + r * std::cos(angle), mark.y + r * std::sin(angle)};
  });
}

template <class P>
std::function<Case(Draw&)> sampled_cases(const P& patch, SampledReference exact, std::vector<Pole> landmarks) {
  return [=, reference = std::move(exact), marks = std::move(landmarks)](Draw& draw) {
    const auto [v, far] = draw_motion(draw, patch.moments(), patch.area_radius(), marks);
    return judged(far, patch.bounded_gradient(v), reference.gradient(v));
  };
}

std::function<Case(Draw&)> grid(Draw& draw) {
  const double size = draw.log_uniform(1e-6, 1e2), aspect = draw.log_uniform(0.05, 20);
  PressureCells cells{1 + draw.index(4),        1 + draw.index(4),        size, size * aspect,
                      size * draw_offset(draw), size * draw_offset(draw), {}};
  for (std::size_t k = 0; k < cells.nx * cells.ny; ++k) cells.pressures.push_back(draw_pressure(draw));
  cells.pressures[draw.index(cells.pressures.size())] = 1;
  std::vector<Pole> corners;
  for (std::size_t j = 0; j <= cells.ny; ++j) {
    for (std::size_t i = 0; i <= cells.nx; ++i)
      corners.push_back({cells.x0 + static_cast<double>(i) * cells.dx, cells.y0 + static_cast<double>(j) * cells.dy});
  }
  return sampled_cases(PressureGrid::exact(cells), SampledReference::of(cells), corners);
}

Triangulation draw_mesh(Draw& draw) {
  const std::size_t nx = 1 + draw.index(2), ny = 1 + draw.index(3);
  Triangulation mesh = shaken_mesh(nx, ny, draw.log_uniform(0.1, 1), draw.uniform(0, 0.3), draw.engine());
  const double size = draw.log_uniform(1e-6, 1e2), x = draw_offset(draw), y = draw_offset(draw);
  for (Point& p : mesh.points) p = {size * (p.x + x), size * (p.y + y)};
  return mesh;
}

std::vector<Pole> nodes_of(const Triangulation& mesh) {
  std::vector<Pole> nodes;
  for (const Point& p : mesh.points) nodes.push_back({p.x, p.y});
  return nodes;
}

std::vector<double> draw_pressures(Draw& draw, std::size_t count) {
  std::vector<double> p(count);
  std::ranges::generate(p, [&] { return draw_pressure(draw); });
  p[0] = 1;
  return p;
}

std::function<Case(Draw&)> linear(Draw& draw) {
  const Triangulation mesh = draw_mesh(draw);
  const std::vector<double> p = draw_pressures(draw, mesh.points.size());
  return sampled_cases(PressureMesh::linear(mesh, p), SampledReference::linear(mesh, p), nodes_of(mesh));
}

std::function<Case(Draw&)> constant(Draw& draw) {
  const Triangulation mesh = draw_mesh(draw);
  const std::vector<double> p = draw_pressures(draw, mesh.triangles.size());
  return sampled_cases(PressureMesh::constant(mesh, p), SampledReference::constant(mesh, p), nodes_of(mesh));
}

}  // namespace

// Few draws a patch: the slack is more the patch's than the pole's.
Kinds sampled_kinds() {
  constexpr int uses = 5;
  return {{"sampled_grid", reuse(uses, grid)},
          {"sampled_linear", reuse(uses, linear)},
          {"sampled_constant", reuse(uses, constant)}};
}

}  // namespace patchgrip::friction::bounds
