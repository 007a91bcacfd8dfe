#include <patchgrip/contact/half_space/local_pressure.h>
#include <patchgrip/contact/half_space/measured.h>
#include <patchgrip/contact/require.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace patchgrip::contact {
namespace {

constexpr std::size_t around = 4;

// The cell around a coordinate, counted from the lower side: its centre is at 0, 1, ...
struct Place {
  int below;        // the centre at or before the point
  double fraction;  // of the way to the next
};

Place place_of(double position) {
  const double below = std::floor(position);
  return {static_cast<int>(below), position - below};
}

// Beyond the centres at the sides of a free surface nothing touches.
int neighbour(int index, int cells, bool wraps) {
  return wraps ? (index + 2 * cells) % cells : std::clamp(index, 0, cells - 1);
}

double bent(double before, double at, double after) { return std::fabs(before - 2 * at + after); }

}  // namespace

std::optional<Estimate> local_pressure(const PressedHalfSpace& pressed, double x, double y) {
  require_finite("x", x);
  require_finite("y", y);
  const Grid& grid = pressed.grid;
  if (pressed.coarser_pressure.size() != grid.size()) {
    throw std::invalid_argument("local_pressure: the half-space was pressed without local_errors");
  }
  const bool wraps = pressed.surface == Surface::periodic;
  if (!wraps && !(std::fabs(x) <= 0.5 * grid.nx * grid.dx && std::fabs(y) <= 0.5 * grid.ny * grid.dy)) {
    return std::nullopt;
  }
  if (wraps) {  // exactly, however far away
    x = std::fmod(x, grid.nx * grid.dx);
    y = std::fmod(y, grid.ny * grid.dy);
  }
  const Place along_x = place_of(x / grid.dx + 0.5 * grid.nx - 0.5);
  const Place along_y = place_of(y / grid.dy + 0.5 * grid.ny - 0.5);

  std::array<std::array<double, around>, around> p{};
  double most = 0, least = INFINITY, refined = 0;
  for (std::size_t j = 0; j < around; ++j) {
    for (std::size_t i = 0; i < around; ++i) {
      const std::size_t cell = grid.index(neighbour(along_x.below + static_cast<int>(i) - 1, grid.nx, wraps),
                                          neighbour(along_y.below + static_cast<int>(j) - 1, grid.ny, wraps));
      p[j][i] = pressed.pressure[cell];
      most = std::max(most, p[j][i]);
      least = std::min(least, p[j][i]);
      refined = std::max(refined, std::fabs(p[j][i] - pressed.coarser_pressure[cell]));
    }
  }
  const double u = along_x.fraction, v = along_y.fraction;
  const double value = (1 - v) * ((1 - u) * p[1][1] + u * p[1][2]) + v * ((1 - u) * p[2][1] + u * p[2][2]);
  const Estimate& peak = pressed.peak_pressure;  // its error may be infinite
  double error = refined / order_factor + (value > 0 ? peak.error / peak.value * value : 0);
  if (least > 0) {
    double bent_x = 0, bent_y = 0;
    for (std::size_t k = 0; k < around; ++k) {
      for (std::size_t m = 1; m + 1 < around; ++m) {
        bent_x = std::max(bent_x, bent(p[k][m - 1], p[k][m], p[k][m + 1]));
        bent_y = std::max(bent_y, bent(p[m - 1][k], p[m][k], p[m + 1][k]));
      }
    }
    error += (bent_x + bent_y) / 8;
  } else {
    error += most;
  }
  return Estimate{value, error};
}

}  // namespace patchgrip::contact
