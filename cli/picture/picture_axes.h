// The box around a body in space, as seen from outside: three faces behind it with grid lines, and ticks with numbers
// on three edges in front.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <patchgrip/cli/picture/svg.h>

namespace patchgrip::cli {

using SpacePoint = std::array<double, 3>;

// A view from infinity; the third axis points up.
class View {
 public:
  // From a direction `azimuth` around the third axis, `elevation` above its plane [rad].
  View(double azimuth, double elevation);

  // Fits the box into a frame of the page [mm].
  void fit(const SpacePoint& low, const SpacePoint& high, const Spot& corner, double width, double height);

  Spot operator()(const SpacePoint& p) const noexcept;
  const SpacePoint& towards_viewer() const noexcept { return viewer_; }
  const SpacePoint& right() const noexcept { return right_; }
  const SpacePoint& up() const noexcept { return up_; }

 private:
  SpacePoint right_, up_, viewer_;
  double scale_ = 1;  // [mm] a unit
  Spot middle_;       // of the frame [mm]
  Spot centre_;       // of what is shown, before scaling
};

// Ticks at 1, 2 or 5 times a power of ten: about four steps between low and high.
struct Ticks {
  static Ticks between(double low, double high);

  double low, high;  // ends of the axis, on ticks
  double step;
};

struct Axis {
  Ticks ticks;        // in the unit of the numbers shown
  double unit;        // what 1 of them is in space
  std::string label;  // with the markup of Svg::label
};

void draw_box(Svg& svg, const View& view, const std::array<Axis, 3>& axes);

}  // namespace patchgrip::cli
