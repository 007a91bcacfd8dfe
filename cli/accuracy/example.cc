// Section misc.example_4_8: a block with a rectangular base, pressed on a turning disc whose centre is the pole (seed,
// Example 4.8). Lengths come in multiples of L, and L = 1 m here.
#include <fmt/format.h>

#include <array>
#include <string>

#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/friction/law.h>
#include <patchgrip/friction/rectangle.h>

namespace patchgrip::cli {
namespace {

// "2L", "L", "-1.5 L", "L/2", "0"
Exact multiple_of_L(const TableNode& node, std::string_view text) {
  std::string plain;
  for (const char c : text) {
    if (c != ' ') plain += c;
  }
  const std::size_t at = plain.find('L');
  if (at != std::string::npos) {
    const bool bare = at == 0 || plain[at - 1] == '-' || plain[at - 1] == '+';
    plain = fmt::format("{}{}{}", plain.substr(0, at), bare ? "1" : "", plain.substr(at + 1));
  }
  const auto value = parse_exact(plain);
  if (!value || (at == std::string::npos && *value != 0)) node.fail("a multiple of L is expected");
  return *value;
}

// "(0,L)"
std::array<Exact, 2> pole(const TableNode& node) {
  const std::string text = node.text();
  const std::size_t comma = text.find(',');
  if (!text.starts_with('(') || !text.ends_with(')') || comma == std::string::npos) {
    node.fail("a pole such as '(0,L)' is expected");
  }
  const std::string_view inner = std::string_view(text).substr(1, text.size() - 2);
  return {multiple_of_L(node, inner.substr(0, comma - 1)), multiple_of_L(node, inner.substr(comma))};
}

}  // namespace

void compare_example_4_8(const TableNode& node, AccuracyReport& report) {
  constexpr std::string_view section = "misc.example_4_8";
  TableObject fields(node);
  const Exact l_xi = multiple_of_L(fields["l_xi"], fields["l_xi"].text());
  const Exact l_eta = multiple_of_L(fields["l_eta"], fields["l_eta"].text());
  if (!(l_xi > 0 && l_eta > 0)) node.fail("l_xi and l_eta: positive multiples of L are expected");
  const auto M = pole(fields["pole"]);

  const auto q = measure([&](Inputs inputs) {
    const auto rectangle = friction::Rectangle::of_sides(as_double(l_xi, inputs), as_double(l_eta, inputs));
    const friction::Pole at{as_double(M[0], inputs), as_double(M[1], inputs)};
    const auto v = friction::twist_about(at, 1);
    const auto g = rectangle.gradient(v);
    return std::array{g.fx, g.m, g.m - at.x * g.fy + at.y * g.fx, mean_square_speed(rectangle.moments(), v)};
  });
  constexpr std::array<const char*, 4> names{"I1", "aK_I3_over_L", "disc_moment_over_muFNL", "vm2_over_L2w2"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Exact reference = fields[names[i]].number();
    report.add({std::string(section), "rectangle_uniform", names[i]},
               deviation(q, i, reference, reference == 0 ? Exact(1) : abs(reference)), node.place());
  }
  name_unread(fields, section, report);
}

}  // namespace patchgrip::cli
