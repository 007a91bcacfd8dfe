#include <patchgrip/verification/fe/calculix_press.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

#include <patchgrip/verification/fe/half_space.h>

namespace patchgrip::verification {
namespace {

constexpr double rigid_height = 0.5, penalty = 100;

// Nodes of the rigid element, numbered after those of the half-space in ccx's order: halves along and up.
constexpr std::array<std::array<int, 2>, 8> rigid_nodes{
    {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}}};

int first_rigid_node(const CalculixPress& press) { return static_cast<int>(press.section.nodes.size()) + 1; }

double near(const CalculixPress& press) { return 1e-7 * press.extent; }

}  // namespace

std::string CalculixPress::bodies(const std::vector<std::string>& element_sets) const {
  const int first = first_rigid_node(*this);
  std::string input = "*NODE,NSET=NALL\n";
  const auto out = std::back_inserter(input);
  for (int i = 0; i + 1 < first; ++i) {
    const auto& p = section.nodes[static_cast<std::size_t>(i)];
    fmt::format_to(out, "{},{:.12g},{:.12g},0.\n", i + 1, p[0], p[1]);
  }
  std::string rigid;  // their numbers
  for (std::size_t k = 0; k < rigid_nodes.size(); ++k) {
    const auto [along, up] = rigid_nodes[k];
    const double r = std::lerp(hole, rigid_reach, along / 2.);
    const int node = first + static_cast<int>(k);
    fmt::format_to(out, "{},{:.12g},{:.12g},0.\n", node, r, height(r) + rigid_height * up / 2);
    rigid += fmt::format(",{}", node);
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
  ++number;
  return input + fmt::format("*ELEMENT,TYPE=CAX8,ELSET=RIGID\n{}{}\n", number, rigid) +
         fmt::format("*NSET,NSET=RIGID\n{}\n*NSET,NSET=REFERENCE\n{}\n", rigid.substr(1), first) +
         "*SURFACE,NAME=TOUCHED,TYPE=ELEMENT\n" + touched +
         fmt::format("*SURFACE,NAME=TOUCHING,TYPE=ELEMENT\n{},S1\n", number);
}

std::string CalculixPress::contact(double contact_modulus) const {
  return fmt::format(
      "*SURFACE INTERACTION,NAME=NORMAL\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR\n{:.8g}\n"
      "*CONTACT PAIR,INTERACTION=NORMAL,TYPE=SURFACE TO SURFACE\nTOUCHED,TOUCHING\n",
      penalty * elements * elements * contact_modulus);
}

std::string CalculixPress::rigid_as_one() const {
  const int first = first_rigid_node(*this);
  std::string equations;
  for (int k = 1; k < static_cast<int>(rigid_nodes.size()); ++k) {
    equations += fmt::format("*EQUATION\n2\n{},2,1.,{},2,-1.\n", first + k, first);
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
