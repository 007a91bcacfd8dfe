// A reference table as read: JSON whose numbers keep their digits.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace patchgrip::cli {

// What is wrong with a table: file, place, value and what is expected there.
class TableError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct TableMember;

struct TableValue {
  enum class Kind { null, boolean, number, text, list, object };

  Kind kind = Kind::null;
  std::string text;                  // of a number or a text; "true" or "false"
  std::vector<TableValue> items;     // of a list
  std::vector<TableMember> members;  // of an object, each name once
};

struct TableMember {
  std::string name;
  TableValue value;
};

// Throws TableError where the file cannot be read, is no JSON, repeats a name in an object or nests more than 64 deep.
TableValue read_table(const std::string& file);

}  // namespace patchgrip::cli
