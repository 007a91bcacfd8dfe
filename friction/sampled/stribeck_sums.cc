#include <patchgrip/friction/sampled/stribeck_sums.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <patchgrip/friction/kernels/vector_quadrature.h>
#include <patchgrip/friction/sampled/gauss_rule.h>

namespace patchgrip::friction::kernels {
namespace {

constexpr double unit = 0x1p-53;

// rho^(-points) exp(kappa^2 (rho - 1/rho)^2 / 4) at the best of some rho up to `most`.
double decay(double most, int points, double kappa) noexcept {
  double least = 1;
  for (const double share : {1., 0.7, 0.5, 0.35, 0.25, 0.15}) {
    const double rho = std::pow(most, share), growth = kappa * (rho - 1 / rho) / 2;
    least = std::min(least, std::pow(rho, -points) * std::exp(growth * growth));
  }
  return least;
}

// int_0^1 exp(-y l^2) l^k dl, k = 1, 2, 3.
std::array<double, 3> radial(double y) noexcept {
  if (y > 1) {
    const double e = std::exp(-y), first = -std::expm1(-y) / (2 * y);
    return {first, (std::sqrt(std::numbers::pi / y) / 2 * std::erf(std::sqrt(y)) - e) / (2 * y),
            (2 * first - e) / (2 * y)};
  }
  std::array<double, 3> sum{};
  double term = 1;
  for (int k = 0; k < 20; ++k) {
    for (int j = 0; j < 3; ++j) sum[static_cast<std::size_t>(j)] += term / (2 * k + 2 + j);
    term *= -y / (k + 1);
  }
  return sum;
}

void add_by_points(const LoadedPiece& p, int count, const Twist& u, StribeckSums& sums) noexcept {
  const auto& gauss = gauss_rule(count);
  for (std::size_t k = 1; k + 1 < p.corners; ++k) {
    const double ax = p.x[k] - p.x[0], ay = p.y[k] - p.y[0], bx = p.x[k + 1] - p.x[0], by = p.y[k + 1] - p.y[0];
    const double twice_area = ax * by - ay * bx;
    for (const auto& [s_at, s_weight] : gauss) {
      const double s = (1 + s_at) / 2;
      for (const auto& [r_at, r_weight] : gauss) {
        const double r = (1 + r_at) / 2, dx = s * ((1 - r) * ax + r * bx), dy = s * ((1 - r) * ay + r * by);
        const double x = p.x[0] + dx, y = p.y[0] + dy, ux = u.vx - u.w * y, uy = u.vy + u.w * x;
        const double f = twice_area * s * s_weight * r_weight / 4 * (p.pressure + p.gx * dx + p.gy * dy) *
                         excess_per_speed(ux * ux + uy * uy);
        sums.add(f * ux, f * uy, f * (x * uy - y * ux));
      }
    }
  }
}

void add_about_pole(const LoadedPiece& p, const Twist& u, double size, double lever, StribeckSums& sums) noexcept {
  const double X = -u.vy / u.w, Y = u.vx / u.w, sense = u.w < 0 ? -1 : 1;
  const double at_pole = p.pressure + p.gx * (X - p.x[0]) + p.gy * (Y - p.y[0]);
  for (std::size_t i = 0; i < p.corners; ++i) {
    const std::size_t j = i + 1 < p.corners ? i + 1 : 0;
    const double ex = p.x[j] - p.x[i], ey = p.y[j] - p.y[i], l = std::hypot(ex, ey), tx = ex / l, ty = ey / l;
    const double px = p.x[i] - X, py = p.y[i] - Y, h = ty * px - tx * py, t0 = tx * px + ty * py, t1 = t0 + l;
    if (h == 0) continue;
    const auto at = [&](double t) -> std::array<double, 3> {
      const double R2 = t * t + h * h, R = std::sqrt(R2), dx = ty * h + tx * t, dy = -tx * h + ty * t;
      const double slope = p.gx * dx + p.gy * dy;
      const auto [g1, g2, g3] = radial(u.w * u.w * R2);
      const double k = h * (at_pole * g1 + slope * g2) / R;
      return {-k * dy, k * dx, h * R * (at_pole * g2 + slope * g3) / size};
    };
    const double foot = std::clamp(0.0, t0, t1);
    const auto before = integrate<3>([&](double, double to_foot) { return at(foot - to_foot); }, t0, foot);
    const auto beyond = integrate<3>([&](double from_foot, double) { return at(foot + from_foot); }, foot, t1);
    std::array<double, 3> value, error;
    for (std::size_t k = 0; k < 3; ++k) {
      value[k] = sense * (before.value[k] + beyond.value[k]);
      error[k] = before.error[k] + beyond.error[k];
    }
    sums.add(value[0], value[1], size * value[2] + X * value[1] - Y * value[0]);
    const double terms = std::fabs(h) * l * (std::fabs(at_pole) + p.highest);
    const double force_error = error[0] + error[1] + 16 * unit * terms;
    sums.add_error(force_error, lever * force_error + size * error[2]);
  }
}

}  // namespace

double excess_per_speed(double speed2) noexcept { return speed2 > 0 ? std::exp(-speed2) / std::sqrt(speed2) : 0; }

double excess_error(int order, double R, double kappa) noexcept {
  return 8 * R * decay(R + std::sqrt(R * R - 1), order, kappa);
}

void add_excess(const LoadedPiece& p, const Twist& u, StribeckSums& sums) noexcept {
  double cx = 0, cy = 0;
  for (std::size_t i = 0; i < p.corners; ++i) {
    cx += p.x[i] / static_cast<double>(p.corners);
    cy += p.y[i] / static_cast<double>(p.corners);
  }
  double radius = 0, area = 0;
  for (std::size_t i = 0; i < p.corners; ++i) radius = std::max(radius, std::hypot(p.x[i] - cx, p.y[i] - cy));
  for (std::size_t i = 1; i + 1 < p.corners; ++i) {
    area += ((p.x[i] - p.x[0]) * (p.y[i + 1] - p.y[0]) - (p.y[i] - p.y[0]) * (p.x[i + 1] - p.x[0])) / 2;
  }
  const double W = std::fabs(u.w), speed = std::hypot(u.vx - u.w * cy, u.vy + u.w * cx);
  const double least_speed = std::max(0.0, speed - W * radius), load = p.highest * area;
  const double lever = std::hypot(cx, cy) + radius;
  const double most = std::exp(-least_speed * least_speed);
  if (most < negligible) return sums.add_error(load * most, lever * load * most);
  const double rounding = 32 * unit * load * most;
  sums.add_error(rounding, lever * rounding);
  const double away = least_speed / (W * radius), rho = away + std::sqrt(away * away + 1);
  for (const int count : {4, 6, 8, 12, 16, 24}) {
    const double error = 16 * (W > 0 ? decay(std::min(rho, 1e3), 2 * count, W * radius) : 0);
    if (error > unit) continue;
    sums.add_error(error * load, lever * error * load);
    return add_by_points(p, count, u, sums);
  }
  add_about_pole(p, u, radius, lever + speed / W, sums);
}

}  // namespace patchgrip::friction::kernels
