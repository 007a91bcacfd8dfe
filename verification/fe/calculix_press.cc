#include <patchgrip/verification/fe/calculix_press.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include <patchgrip/verification/fe/half_space.h>

namespace patchgrip::verification {
namespace {

constexpr double rigid_height = 0.5, penalty = 100;

// Nodes of the rigid strip, numbered after those of the half-space: two intervals an element, two layers.
struct Strip {
  int first_node, intervals;

  int node(int along, int up) const { return first_node + 3 * along + up; }
  bool has(int along, int up) const { return along % 2 == 0 || up != 1; }  // no node in the middle of an element
};

Strip strip_of(const CalculixPress& press) {
  return {static_cast<int>(press.section.nodes.size()) + 1, 2 * press.rigid_elements};
}

double near(const CalculixPress& press) { return 1e-7 * press.extent; }

}  // namespace

std::vector<double> smooth_values_at(const std::vector<std::pair<Point, double>>& line,
                                     const std::vector<double>& radii) {
  std::vector<double> values;
  for (const double r : radii) {
    const auto is_beyond = [&](const auto& node) { return node.first[0] >= r; };
    const auto last = std::find_if(line.begin() + 2, line.end() - 1, is_beyond);
    double value = 0;
    for (auto one = last - 2; one <= last; ++one) {
      double share = 1;
      for (auto other = last - 2; other <= last; ++other) {
        if (other != one) share *= (r - other->first[0]) / (one->first[0] - other->first[0]);
      }
      value += share * one->second;
    }
    values.push_back(value);
  }
  return values;
}

std::string CalculixPress::bodies(const std::vector<std::string>& element_sets) const {
  const Strip strip = strip_of(*this);
  std::string input = "*NODE,NSET=NALL\n";
  const auto out = std::back_inserter(input);
  for (int i = 0; i + 1 < strip.first_node; ++i) {
    const auto& p = section.nodes[static_cast<std::size_t>(i)];
    fmt::format_to(out, "{},{:.12g},{:.12g},0.\n", i + 1, p[0], p[1]);
  }
  std::string rigid_nodes;
  for (int k = 0; k <= strip.intervals; ++k) {
    const double r = std::lerp(hole, rigid_reach, static_cast<double>(k) / strip.intervals);
    for (int up = 0; up < 3; ++up) {
      if (!strip.has(k, up)) continue;
      fmt::format_to(out, "{},{:.12g},{:.12g},0.\n", strip.node(k, up), r, height(r) + rigid_height * up / 2);
      rigid_nodes += fmt::format("{},\n", strip.node(k, up));
    }
  }
  int number = 0;
  std::string touched;  // sides are numbered from the first corner on
  for (const auto& set : element_sets) {
    input += "*ELEMENT,TYPE=CAX8R,ELSET=" + set + "\n";
    for (const auto& element : section.elements) {
      fmt::format_to(out, "{}", ++number);
      for (const std::size_t node : element) fmt::format_to(out, ",{}", node + 1);
      input += "\n";
      for (std::size_t side = 0; side < 4 && set == element_sets.front(); ++side) {
        const auto& from = section.nodes[element[side]];
        const auto& to = section.nodes[element[(side + 1) % 4]];
        if (std::min(from[1], to[1]) > -near(*this) && std::max(from[0], to[0]) < touched_reach + near(*this)) {
          touched += fmt::format("{},S{}\n", number, side + 1);
        }
      }
    }
  }
  input += "*ELEMENT,TYPE=CAX8,ELSET=RIGID\n";
  std::string touching;
  for (int i = 0; i < strip.intervals; i += 2) {
    fmt::format_to(out, "{},{},{},{},{},{},{},{},{}\n", ++number, strip.node(i, 0), strip.node(i + 2, 0),
                   strip.node(i + 2, 2), strip.node(i, 2), strip.node(i + 1, 0), strip.node(i + 2, 1),
                   strip.node(i + 1, 2), strip.node(i, 1));
    touching += fmt::format("{},S1\n", number);
  }
  return input + "*NSET,NSET=RIGID\n" + rigid_nodes + fmt::format("*NSET,NSET=REFERENCE\n{}\n", strip.first_node) +
         "*SURFACE,NAME=TOUCHED,TYPE=ELEMENT\n" + touched + "*SURFACE,NAME=TOUCHING,TYPE=ELEMENT\n" + touching;
}

std::string CalculixPress::contact(double contact_modulus) const {
  return fmt::format(
      "*SURFACE INTERACTION,NAME=NORMAL\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR\n{:.8g}\n"
      "*CONTACT PAIR,INTERACTION=NORMAL,TYPE=SURFACE TO SURFACE\nTOUCHED,TOUCHING\n",
      penalty * elements * elements * contact_modulus);
}

std::string CalculixPress::rigid_as_one() const {
  const Strip strip = strip_of(*this);
  std::string equations;
  for (int k = 0; k <= strip.intervals; ++k) {
    for (int up = 0; up < 3; ++up) {
      if (!strip.has(k, up) || strip.node(k, up) == strip.first_node) continue;
      equations += fmt::format("*EQUATION\n2\n{},2,1.,{},2,-1.\n", strip.node(k, up), strip.first_node);
    }
  }
  return equations;
}

std::string CalculixPress::held() const {
  std::string lines = "RIGID,1,1\n";
  for (std::size_t i = 0; i < section.nodes.size(); ++i) {
    if (section.nodes[i][0] < hole + near(*this)) lines += fmt::format("{},1,1\n", i + 1);
  }
  return lines;
}

std::string CalculixPress::far_field(double force, const contact::Material& material) const {
  std::string lines;
  for (std::size_t i = 0; i < section.nodes.size(); ++i) {
    const auto& p = section.nodes[i];
    if (p[0] < extent - near(*this) && p[1] > -extent + near(*this)) continue;
    const Point u = boussinesq_section({p[0], p[1], 0}, force, material);
    if (p[0] > hole + near(*this)) lines += fmt::format("{},1,1,{:.12g}\n", i + 1, u[0]);
    lines += fmt::format("{},2,2,{:.12g}\n", i + 1, u[1]);
  }
  return lines;
}

std::vector<std::pair<Point, double>> CalculixPress::pressure(const CalculixResult& result) const {
  const auto stress = result.field("STRESS", 1);
  std::vector<std::pair<Point, double>> line;
  for (const auto& element : section.elements) {
    for (const std::size_t middle : std::span(element).last(4)) {
      const auto& [r, z] = section.nodes[middle];
      if (z > -near(*this) && r < touched_reach)
        line.emplace_back(Point{r, 0, 0}, -stress.at(static_cast<int>(middle) + 1));
    }
  }
  std::sort(line.begin(), line.end());
  return line;
}

}  // namespace patchgrip::verification
