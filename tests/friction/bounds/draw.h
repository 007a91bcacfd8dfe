// Random numbers, laws and motions that bounds are tried on.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>

#include <patchgrip/friction/law.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::friction::bounds {

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double uniform(double lo, double hi) { return lo + (hi - lo) * std::uniform_real_distribution<>(0, 1)(engine_); }
  double log_uniform(double lo, double hi) { return std::exp(uniform(std::log(lo), std::log(hi))); }
  int integer(int lo, int hi) { return std::uniform_int_distribution<>(lo, hi)(engine_); }
  std::size_t index(std::size_t size) { return static_cast<std::size_t>(integer(0, static_cast<int>(size) - 1)); }
  bool coin() { return integer(0, 1) == 1; }
  double sign() { return coin() ? 1 : -1; }
  double angle() { return uniform(-std::numbers::pi, std::numbers::pi); }
  std::mt19937_64& engine() { return engine_; }

 private:
  std::mt19937_64 engine_;
};

struct DrawnLaw {
  Law law;
  double normal_force;
};

inline DrawnLaw draw_law(Draw& draw) {
  Law law = Law::coulomb(draw.log_uniform(0.01, 3));
  if (draw.coin()) law = Law::stribeck(draw.uniform(0, 2), draw.uniform(0, 2), draw.log_uniform(1e-3, 10));
  if (draw.integer(0, 3) == 0) law = law.with_viscous(draw.log_uniform(1e-3, 10));
  return {law, draw.log_uniform(1e-3, 1e3)};
}

inline PlanarFrame draw_frame(Draw& draw, double reach) {
  return {draw.uniform(-reach, reach), draw.uniform(-reach, reach), draw.coin() ? draw.angle() : 0};
}

struct DrawnTwist {
  Twist twist;
  bool far;
};

using SpecialPole = std::function<std::optional<Pole>(Draw&)>;

// A pole within two radii or up to 1e8 of them, sometimes close to `special`; a spin that is often not +-1.
inline DrawnTwist draw_twist(Draw& draw, double cx, double cy, double radius, const SpecialPole& special = {}) {
  const double spin = draw.coin() ? draw.sign() : draw.sign() * draw.log_uniform(1e-3, 1e3);
  if (special && draw.integer(0, 6) == 0) {
    if (const auto pole = special(draw)) return {twist_about(*pole, spin), false};
  }
  const bool far = draw.coin();
  const double r = radius * (far           ? draw.log_uniform(2, 1e8)
                             : draw.coin() ? draw.uniform(0, 2)
                                           : draw.log_uniform(1e-9, 2));
  const double phi = draw.angle();
  return {twist_about({cx + r * std::cos(phi), cy + r * std::sin(phi)}, spin), far};
}

inline Pole on_rim(Draw& draw, double radius) {
  const double x = 1 + draw.sign() * draw.log_uniform(1e-16, 0.1);
  const double phi = draw.angle();
  return {radius * x * std::cos(phi), radius * x * std::sin(phi)};
}

}  // namespace patchgrip::friction::bounds
