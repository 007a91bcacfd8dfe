#include <patchgrip/verification/report/plot.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <patchgrip/cli/picture/colours.h>
#include <patchgrip/cli/picture/picture_axes.h>

namespace patchgrip::verification {
namespace {

using cli::Anchor;
using cli::Spot;

// [mm]
constexpr double width = 140, height = 72;
constexpr double left = 16, right = width - 46, top = 8, bottom = height - 12;
constexpr double number_size = 7, label_size = 8;  // [pt]
constexpr cli::Stroke grid{{0.88, 0.88, 0.88}, 0.15}, frame{{0, 0, 0}, 0.2};

double share(const PlotAxis& axis, double value) {
  if (axis.is_logarithmic) return std::log(value / axis.low) / std::log(axis.high / axis.low);
  return (value - axis.low) / (axis.high - axis.low);
}

std::vector<double> ticks_of(const PlotAxis& axis) {
  std::vector<double> values;
  if (axis.is_logarithmic) {
    for (double power = std::ceil(std::log10(axis.low) - 1e-9); power <= std::log10(axis.high) + 1e-9; ++power) {
      values.push_back(std::pow(10, power));
    }
    if (values.size() >= 2) return values;
    values.clear();
    for (double power = std::pow(10, std::floor(std::log10(axis.low))); power < axis.high; power *= 10) {
      for (const double digit : {1., 2., 5.}) {
        if (digit * power >= axis.low && digit * power <= axis.high) values.push_back(digit * power);
      }
    }
    return values;
  }
  const auto ticks = cli::Ticks::between(axis.low, axis.high);
  for (double value = ticks.low; value <= ticks.high + ticks.step / 2; value += ticks.step) {
    if (value >= axis.low - 1e-9 * ticks.step && value <= axis.high + 1e-9 * ticks.step) {
      values.push_back(std::fabs(value) < 1e-9 * ticks.step ? 0 : value);
    }
  }
  return values;
}

}  // namespace

PlotAxis axis_of(std::string label, const std::vector<double>& values, bool is_logarithmic) {
  std::vector<double> shown;
  std::copy_if(values.begin(), values.end(), std::back_inserter(shown),
               [&](double value) { return std::isfinite(value) && (!is_logarithmic || value > 0); });
  if (shown.empty()) return {std::move(label), is_logarithmic ? 0.1 : 0, 1, is_logarithmic};
  const auto [low, high] = std::minmax_element(shown.begin(), shown.end());
  if (is_logarithmic) return {std::move(label), *low / 1.5, *high * 1.5, true};
  const double room = *high > *low ? 0.05 * (*high - *low) : 0.05 * std::max(std::fabs(*high), 1e-300);
  return {std::move(label), *low == 0 ? 0 : *low - room, *high + room};
}

Plot::Plot(const PlotAxis& x, const PlotAxis& y) : svg_(width, height), x_(x), y_(y) { draw_axes(); }

Spot Plot::spot(double x, double y) const {
  return {std::lerp(left, right, share(x_, x)), std::lerp(bottom, top, share(y_, y))};
}

bool Plot::shows(double x, double y) const { return x >= x_.low && x <= x_.high && y >= y_.low && y <= y_.high; }

void Plot::draw_axes() {
  for (const double value : ticks_of(x_)) {
    const Spot foot = spot(value, y_.low);
    svg_.line(std::array{foot, spot(value, y_.high)}, grid);
    svg_.number({foot.x, bottom + 4}, fmt::format("{:.3g}", value), number_size, Anchor::middle);
  }
  for (const double value : ticks_of(y_)) {
    const Spot foot = spot(x_.low, value);
    svg_.line(std::array{foot, spot(x_.high, value)}, grid);
    svg_.number({left - 1.5, foot.y + 1}, fmt::format("{:.3g}", value), number_size, Anchor::end);
  }
  svg_.line(std::array{Spot{left, top}, Spot{right, top}, Spot{right, bottom}, Spot{left, bottom}, Spot{left, top}},
            frame);
  svg_.text({(left + right) / 2, height - 2.5}, x_.label, label_size, Anchor::middle);
  svg_.text({1, top - 3}, y_.label, label_size);
}

void Plot::line(const std::vector<double>& x, const std::vector<double>& y, const cli::Stroke& stroke) {
  std::vector<Spot> piece;
  for (std::size_t i = 0; i <= x.size(); ++i) {
    if (i < x.size() && shows(x[i], y[i])) {
      piece.push_back(spot(x[i], y[i]));
    } else {
      svg_.line(piece, stroke);
      piece.clear();
    }
  }
}

void Plot::points(const std::vector<double>& x, const std::vector<double>& y, const cli::Colour& colour) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (shows(x[i], y[i])) svg_.circle(spot(x[i], y[i]), 0.7, colour, {colour, 0.1});
  }
}

void Plot::legend(const std::string& name, const cli::Colour& colour, bool has_points) {
  const Spot at{right + 3, top + 4 + 4 * names_++};
  if (has_points) {
    svg_.circle({at.x + 3, at.y - 1}, 0.7, colour, {colour, 0.1});
  } else {
    svg_.line(std::array{Spot{at.x, at.y - 1}, Spot{at.x + 6, at.y - 1}}, {colour, 0.4});
  }
  svg_.text({at.x + 8, at.y}, name, number_size);
}

std::string Plot::finished() && { return std::move(svg_).finished(); }

}  // namespace patchgrip::verification
