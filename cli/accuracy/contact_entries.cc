// Section entries: one problem each, by name, with inputs and outputs (contact_kinds.h). Errors are relative to the
// size of the output itself; where that is 0, absolute.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include <patchgrip/cli/accuracy/contact_kinds.h>
#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

constexpr std::array all_inputs{Inputs::rounded, Inputs::narrow_before, Inputs::narrow_beyond, Inputs::wide_before,
                                Inputs::wide_beyond};

using Outputs = std::optional<std::vector<Output>>;  // nothing where the library refuses the inputs

struct Problem {
  const ContactKind* kind;
  TableObject inputs;
  TableObject outputs;
  std::vector<std::string> asked;
};

std::vector<std::string> names_of(const TableNode& object) {
  std::vector<std::string> names;
  for (const TableMember& member : object.value().members) names.push_back(member.name);
  return names;
}

Outputs evaluate(Problem& problem, Inputs inputs) {
  try {
    return problem.kind->evaluate(EntryInputs(problem.inputs, problem.asked, inputs));
  } catch (const TableError&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

const Output* find(const Outputs& outputs, std::string_view name) {
  if (!outputs) return nullptr;
  const auto output = std::ranges::find(*outputs, name, &Output::name);
  return output == outputs->end() ? nullptr : &*output;
}

Exact reference_value(const TableNode& node) {
  TableObject output(node);
  output.find("unit");
  const TableNode value = output["value"];
  if (value.value().kind == TableValue::Kind::boolean) return value.value().text == "true" ? 1 : 0;
  return value.number();
}

Measured<1> measured(const std::array<Outputs, all_inputs.size()>& results, std::string_view name) {
  const auto effect = [&](Inputs before, Inputs beyond) -> std::array<double, 1> {
    const Output* q0 = find(results[static_cast<std::size_t>(before)], name);
    const Output* q1 = find(results[static_cast<std::size_t>(beyond)], name);
    if (q0 == nullptr || q1 == nullptr) return {};
    return {(q1->value - q0->value) / (2 * input_steps[static_cast<std::size_t>(beyond)])};
  };
  return {{find(results.front(), name)->value},
          effect(Inputs::narrow_before, Inputs::narrow_beyond),
          effect(Inputs::wide_before, Inputs::wide_beyond)};
}

void compare_problem(Problem& problem, AccuracyReport& report) {
  std::array<Outputs, all_inputs.size()> results;
  for (const Inputs inputs : all_inputs) results[static_cast<std::size_t>(inputs)] = evaluate(problem, inputs);
  const std::string section(problem.kind->name);
  for (const std::string& name : problem.asked) {
    const TableNode node = problem.outputs[name];
    const Exact reference = reference_value(node);
    const Exact scale = reference == 0 ? Exact(1) : abs(reference);
    if (!results.front()) {
      report.add({section, "", name}, failed, node.place());
    } else if (find(results.front(), name) == nullptr) {
      report.not_covered(section, fmt::format("output '{}'", printable(name)));
    } else {
      report.add({section, "", name}, deviation(measured(results, name), 0, reference, scale), node.place());
    }
  }
  for (const std::string& name : problem.inputs.unread()) {
    report.not_covered(section, fmt::format("input '{}'", printable(name)));
  }
}

void compare_entry(const TableNode& node, AccuracyReport& report) {
  TableObject fields(node);
  const std::string name = fields["name"].text();
  const auto kind = std::ranges::find(contact_kinds(), std::string_view(name), &ContactKind::name);
  if (kind == contact_kinds().end()) {
    report.not_covered(node.place().substr(0, node.place().find('[')), fmt::format("'{}'", printable(name)));
    return;
  }
  const TableNode named = node.named(name);
  TableObject entry(named);
  const TableNode outputs = entry["outputs"];
  Problem problem{&*kind, TableObject(entry["inputs"]), TableObject(outputs), names_of(outputs)};
  compare_problem(problem, report);
  for (const std::string_view remark : {"name", "formula", "agree_rel"}) entry.find(remark);
  name_unread(entry, kind->name, report);
}

}  // namespace

void compare_contact_entries(const TableNode& section, AccuracyReport& report) {
  for (const TableNode& node : section.filled()) compare_entry(node, report);
}

}  // namespace patchgrip::cli
