// A value of a reference table together with its place: reading it, and saying what is wrong with it.
//
//     second.json: wrench_integrals[3] 'disc' rows[2].xi_M = '0.1.5': not a number
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/accuracy/number.h>
#include <patchgrip/cli/accuracy/value.h>

namespace patchgrip::cli {

class TableNode {
 public:
  // `value` must outlive the node.
  TableNode(const TableValue& value, std::string file, std::string place = {});

  const TableValue& value() const noexcept { return *value_; }
  const std::string& place() const noexcept { return place_; }
  bool is_list() const noexcept { return value_->kind == TableValue::Kind::list; }
  bool is_object() const noexcept { return value_->kind == TableValue::Kind::object; }

  [[noreturn]] void fail(std::string_view message) const;

  TableNode member(std::string_view name, const TableValue& value) const;
  TableNode named(std::string_view name) const;   // the same value, with a name in its place
  TableNode with(const TableValue& value) const;  // another value in the same place

  std::vector<TableNode> items() const;                   // of a list
  std::vector<TableNode> items(std::size_t count) const;  // of a list of that length
  std::vector<TableNode> filled() const;                  // of a list that is not empty
  std::string text() const;

  // From a text or a JSON number, within the range of doubles.
  Exact number() const;
  Exact positive() const;
  std::vector<Exact> numbers(std::size_t count) const;
  std::optional<Exact> number_unless_infinite() const;  // nothing for "inf" and null

 private:
  TableNode item(std::size_t index) const;

  const TableValue* value_;
  std::string file_;
  std::string place_;
};

// An object whose fields are asked for one by one; what nobody asked for is not covered.
class TableObject {
 public:
  explicit TableObject(const TableNode& node);

  const TableNode& node() const noexcept { return node_; }
  TableNode operator[](std::string_view name);  // throws TableError where it is missing
  std::optional<TableNode> find(std::string_view name);
  TableNode symbol(std::string_view name);  // the field <name> or <name>=<its definition>

  // A length [m] given as <name>_m, or in another unit as <name>_mm, _cm, _um or _km; `factor` makes metres of it.
  struct Length {
    TableNode node;
    Exact factor;
    Exact metres() const { return node.number() * factor; }
  };
  Length length(std::string_view name);
  std::optional<Length> find_length(std::string_view name);

  // Fields that were not asked for. Remarks (note, definition, name ...) are not among them.
  std::vector<std::string> unread() const;

 private:
  TableNode node_;
  std::vector<bool> read_;
};

}  // namespace patchgrip::cli
