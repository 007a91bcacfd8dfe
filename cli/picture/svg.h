// A drawing as SVG: polygons, lines, circles and text, in millimetres from the upper left corner.
//
// A label has a little markup: `_x` sets one character lower, `*x` in italics. Text is taken as it is.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace patchgrip::cli {

struct Spot {
  double x = 0;  // [mm] to the right
  double y = 0;  // [mm] down
};

struct Colour {
  double red, green, blue;  // 0 to 1

  std::string hex() const;
};

// `share` of the way from one colour to the other.
Colour mixed(const Colour& from, const Colour& to, double share);

struct Stroke {
  Colour colour;
  double width;  // [mm]
  bool dashed = false;
  double opacity = 1;
};

enum class Anchor { start, middle, end };

class Svg {
 public:
  Svg(double width, double height);

  void polygon(std::span<const Spot> corners, const Colour& fill, const Stroke& edge);
  void line(std::span<const Spot> points, const Stroke& stroke);
  void circle(const Spot& centre, double radius, const Colour& fill, const Stroke& edge);
  // Size in points.
  void text(const Spot& at, std::string_view words, double size, Anchor anchor = Anchor::start);
  void label(const Spot& at, std::string_view words, double size, Anchor anchor = Anchor::start);
  // Left out where it would touch a number that is there.
  void number(const Spot& at, std::string_view digits, double size, Anchor anchor = Anchor::start);
  // The same with a white rim, to be read on any ground. False where it is left out.
  bool rimmed_number(const Spot& at, std::string_view digits, double size, Anchor anchor = Anchor::start);

  std::string finished() &&;

 private:
  void points(std::span<const Spot> spots);
  void set(const Spot& at, std::string_view spans, double size, Anchor anchor, std::string_view rim = "");
  bool takes(const Spot& at, std::string_view digits, double size, Anchor anchor);

  struct Area {
    Spot upper_left, lower_right;
  };
  std::vector<Area> numbers_;
  std::string text_;
};

}  // namespace patchgrip::cli
