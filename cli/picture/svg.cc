#include <patchgrip/cli/picture/svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <patchgrip/cli/picture/escaped.h>

namespace patchgrip::cli {
namespace {

constexpr double mm_per_point = 25.4 / 72;

int byte_of(double share) { return static_cast<int>(std::lround(255 * std::clamp(share, 0., 1.))); }

// Markup to spans: the first bytes of a character of UTF-8 are not 10xxxxxx.
std::string spans_of(std::string_view words) {
  std::string spans;
  double back = 0;  // [em], to the line again
  while (!words.empty()) {
    const bool lower = words.front() == '_';
    const bool italic = words.front() == '*';
    if ((lower || italic) && words.size() > 1) words.remove_prefix(1);
    std::size_t length = 1;
    while (length < words.size() && (static_cast<unsigned char>(words[length]) & 0xc0) == 0x80) ++length;
    const std::string shown = escaped(words.substr(0, length));
    words.remove_prefix(length);
    if (lower) {
      spans += fmt::format("<tspan font-size=\"70%\" font-style=\"italic\" dy=\"0.35em\">{}</tspan>", shown);
      back = 0.35 * 0.7;
    } else if (italic || back != 0) {
      spans += fmt::format("<tspan{}{}>{}</tspan>", italic ? " font-style=\"italic\"" : "",
                           back != 0 ? fmt::format(" dy=\"{:g}em\"", -back) : "", shown);
      back = 0;
    } else {
      spans += shown;
    }
  }
  return spans;
}

std::string attributes_of(const Stroke& stroke) {
  return fmt::format("stroke=\"{}\" stroke-width=\"{:.2f}\" stroke-linejoin=\"round\"{}{}", stroke.colour.hex(),
                     stroke.width, stroke.dashed ? " stroke-dasharray=\"0.8 0.6\"" : "",
                     stroke.opacity < 1 ? fmt::format(" stroke-opacity=\"{:.2f}\"", stroke.opacity) : "");
}

}  // namespace

std::string Colour::hex() const {
  return fmt::format("#{:02X}{:02X}{:02X}", byte_of(red), byte_of(green), byte_of(blue));
}

Colour mixed(const Colour& from, const Colour& to, double share) {
  return {std::lerp(from.red, to.red, share), std::lerp(from.green, to.green, share),
          std::lerp(from.blue, to.blue, share)};
}

Svg::Svg(double width, double height)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
                        "viewBox=\"0 0 {0} {1}\" font-family=\"DejaVu Sans, sans-serif\">\n"
                        "<rect width=\"{0}\" height=\"{1}\" fill=\"#FFFFFF\"/>\n",
                        width, height)) {}

void Svg::points(std::span<const Spot> spots) {
  for (const Spot& spot : spots) fmt::format_to(std::back_inserter(text_), "{:.2f},{:.2f} ", spot.x, spot.y);
  text_.back() = '"';
}

void Svg::polygon(std::span<const Spot> corners, const Colour& fill, const Stroke& edge) {
  text_ += "<polygon points=\"";
  points(corners);
  text_ += fmt::format(" fill=\"{}\" {}/>\n", fill.hex(), attributes_of(edge));
}

void Svg::line(std::span<const Spot> spots, const Stroke& stroke) {
  if (spots.size() < 2) return;
  text_ += "<polyline points=\"";
  points(spots);
  text_ += fmt::format(" fill=\"none\" {}/>\n", attributes_of(stroke));
}

void Svg::circle(const Spot& centre, double radius, const Colour& fill, const Stroke& edge) {
  text_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\" {}/>\n", centre.x, centre.y,
                       radius, fill.hex(), attributes_of(edge));
}

void Svg::set(const Spot& at, std::string_view spans, double size, Anchor anchor, std::string_view rim) {
  constexpr std::array<std::string_view, 3> anchors{"start", "middle", "end"};
  text_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\" text-anchor=\"{}\"{}>{}</text>\n", at.x,
                       at.y, size * mm_per_point, anchors[static_cast<std::size_t>(anchor)], rim, spans);
}

void Svg::text(const Spot& at, std::string_view words, double size, Anchor anchor) {
  set(at, escaped(words), size, anchor);
}

void Svg::label(const Spot& at, std::string_view words, double size, Anchor anchor) {
  set(at, spans_of(words), size, anchor);
}

bool Svg::takes(const Spot& at, std::string_view digits, double size, Anchor anchor) {
  constexpr double digit_width = 0.64, digit_height = 0.73;  // [em], of DejaVu Sans
  constexpr double gap = 0.3;                                // [mm]
  const double em = size * mm_per_point;
  const double width = digit_width * em * static_cast<double>(digits.size());
  const double left = at.x - (anchor == Anchor::start ? 0 : anchor == Anchor::middle ? width / 2 : width);
  const Area area{{left, at.y - digit_height * em}, {left + width, at.y}};
  const bool touches = std::ranges::any_of(numbers_, [&](const Area& other) {
    return area.upper_left.x < other.lower_right.x + gap && other.upper_left.x < area.lower_right.x + gap &&
           area.upper_left.y < other.lower_right.y + gap && other.upper_left.y < area.lower_right.y + gap;
  });
  if (!touches) numbers_.push_back(area);
  return !touches;
}

void Svg::number(const Spot& at, std::string_view digits, double size, Anchor anchor) {
  if (takes(at, digits, size, anchor)) set(at, digits, size, anchor);
}

bool Svg::rimmed_number(const Spot& at, std::string_view digits, double size, Anchor anchor) {
  if (!takes(at, digits, size, anchor)) return false;
  set(at, digits, size, anchor, " stroke=\"#FFFFFF\" stroke-width=\"0.6\" stroke-linejoin=\"round\"");
  set(at, digits, size, anchor);
  return true;
}

std::string Svg::finished() && {
  text_ += "</svg>\n";
  return std::move(text_);
}

}  // namespace patchgrip::cli
