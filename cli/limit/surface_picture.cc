#include <patchgrip/cli/limit/surface_picture.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/picture/colours.h>
#include <patchgrip/cli/picture/picture_axes.h>
#include <patchgrip/cli/picture/svg.h>
#include <patchgrip/cli/progress.h>

namespace patchgrip::cli {
namespace {

constexpr double width = 120, height = 110;  // [mm]

constexpr Colour pale{0.91, 0.91, 0.91};
constexpr Colour hidden{0.5, 0.5, 0.5};

friction::Wrench scaled(const friction::Wrench& t, double share) { return {share * t.fx, share * t.fy, share * t.m}; }

// How much of a load is drawn: of one that is far outside, the way to 1.6 times the surface.
double shown_part(const LoadAnswer& load) {
  constexpr double farthest = 1.6;
  return load.verdict == Verdict::slips ? std::min(1., farthest * load.margin.value) : load.margin.value;
}

SpacePoint unit_vector(const SpacePoint& p) {
  const double length = std::hypot(p[0], p[1], p[2]);
  return {p[0] / length, p[1] / length, p[2] / length};
}

double dot(const SpacePoint& a, const SpacePoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Twice the area on the page, positive where the corners run counter-clockwise to the eye.
double signed_area(const std::array<Spot, 4>& c) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Spot& a = c[i];
    const Spot& b = c[(i + 1) % 4];
    sum -= a.x * b.y - a.y * b.x;
  }
  return sum;
}

Colour slip_colour(double share) {
  return share < 0.5 ? mixed(orange, pale, 2 * share) : mixed(pale, blue, 2 * share - 1);
}

// Ambient and diffuse light, and a gloss.
Colour lit(const Colour& colour, const SpacePoint& normal, const View& view) {
  SpacePoint light, half;
  for (std::size_t i = 0; i < 3; ++i) {
    light[i] = -0.45 * view.right()[i] + 0.6 * view.up()[i] + 0.75 * view.towards_viewer()[i];
  }
  light = unit_vector(light);
  for (std::size_t i = 0; i < 3; ++i) half[i] = light[i] + view.towards_viewer()[i];
  const double diffuse = std::max(0., dot(normal, light));
  const double gloss = 0.22 * std::pow(std::max(0., dot(normal, unit_vector(half))), 24);
  return mixed(mixed(black, colour, 0.5 + 0.5 * diffuse), white, gloss);
}

struct NumberedLoad {
  std::size_t number;
  const LoadAnswer& load;
};

// Rising numbers as "2, 4-7, 9", cut where that is long.
std::string in_runs(const std::vector<std::size_t>& numbers) {
  constexpr std::size_t longest = 10;
  std::string text;
  for (std::size_t first = 0, next = 0; first < numbers.size(); first = next) {
    while (next < numbers.size() && numbers[next] == numbers[first] + (next - first)) ++next;
    if (text.size() > longest) return text + ", ...";
    if (!text.empty()) text += ", ";
    text += fmt::format("{}", numbers[first]);
    if (next - first > 1) text += fmt::format("{}{}", next - first > 2 ? "-" : ", ", numbers[next - 1]);
  }
  return text;
}

struct Picture {
  const LimitMesh& mesh;
  View view;
  Svg svg{width, height};

  SpacePoint in_space(const friction::Wrench& t) const { return {t.fx, t.fy, t.m / mesh.length}; }

  SpacePoint normal(const friction::Twist& v) const { return unit_vector({v.vx, v.vy, mesh.length * v.w}); }

  bool faces_viewer(const friction::Twist& v) const { return dot(normal(v), view.towards_viewer()) > 0; }

