#include <patchgrip/cli/picture/picture_axes.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::cli {
namespace {

constexpr Colour face{0.972, 0.972, 0.972};
constexpr Stroke grid{{0.8, 0.8, 0.8}, 0.12};
constexpr Stroke outline{{0.35, 0.35, 0.35}, 0.2};
constexpr double tick_length = 1.2;      // [mm]
constexpr double number_distance = 3.4;  // of numbers from their edge [mm]
constexpr double label_distance = 9.5;
constexpr double number_size = 8;  // [pt]
constexpr double label_size = 9;
constexpr double text_drop = 1;  // from the middle of a line of text to its foot [mm]

double dot(const SpacePoint& a, const SpacePoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Box {
  SpacePoint low, high;

  SpacePoint corner(std::array<bool, 3> is_high) const {
    SpacePoint p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = is_high[i] ? high[i] : low[i];
    return p;
  }
};

std::vector<double> tick_values(const Axis& axis) {
  std::vector<double> values;
  const auto count = std::lround((axis.ticks.high - axis.ticks.low) / axis.ticks.step);
  for (long i = 0; i <= count; ++i) values.push_back(axis.ticks.low + static_cast<double>(i) * axis.ticks.step);
  return values;
}

// The face of constant coordinate k that lies behind, with the grid lines of the other two.
void draw_face(Svg& svg, const View& view, const Box& box, const std::array<Axis, 3>& axes, std::size_t k, bool high) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  std::array<Spot, 4> corners;
  for (std::size_t c = 0; c < 4; ++c) {
    std::array<bool, 3> is_high{};
    is_high[k] = high;
    is_high[i] = c == 1 || c == 2;
    is_high[j] = c >= 2;
    corners[c] = view(box.corner(is_high));
  }
  svg.polygon(corners, face, outline);
  for (const auto& [along, across] : {std::pair{i, j}, std::pair{j, i}}) {
    for (const double value : tick_values(axes[along])) {
      SpacePoint from = box.low, to = box.high;
      from[k] = to[k] = high ? box.high[k] : box.low[k];
      from[along] = to[along] = value * axes[along].unit;
      from[across] = box.low[across];
      to[across] = box.high[across];
      svg.line(std::array{view(from), view(to)}, grid);
    }
  }
}

// Ticks and numbers along the edge from `from` to `to` of axis k; `away` points off the box on the page.
void draw_edge(Svg& svg, const View& view, const Axis& axis, std::size_t k, const SpacePoint& from, const Spot& away) {
  const auto anchor = std::fabs(away.x) < 0.35 ? Anchor::middle : away.x < 0 ? Anchor::end : Anchor::start;
  const auto beside = [&](const Spot& at, double distance) {
    return Spot{at.x + distance * away.x, at.y + distance * away.y};
  };
  const auto lowered = [&](const Spot& at) { return Spot{at.x, at.y + text_drop}; };
  double widest = 0;
  for (const double value : tick_values(axis)) {
    SpacePoint p = from;
    p[k] = value * axis.unit;
    const Spot at = view(p);
    const double shown = std::fabs(value) < 1e-9 * axis.ticks.step ? 0 : value;
    const std::string number = fmt::format("{:.6g}", shown);
    widest = std::max(widest, static_cast<double>(number.size()));
    svg.line(std::array{at, beside(at, tick_length)}, outline);
    svg.number(lowered(beside(at, number_distance - (anchor == Anchor::middle ? 0 : 1.2))), number, number_size,
               anchor);
  }
  SpacePoint middle = from;
  middle[k] = 0.5 * (axis.ticks.low + axis.ticks.high) * axis.unit;
  const double distance = label_distance + (anchor == Anchor::middle ? 0 : 0.6 * widest);
  svg.label(lowered(beside(view(middle), distance)), axis.label, label_size, anchor);
}

}  // namespace

View::View(double azimuth, double elevation) {
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  const double ce = std::cos(elevation), se = std::sin(elevation);
  right_ = {-s, c, 0};
  up_ = {-se * c, -se * s, ce};
  viewer_ = {ce * c, ce * s, se};
}

Spot View::operator()(const SpacePoint& p) const noexcept {
  return {middle_.x + scale_ * (dot(right_, p) - centre_.x), middle_.y - scale_ * (dot(up_, p) - centre_.y)};
}

void View::fit(const SpacePoint& low, const SpacePoint& high, const Spot& corner, double width, double height) {
  const auto range = [&](const SpacePoint& axis) {
    double least = 0, most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      least += std::min(axis[i] * low[i], axis[i] * high[i]);
      most += std::max(axis[i] * low[i], axis[i] * high[i]);
    }
    return std::pair{least, most};
  };
  const auto [left, right] = range(right_);
  const auto [bottom, top] = range(up_);
  scale_ = std::min(width / (right - left), height / (top - bottom));
  centre_ = {0.5 * (left + right), 0.5 * (bottom + top)};
  middle_ = {corner.x + width / 2, corner.y + height / 2};
}

Ticks Ticks::between(double low, double high) {
  constexpr double steps = 4;
  const double rough = (high - low) / steps;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  const double digit = rough / power;
  const double step = power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
  return {step * std::floor(low / step + 1e-6), step * std::ceil(high / step - 1e-6), step};
}

void draw_box(Svg& svg, const View& view, const std::array<Axis, 3>& axes) {
  Box box{};
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = axes[i].ticks.low * axes[i].unit;
    box.high[i] = axes[i].ticks.high * axes[i].unit;
  }
  const SpacePoint& viewer = view.towards_viewer();
  for (std::size_t k = 0; k < 3; ++k) draw_face(svg, view, box, axes, k, viewer[k] < 0);

  // The two lower edges next to the viewer, and the upright one that is farthest left.
  const bool below = viewer[2] < 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t other = 1 - k;
    std::array<bool, 3> is_high{};
    is_high[other] = viewer[other] >= 0;
    is_high[2] = below;
    const SpacePoint from = box.corner(is_high);
    const double turned = view.right()[other] * (is_high[other] ? 1 : -1);
    Spot away{turned, below ? -0.9 : 0.9};
    const double length = std::hypot(away.x, away.y);
    draw_edge(svg, view, axes[k], k, from, {away.x / length, away.y / length});
  }
  std::array<bool, 3> left{};
  left[0] = view.right()[0] < 0;
  left[1] = view.right()[1] < 0;
  draw_edge(svg, view, axes[2], 2, box.corner(left), {-1, 0});
}

}  // namespace patchgrip::cli
