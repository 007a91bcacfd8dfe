// A frame with two axes, linear or logarithmic, with lines and points in it and their names beside it, as SVG.
#pragma once

#include <string>
#include <vector>

#include <patchgrip/cli/picture/svg.h>

namespace patchgrip::verification {

struct PlotAxis {
  std::string label;
  double low, high;
  bool is_logarithmic = false;
};

// The range of the values with a little room; logarithmic ones that are not positive are left out.
PlotAxis axis_of(std::string label, const std::vector<double>& values, bool is_logarithmic = false);

class Plot {
 public:
  Plot(const PlotAxis& x, const PlotAxis& y);

  // Cut off at the frame.
  void line(const std::vector<double>& x, const std::vector<double>& y, const cli::Stroke& stroke);
  void points(const std::vector<double>& x, const std::vector<double>& y, const cli::Colour& colour);
  void legend(const std::string& name, const cli::Colour& colour, bool has_points);

  std::string finished() &&;

 private:
  bool shows(double x, double y) const;
  cli::Spot spot(double x, double y) const;
  void draw_axes();

  cli::Svg svg_;
  PlotAxis x_, y_;
  int names_ = 0;
};

}  // namespace patchgrip::verification