  void draw_cells() {
    // Every fourth line of the net at the default numbers.
    const int meridian_step = std::max(1, mesh.meridians / 24);
    const int parallel_step = std::max(1, mesh.parallels / 12);
    const Stroke net{black, 0.1, false, 0.35};
    struct Edge {
      Spot from, to;
    };
    std::vector<Edge> edges;
    Progress progress("picture", static_cast<std::size_t>(mesh.parallels), Progress::wanted(Progress::no_output));
    for (int i = 0; i < mesh.parallels; ++i) {
      InterruptGuard::check();
      progress.at(static_cast<std::size_t>(i));
      for (int j = 0; j < mesh.meridians; ++j) {
        const LimitMesh::Cell cell = mesh.cell(i, j);
        std::array<Spot, 4> corners;
        SpacePoint mean{};
        double share = 0;
        for (std::size_t c = 0; c < 4; ++c) {
          const LimitPoint& point = mesh.points[cell[c]];
          corners[c] = view(in_space(point.wrench.value));
          const SpacePoint n = normal(point.slip);
          for (std::size_t k = 0; k < 3; ++k) mean[k] += n[k];
          share += 0.25 * mesh.pole_share(point.slip);
        }
        if (!(signed_area(corners) > 0)) continue;
        const Colour colour = lit(slip_colour(share), unit_vector(mean), view);
        svg.polygon(corners, colour, {colour, 0.15});
        if (j % meridian_step == 0) edges.push_back({corners[0], corners[1]});
        if (i % parallel_step == 0) edges.push_back({corners[0], corners[3]});
      }
    }
    for (const Edge& edge : edges) svg.line(std::array{edge.from, edge.to}, net);
  }

  // Returns where the mark is.
  Spot draw_load(const LoadAnswer& load) {
    constexpr double radius = 0.9;
    const Spot passed = view(in_space(scaled(load.load, load.margin.value)));
    const bool seen = faces_viewer(load.gauge.twist);
    Spot marked = passed;
    if (load.verdict == Verdict::slips) {
      const double part = shown_part(load);
      marked = view(in_space(scaled(load.load, part)));
      svg.line(std::array{passed, marked}, {vermilion, 0.35, !seen});
      if (part == 1) svg.circle(marked, radius, vermilion, {white, 0.15});
    } else {
      const Colour edge = load.verdict == Verdict::undecided ? vermilion : seen ? black : hidden;
      svg.circle(passed, radius, white, {edge, 0.3, !seen});
    }
    return marked;
  }

  void draw_loads(const std::vector<NumberedLoad>& loads) {
    constexpr double together = 0.5;  // [mm]
    struct Mark {
      Spot at;
      std::vector<std::size_t> numbers;
    };
    std::vector<Mark> marks;
    for (const auto& [number, load] : loads) {
      const Spot at = draw_load(load);
      const auto same = std::ranges::find_if(
          marks, [&](const Mark& mark) { return std::hypot(mark.at.x - at.x, mark.at.y - at.y) < together; });
      if (same == marks.end()) {
        marks.push_back({at, {number}});
      } else {
        same->numbers.push_back(number);
      }
    }
    for (const Mark& mark : marks) {
      const std::string numbers = in_runs(mark.numbers);
      for (const auto& [right, down, anchor] : {std::tuple{1.4, -1., Anchor::start},
                                                {1.4, 3., Anchor::start},
                                                {-1.4, -1., Anchor::end},
                                                {-1.4, 3., Anchor::end}}) {
        if (svg.rimmed_number({mark.at.x + right, mark.at.y + down}, numbers, 8, anchor)) break;
      }
    }
  }

