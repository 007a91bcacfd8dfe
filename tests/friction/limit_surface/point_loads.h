// Pressures with point loads: on a line, where limit surfaces have facets and ridges, and beside discs, where they have
// facets. Loads on them that are exact, nearly exact and random, and such as lie at the rim of a facet.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/tests/friction/limit_surface/gauge_reference.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::friction {

struct PointScene {
  struct Part {
    double x, y, force;
    double radius = 0;  // of a Hertz disc; 0: a point load
  };

  std::string name;
  std::vector<Part> parts;
  double angle = 0;  // of the line that the parts lie on, if they do

  Several patch() const {
    std::vector<Several::Part> all;
    for (const Part& p : parts) {
      if (p.radius > 0) {
        all.push_back({Placed(HertzDisc::of_radius(p.radius), p.x, p.y), p.force});
      } else {
        all.push_back({Placed(PointLoad{}, p.x, p.y), p.force});
      }
    }
    return Several::of_parts(std::move(all));
  }

  GaugeReference reference() const {
    Real50 total = 0;
    for (const Part& p : parts) total += p.force;
    std::vector<PointShare50> points;
    std::vector<Part> discs;
    for (const Part& p : parts) {
      if (p.radius > 0) {
        discs.push_back(p);
      } else {
        points.push_back({p.x, p.y, p.force / total});
      }
    }
    const kernels::PowerFamily<Real50> hertz(1);
    GaugeReference::Gradient smooth;
    if (!discs.empty()) {
      smooth = [=](const Real50& vx, const Real50& vy, const Real50& w) {
        Wrench50 sum{0, 0, 0};
        for (const Part& p : discs) {
          const Wrench50 g = round_wrench(hertz, p.radius, vx - w * p.y, vy + w * p.x, w);
          const Real50 k = p.force / total;
          sum.fx += k * g.fx;
          sum.fy += k * g.fy;
          sum.m += k * (g.m + p.x * g.fy - p.y * g.fx);
        }
        return sum;
      };
    }
    return {std::move(smooth), std::move(points), patch().moments()};
  }
};

inline PointScene on_a_line(std::string name, const std::vector<std::pair<double, double>>& loads, double angle,
                            double x, double y) {
  PointScene scene{std::move(name), {}, angle};
  for (const auto& [s, force] : loads) {
    scene.parts.push_back({x + s * std::cos(angle), y + s * std::sin(angle), force});
  }
  return scene;
}

inline std::vector<PointScene> point_scenes() {
  return {on_a_line("two", {{-0.02, 1}, {0.02, 1}}, 0, 0, 0),
          on_a_line("two turned", {{-0.02, 1}, {0.05, 3}}, 0.7, 0.3, -0.2),
          on_a_line("three", {{-1, 1}, {0, 1}, {1, 1}}, 0, 0, 0),
          on_a_line("three turned", {{-1, 1}, {0.3, 0.4}, {1, 2}}, 1.1, 0, 0),
          on_a_line("four turned", {{-1, 1}, {0.3, 0.4}, {1, 2}, {1.5, 0.3}}, 2.1, 4, 3),
          {"tripod", {{-1, 0, 0.3}, {1, 0, 0.3}, {0, 1.3, 0.4}}},
          {"four", {{-1, 0.1, 0.2}, {1, 0, 0.1}, {0, 1.3, 0.3}, {0.1, 0.2, 0.4}}},
          {"disc and two", {{0, 0, 5, 0.003}, {0.01, 0.002, 2}, {-0.004, 0.006, 3}}},
          {"disc between two", {{0, 0, 5, 0.003}, {0.01, 0, 2}, {-0.02, 0, 3}}},
          {"point in a disc", {{0, 0, 5, 1}, {0.3, 0.1, 2}}},
          {"point at the centre", {{0, 0, 5, 1}, {0, 0, 2}}}};
}

enum class LoadKind { exact, nearly_exact, any, rim_of_facet };

inline Wrench draw_load(std::mt19937_64& engine, LoadKind kind, const PointScene& scene, const Several& patch) {
  using ::patchgrip::testing::log_uniform;
  using ::patchgrip::testing::uniform;
  using std::numbers::pi;
  const PressureMoments s = patch.moments();
  const double length = std::sqrt(s.polar);
  const auto index = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine); };
  const auto sign = [&] { return uniform(engine, -1, 1) < 0 ? -1. : 1.; };
  const double size = log_uniform(engine, 1e-3, 1e3);
  // Along and across the line, moments over the length.
  const auto load = [&](double direction, double F, double M) -> Wrench {
    const double fx = size * F * std::cos(direction), fy = size * F * std::sin(direction);
    return {fx, fy, size * M * length + (s.x * fy - s.y * fx)};
  };
  const double axis = scene.angle + pi / 2 * static_cast<double>(index(4));
  const double small = sign() * log_uniform(engine, 1e-17, 1e-2);
  switch (kind) {
    case LoadKind::exact: {
      constexpr double moments[] = {0, 1e-13, -1e-13, 1e-11, 1e-8, 1e-3, 0.3, -0.25, 0.5, 1};
      if (index(4) == 0) return load(axis, small > 0 ? 0 : 1e-12, sign());
      return load(axis, 1, moments[index(10)]);
    }
    case LoadKind::nearly_exact: {
      const double tilt = index(2) == 0 ? uniform(engine, -pi, pi) : pi / 2 * static_cast<double>(index(4));
      const double off = sign() * log_uniform(engine, 1e-17, 1e-2);
      return load(axis + small, std::cos(tilt + off), std::sin(tilt + off));
    }
    case LoadKind::any: {
      const double tilt = uniform(engine, -pi, pi);
      return load(uniform(engine, -pi, pi), std::cos(tilt), std::sin(tilt));
    }
    case LoadKind::rim_of_facet: {
      const std::vector<PointShare> shares = patch.point_shares();
      const PointShare& p = shares[index(shares.size())];
      const Wrench g = patch.gradient(twist_about({p.x, p.y}, 1));
      const double w = p.share * (1 + (index(4) == 0 ? 0 : sign() * log_uniform(engine, 1e-17, 0.1)));
      const double direction = uniform(engine, -pi, pi), k = size * sign();
      const double qx = w * std::cos(direction), qy = w * std::sin(direction);
      return {k * (g.fx + qx), k * (g.fy + qy), k * (g.m + p.x * qy - p.y * qx)};
    }
  }
  return {};
}

}  // namespace patchgrip::friction
