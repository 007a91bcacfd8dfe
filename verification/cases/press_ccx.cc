#include <patchgrip/verification/cases/press_ccx.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include <patchgrip/verification/claims/press.h>
#include <patchgrip/verification/fe/calculix.h>
#include <patchgrip/verification/fe/half_space.h>

namespace patchgrip::verification {
namespace {

constexpr double hole = 0.003, strip_reach = 1.4, strip_height = 0.5, penalty = 1e4;

// Elements of the rigid strip along f(r), numbered after those of the half-space.
struct Strip {
  int first_node, count;

  int node(int along, int up) const { return first_node + 3 * along + up; }
  bool has(int along, int up) const { return along % 2 == 0 || up != 1; }  // no node in the middle of an element
};

}  // namespace

Solved solve_press_by_calculix(const Setting& setting) {
  const PressedBody body = pressed_paraboloid();
  const double modulus = contact::contact_modulus(body.material, contact::Material::rigid());
  const double extent = setting.extent, near = 1e-7 * extent;
  const QuadSection mesh = QuadSection::half_space(hole, extent, setting.elements);
  const int nodes = static_cast<int>(mesh.nodes.size()), elements = static_cast<int>(mesh.elements.size());
  const Strip strip{nodes + 1, static_cast<int>(strip_reach * setting.elements)};

  std::string input = "*NODE,NSET=NALL\n";
  const auto out = std::back_inserter(input);
  for (int i = 0; i < nodes; ++i) {
    const auto& p = mesh.nodes[static_cast<std::size_t>(i)];
    fmt::format_to(out, "{},{:.12g},{:.12g},0.\n", i + 1, p[0], p[1]);
  }
  std::string strip_nodes;
  for (int k = 0; k <= 2 * strip.count; ++k) {
    const double r = std::lerp(hole, strip_reach, k / (2. * strip.count));
    for (int up = 0; up < 3; ++up) {
      if (!strip.has(k, up)) continue;
      fmt::format_to(out, "{},{:.12g},{:.12g},0.\n", strip.node(k, up), r, body.height_at(r) + strip_height * up / 2);
      strip_nodes += fmt::format("{},\n", strip.node(k, up));
    }
  }
  input += "*ELEMENT,TYPE=CAX8R,ELSET=EB\n";
  std::string touched;  // faces of the half-space; sides are numbered from the first corner on
  for (int e = 0; e < elements; ++e) {
    const auto& element = mesh.elements[static_cast<std::size_t>(e)];
    fmt::format_to(out, "{}", e + 1);
    for (const std::size_t node : element) fmt::format_to(out, ",{}", node + 1);
    input += "\n";
    for (std::size_t side = 0; side < 4; ++side) {
      const auto& from = mesh.nodes[element[side]];
      const auto& to = mesh.nodes[element[(side + 1) % 4]];
      if (from[1] > -near && to[1] > -near && std::max(from[0], to[0]) < 1.35) {
        touched += fmt::format("{},S{}\n", e + 1, side + 1);
      }
    }
  }
  input += "*ELEMENT,TYPE=CAX8,ELSET=EM\n";
  std::string strip_faces;
  for (int k = 0; k < strip.count; ++k) {
    const int i = 2 * k;
    fmt::format_to(out, "{},{},{},{},{},{},{},{},{}\n", elements + k + 1, strip.node(i, 0), strip.node(i + 2, 0),
                   strip.node(i + 2, 2), strip.node(i, 2), strip.node(i + 1, 0), strip.node(i + 2, 1),
                   strip.node(i + 1, 2), strip.node(i, 1));
    strip_faces += fmt::format("{},S1\n", elements + k + 1);
  }
  input += "*NSET,NSET=NM\n" + strip_nodes + "*SURFACE,NAME=SS,TYPE=ELEMENT\n" + touched +
           "*SURFACE,NAME=SM,TYPE=ELEMENT\n" + strip_faces;
  fmt::format_to(out, "*MATERIAL,NAME=B\n*ELASTIC\n{:.12g},{}\n", body.material.youngs_modulus,
                 body.material.poisson_ratio);
  input += "*SOLID SECTION,ELSET=EB,MATERIAL=B\n*SOLID SECTION,ELSET=EM,MATERIAL=B\n*SURFACE INTERACTION,NAME=SI\n";
  fmt::format_to(out, "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR\n{:.8g}\n", penalty * modulus);
  input += "*CONTACT PAIR,INTERACTION=SI,TYPE=SURFACE TO SURFACE\nSS,SM\n*BOUNDARY\n";
  std::string far;
  for (int i = 0; i < nodes; ++i) {
    const auto& p = mesh.nodes[static_cast<std::size_t>(i)];
    const bool on_axis = p[0] < hole + near;
    if (on_axis) fmt::format_to(out, "{},1,1\n", i + 1);
    if (p[0] < extent - near && p[1] > -extent + near) continue;
    const Point u = boussinesq_section({p[0], p[1], 0}, body.force, body.material);
    if (!on_axis) far += fmt::format("{},1,1,{:.12g}\n", i + 1, u[0]);
    far += fmt::format("{},2,2,{:.12g}\n", i + 1, u[1]);
  }
  fmt::format_to(out, "*STEP,INC=1000\n*STATIC\n1.,1.\n*BOUNDARY\nNM,1,1,0.\nNM,2,2,{:.12g}\n", -body.approach);
  input += far + "*NODE PRINT,NSET=NM,TOTALS=ONLY\nRF\n*END STEP\n";

  constexpr double sectors = 180;
  Solved solved;
  solved.values = {{-sectors * run_calculix(input).total_force(1)}};
  solved.unknowns = 2 * mesh.nodes.size();
  return solved;
}

}  // namespace patchgrip::verification