  void draw_legend(const std::vector<NumberedLoad>& loads) {
    constexpr double left = 20, top = height - 11, length = 80, thickness = 3;
    constexpr int steps = 80;
    for (int i = 0; i < steps; ++i) {
      const double x = left + length * i / steps;
      const double next = left + length * (i + 1) / steps;
      const Colour colour = slip_colour((i + 0.5) / steps);
      svg.polygon(std::array{Spot{x, top}, Spot{next, top}, Spot{next, top + thickness}, Spot{x, top + thickness}},
                  colour, {colour, 0.1});
    }
    constexpr std::array<std::pair<double, std::string_view>, 5> marks{
        {{0, "0"}, {1. / 3, "1/2"}, {0.5, "1"}, {2. / 3, "2"}, {1, "∞"}}};
    for (const auto& [at, words] : marks) {
      svg.text({left + length * at, top + thickness + 3.6}, words, 8, Anchor::middle);
    }
    svg.text({left, top - 1.4}, "distance of the pole from the centroid / radius of gyration", 8);
    double y = 9;
    const auto entry = [&](std::string_view words, const Colour& fill, const Stroke& edge) {
      svg.circle({width - 38, y}, 0.9, fill, edge);
      svg.text({width - 36, y + 1}, words, 8);
      y += 4.5;
    };
    const auto some = [&](Verdict verdict) {
      return std::ranges::any_of(loads, [=](const NumberedLoad& one) { return one.load.verdict == verdict; });
    };
    if (some(Verdict::holds)) entry("a load that holds", white, {black, 0.3});
    if (some(Verdict::slips)) entry("a load that slips", vermilion, {white, 0.15});
    if (some(Verdict::undecided)) entry("a load, undecided", white, {vermilion, 0.3});
  }
};

// 10^(3 n) up to `size`, and its prefix; none far away.
struct Prefix {
  static Prefix of(double size) {
    constexpr std::array<std::string_view, 11> names{"f", "p", "n", "µ", "m", "", "k", "M", "G", "T", "P"};
    const double power = std::floor(std::log10(size) / 3 + 1e-9);
    if (!(std::fabs(power) <= 5)) return {1, ""};
    return {std::pow(10, 3 * power), names[static_cast<std::size_t>(power + 5)]};
  }

  double factor;
  std::string_view name;
};

Axis axis_of(double low, double high, double unit, std::string_view quantity, std::string_view of, bool with_prefix) {
  const Prefix prefix = with_prefix ? Prefix::of(std::max(std::fabs(low), std::fabs(high))) : Prefix{1, ""};
  std::string label(quantity);
  if (!of.empty()) label += fmt::format(" [{}{}]", prefix.name, of);
  return {Ticks::between(low / prefix.factor, high / prefix.factor), prefix.factor * unit, std::move(label)};
}

}  // namespace

std::string picture_of(const LimitMesh& mesh, const PictureRequest& request) {
  Picture picture{mesh, View(request.azimuth, request.elevation)};
  std::array<double, 3> low{}, high{};
  const auto include = [&](const friction::Wrench& t) {
    const std::array<double, 3> values{t.fx, t.fy, t.m};
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], values[i]);
      high[i] = std::max(high[i], values[i]);
    }
  };
  for (const LimitPoint& point : mesh.points) include(point.wrench.value);
  const bool per = !request.capacity;
  std::vector<NumberedLoad> loads;
  for (std::size_t i = 0; !per && i < request.loads.size(); ++i) {
    if (request.loads[i].loaded()) loads.push_back({i + 1, request.loads[i]});
  }
  for (const NumberedLoad& one : loads) include(scaled(one.load.load, shown_part(one.load)));
  const std::array<Axis, 3> axes{
      axis_of(low[0], high[0], 1, per ? "*f_x / *µ*F_N" : "*f_x", per ? "" : "N", !per),
      axis_of(low[1], high[1], 1, per ? "*f_y / *µ*F_N" : "*f_y", per ? "" : "N", !per),
      axis_of(low[2], high[2], 1 / mesh.length, per ? "*m / *µ*F_N" : "*m", per ? "m" : "N m", true)};
  SpacePoint least, most;
  for (std::size_t i = 0; i < 3; ++i) {
    least[i] = axes[i].ticks.low * axes[i].unit;
    most[i] = axes[i].ticks.high * axes[i].unit;
  }
  picture.view.fit(least, most, {24, 12}, width - 34, height - 42);
  if (!request.title.empty()) picture.svg.text({4, 6}, request.title, 9);
  draw_box(picture.svg, picture.view, axes);
  picture.draw_cells();
  picture.draw_loads(loads);
  picture.draw_legend(loads);
  return std::move(picture.svg).finished();
}

}  // namespace patchgrip::cli
