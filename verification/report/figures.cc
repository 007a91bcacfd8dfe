#include <patchgrip/verification/report/figures.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <patchgrip/cli/picture/colours.h>
#include <patchgrip/verification/report/plot.h>

namespace patchgrip::verification {
namespace {

constexpr std::array colours{cli::vermilion, cli::blue, cli::green, cli::orange, cli::black};

// Dark blue over green to yellow, as steps of a ramp that is also one of lightness.
cli::Colour ramp(double share) {
  constexpr std::array<cli::Colour, 5> steps{{{0.267, 0.005, 0.329},
                                              {0.229, 0.322, 0.546},
                                              {0.128, 0.567, 0.551},
                                              {0.369, 0.789, 0.383},
                                              {0.993, 0.906, 0.144}}};
  const double place = std::clamp(share, 0., 1.) * (steps.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), steps.size() - 2);
  return cli::mixed(steps[below], steps[below + 1], place - static_cast<double>(below));
}

}  // namespace

std::string curve_figure(const Curve& curve) {
  std::vector<double> all_x, all_y;
  for (const Line& line : curve.lines) {
    all_x.insert(all_x.end(), line.x.begin(), line.x.end());
    all_y.insert(all_y.end(), line.y.begin(), line.y.end());
  }
  const auto [least, most] = std::minmax_element(all_x.begin(), all_x.end());
  Plot plot(axis_of(curve.x_label, all_x, *least > 0 && *most > 100 * *least), axis_of(curve.y_label, all_y));
  std::size_t colour = 0;
  for (const Line& line : curve.lines) {
    const cli::Colour& own = colours[colour++ % colours.size()];
    if (line.is_library) {
      plot.line(line.x, line.y, {own, 0.4});
    } else {
      plot.points(line.x, line.y, own);
    }
    plot.legend(line.name, own, !line.is_library);
  }
  return std::move(plot).finished();
}

std::string convergence_figure(const Study& study) {
  std::vector<double> elements, all;
  std::vector<std::pair<std::string, std::vector<double>>> lines;
  for (const Run& run : study.runs) elements.push_back(run.setting.elements);
  for (std::size_t q = 0; q < study.comparisons.size(); ++q) {
    const Quantity& quantity = study.comparisons[q].quantity;
    if (quantity.claim == Claim::differs) continue;
    std::vector<double> errors;
    for (const Run& run : study.runs) {
      errors.push_back(largest_of(distances(run.values[q], quantity.library)) / quantity.scale);
    }
    all.insert(all.end(), errors.begin(), errors.end());
    lines.emplace_back(quantity.name, errors);
  }
  if (lines.empty()) return "";
  Plot plot(axis_of("elements per radius", elements, true), axis_of("difference / scale", all, true));
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const cli::Colour& own = colours[k % colours.size()];
    plot.line(elements, lines[k].second, {own, 0.4});
    plot.points(elements, lines[k].second, own);
    plot.legend(lines[k].first, own, true);
  }
  return std::move(plot).finished();
}

std::string stress_figure(const PlaneField& field, double reach) {
  constexpr double scale_width = 24, margin = 4, size = 76, bar = 50, bar_name = 6;  // [mm]
  double top = -1e300, right = 0, bottom = 1e300, most = 0;
  for (const auto& p : field.points) top = std::max(top, p[1]);
  std::vector<std::array<std::size_t, 3>> shown;
  for (const auto& triangle : field.triangles) {
    const bool is_near = std::all_of(triangle.begin(), triangle.end(), [&](std::size_t i) {
      return field.points[i][0] <= reach && field.points[i][1] >= top - reach;
    });
    if (!is_near) continue;
    shown.push_back(triangle);
    for (const std::size_t i : triangle) {
      right = std::max(right, field.points[i][0]);
      bottom = std::min(bottom, field.points[i][1]);
      most = std::max(most, field.values[i]);
    }
  }
  const double per_length = size / std::max(right, top - bottom);
  const double height = std::max(per_length * (top - bottom), bar + bar_name);
  cli::Svg svg(2 * margin + per_length * right + scale_width, 2 * margin + height);
  for (const auto& triangle : shown) {
    std::array<cli::Spot, 3> corners;
    double mean = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = field.points[triangle[k]];
      corners[k] = {margin + per_length * p[0], margin + per_length * (top - p[1])};
      mean += field.values[triangle[k]] / 3;
    }
    svg.polygon(corners, ramp(mean / most), {{0.3, 0.3, 0.3}, 0.05});
  }
  const double x = 2 * margin + per_length * right;
  for (int k = 0; k < 50; ++k) {
    const double y = margin + bar * (1 - (k + 1) / 50.);
    svg.polygon(std::array<cli::Spot, 4>{{{x, y}, {x + 4, y}, {x + 4, y + 1.05}, {x, y + 1.05}}}, ramp(k / 49.),
                {ramp(k / 49.), 0.05});
  }
  svg.text({x + 5, margin + 2}, fmt::format("{:.3g} Pa", most), 7);
  svg.text({x + 5, margin + bar}, "0", 7);
  svg.text({x, margin + bar + 5}, "von Mises", 7);
  return std::move(svg).finished();
}

}  // namespace patchgrip::verification
