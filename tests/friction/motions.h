// Random motions of a patch for RapidCheck: poles log-uniform about it, close to where its pressure ends, at infinity.
#pragma once

#include <cmath>
#include <numbers>
#include <ostream>

#include <rapidcheck.h>

#include <patchgrip/friction/twist.h>
#include <patchgrip/tests/friction/any_patch.h>

namespace patchgrip::friction {

inline std::ostream& operator<<(std::ostream& out, const Twist& v) {
  const auto precision = out.precision(17);
  out << "twist {" << v.vx << ", " << v.vy << ", " << v.w << '}';
  out.precision(precision);
  return out;
}

// Uniform in [lo, hi], whatever the size that RapidCheck has grown to.
inline rc::Gen<double> uniform(double lo, double hi) {
  constexpr int steps = 1 << 30;
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, steps + 1)),
                      [=](int i) { return lo + (hi - lo) * i / steps; });
}

inline rc::Gen<double> log_uniform(double lo, double hi) {
  return rc::gen::map(uniform(std::log(lo), std::log(hi)), [](double x) { return std::exp(x); });
}

inline rc::Gen<Twist> motion_of(const NamedPatch& patch) {
  return rc::gen::exec([&patch] {
    const double a = patch.size();
    const double angle = *uniform(-std::numbers::pi, std::numbers::pi);
    const double c = std::cos(angle), s = std::sin(angle);
    const double speed = (*rc::gen::inRange(0, 2) == 0 ? 1 : -1) * *log_uniform(1e-6, 1e6);
    const PressureMoments m = patch.moments();
    switch (*rc::gen::inRange(0, 8)) {
      case 0:
        return Twist{speed * c, speed * s, 0};
      case 1:
        return twist_about({m.x, m.y}, speed);
      case 2:
      case 3: {
        const Pole& mark = patch.landmarks[*rc::gen::inRange<std::size_t>(0, patch.landmarks.size())];
        const double off = *rc::gen::inRange(0, 3) == 0 ? 0 : a * *log_uniform(1e-17, 1);
        return twist_about({mark.x + off * c, mark.y + off * s}, speed);
      }
      default: {
        const double r = a * *log_uniform(1e-9, 1e9);
        return twist_about({m.x + r * c, m.y + r * s}, speed);
      }
    }
  });
}

}  // namespace patchgrip::friction
