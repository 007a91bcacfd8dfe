#include <patchgrip/cli/accuracy/node.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

struct LengthUnit {
  std::string_view name;
  std::string_view metres;
};

constexpr std::array<LengthUnit, 5> length_units{
    {{"m", "1"}, {"mm", "1e-3"}, {"cm", "1e-2"}, {"um", "1e-6"}, {"km", "1e3"}}};

constexpr std::array<std::string_view, 8> remarks{"name",   "id",    "note",  "definition",
                                                  "digits", "model", "route", "verification"};

bool is_remark(std::string_view field) {
  return std::find(remarks.begin(), remarks.end(), field) != remarks.end() || field.ends_with("_note");
}

std::string in_words(const TableValue& value) {
  switch (value.kind) {
    case TableValue::Kind::null:
      return "null";
    case TableValue::Kind::list:
      return fmt::format("a list of {}", value.items.size());
    case TableValue::Kind::object:
      return "an object";
    default:
      return fmt::format("'{}'", printable(value.text));
  }
}

}  // namespace

TableNode::TableNode(const TableValue& value, std::string file, std::string place)
    : value_(&value), file_(std::move(file)), place_(std::move(place)) {}

void TableNode::fail(std::string_view message) const {
  const std::string where = place_.empty() ? "the table" : place_;
  throw TableError(fmt::format("{}: {} = {}: {}", printable(file_, file_.size()), where, in_words(*value_), message));
}

TableNode TableNode::member(std::string_view name, const TableValue& value) const {
  const std::string safe = printable(name);
  return {value, file_,
          place_.empty() ? safe : fmt::format("{}{}{}", place_, place_.ends_with('\'') ? " " : ".", safe)};
}

TableNode TableNode::named(std::string_view name) const {
  return {*value_, file_, fmt::format("{} '{}'", place_, printable(name))};
}

TableNode TableNode::with(const TableValue& value) const { return {value, file_, place_}; }

TableNode TableNode::item(std::size_t index) const {
  return {value_->items[index], file_, fmt::format("{}[{}]", place_, index)};
}

std::vector<TableNode> TableNode::items() const {
  if (!is_list()) fail("a list is expected");
  std::vector<TableNode> nodes;
  nodes.reserve(value_->items.size());
  for (std::size_t i = 0; i < value_->items.size(); ++i) nodes.push_back(item(i));
  return nodes;
}

std::vector<TableNode> TableNode::items(std::size_t count) const {
  if (!is_list() || value_->items.size() != count) fail(fmt::format("a list of {} is expected", count));
  return items();
}

std::vector<TableNode> TableNode::filled() const {
  if (is_list() && value_->items.empty()) fail("a list that is not empty is expected");
  return items();
}

std::string TableNode::text() const {
  if (value_->kind != TableValue::Kind::text) fail("a text is expected");
  return value_->text;
}

Exact TableNode::number() const {
  if (value_->kind == TableValue::Kind::text || value_->kind == TableValue::Kind::number) {
    if (const auto value = parse_exact(value_->text)) {
      if (abs(*value) > std::numeric_limits<double>::max()) fail("too large for a double");
      return *value;
    }
  }
  fail("not a number");
}

Exact TableNode::positive() const {
  Exact value = number();
  if (!(value > 0)) fail("a positive number is expected");
  return value;
}

std::vector<Exact> TableNode::numbers(std::size_t count) const {
  std::vector<Exact> values;
  for (const TableNode& node : items(count)) values.push_back(node.number());
  return values;
}

std::optional<Exact> TableNode::number_unless_infinite() const {
  const std::string& text = value_->text;
  const bool infinite = value_->kind == TableValue::Kind::null ||
                        (value_->kind == TableValue::Kind::text && (text == "inf" || text == "+inf" || text == "-inf"));
  return infinite ? std::nullopt : std::optional(number());
}

TableObject::TableObject(const TableNode& node) : node_(node), read_(node.value().members.size()) {
  if (!node.is_object()) node.fail("an object is expected");
}

std::optional<TableNode> TableObject::find(std::string_view name) {
  const auto& members = node_.value().members;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].name != name) continue;
    read_[i] = true;
    return node_.member(name, members[i].value);
  }
  return std::nullopt;
}

TableNode TableObject::operator[](std::string_view name) {
  if (auto node = find(name)) return *std::move(node);
  node_.fail(fmt::format("the field '{}' is missing", name));
}

TableNode TableObject::symbol(std::string_view name) {
  const std::string definition = fmt::format("{}=", name);
  for (const auto& [field, value] : node_.value().members) {
    if (field.starts_with(definition)) return *find(field);
  }
  return (*this)[name];
}

std::optional<TableObject::Length> TableObject::find_length(std::string_view name) {
  std::optional<Length> found;
  for (const LengthUnit& unit : length_units) {
    auto node = find(fmt::format("{}_{}", name, unit.name));
    if (!node) continue;
    if (found) node->fail("the same length is there in another unit");
    found = Length{*std::move(node), *parse_exact(unit.metres)};
  }
  return found;
}

TableObject::Length TableObject::length(std::string_view name) {
  if (auto found = find_length(name)) return *std::move(found);
  node_.fail(fmt::format("the field '{}_m' is missing", name));
}

std::vector<std::string> TableObject::unread() const {
  std::vector<std::string> names;
  const auto& members = node_.value().members;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (!read_[i] && !is_remark(members[i].name)) names.push_back(members[i].name);
  }
  return names;
}

}  // namespace patchgrip::cli
