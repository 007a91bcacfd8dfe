#include <patchgrip/cli/scene/toml_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <patchgrip/cli/scene/nearest_name.h>

namespace patchgrip::cli {

bool Quantity::admits(double value) const noexcept {
  const double size = or_negative ? std::fabs(value) : value;
  return (or_zero && value == 0) || ((above_low ? size > low : size >= low) && size <= high);
}

std::string Quantity::allowed() const {
  return fmt::format("{}, {}{} {} to {}{}", what, or_negative ? "of size " : "", above_low ? "above" : "from", low,
                     high, or_zero ? ", or 0" : "");
}

TomlReader::TomlReader(const TomlDocument& document, const toml::table& table, std::string path, Keys known)
    : document_(&document), table_(&table), path_(std::move(path)) {
  for (const auto& [key, value] : table) {
    if (std::ranges::find(known, key.str()) == known.end()) {
      refuse(key.str(), "unknown key" + suggestion(key.str(), known));
    }
  }
}

std::size_t TomlReader::line() const { return std::max<std::size_t>(1, table_->source().begin.line); }

std::string TomlReader::full_name(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

void TomlReader::refuse(std::string_view key, std::string_view allowed) const {
  if (!has(key)) {
    document_->fail(line(), fmt::format("{}: missing: {}", printable(full_name(key)), allowed));
  }
  place(key).refuse(allowed);
}

Place TomlReader::place(std::string_view key) const {
  const auto entry = table_->find(key);
  const toml::node& value = entry->second;
  const std::string written = value.is_table() || value.is_array_of_tables() ? "" : " = " + document_->written(value);
  return {document_->name(), entry->first.source().begin.line, printable(full_name(key)) + written};
}

Place TomlReader::place() const { return {document_->name(), line(), path_}; }

void TomlReader::refuse(const toml::node& value, std::string_view name, std::string_view allowed) const {
  document_->fail(value.source().begin.line,
                  fmt::format("{} = {}: {}", printable(full_name(name)), document_->written(value), allowed));
}

void TomlReader::refuse_table(std::string_view allowed) const {
  document_->fail(line(), path_.empty() ? std::string(allowed) : fmt::format("{}: {}", path_, allowed));
}

const toml::node& TomlReader::node(std::string_view key) const {
  const toml::node* value = table_->get(key);
  if (value == nullptr) refuse(key, "this key is needed");
  return *value;
}

double TomlReader::number(std::string_view key, const Quantity& quantity) const {
  if (!has(key)) refuse(key, quantity.allowed());
  return number(node(key), key, quantity);
}

double TomlReader::number(const toml::node& value, std::string_view name, const Quantity& quantity) const {
  const auto* const real = value.as_floating_point();
  const auto* const whole = value.as_integer();
  if (real == nullptr && whole == nullptr) refuse(value, name, quantity.allowed());
  const double number = real != nullptr ? real->get() : static_cast<double>(whole->get());
  if (!quantity.admits(number)) refuse(value, name, quantity.allowed());
  return number;
}

std::string TomlReader::text(std::string_view key) const {
  const auto* const value = node(key).as_string();
  if (value == nullptr) refuse(key, "a text in quotes");
  if (printable(value->get(), std::string::npos) != value->get())
    refuse(key, "a text on one line, without control characters");
  return value->get();
}

bool TomlReader::flag(std::string_view key) const {
  if (!has(key)) return false;
  const auto* const value = node(key).as_boolean();
  if (value == nullptr) refuse(key, "true or false");
  return value->get();
}

std::size_t TomlReader::choice(std::string_view key, std::span<const std::string_view> names) const {
  const std::string name = text(key);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) refuse(key, "unknown name" + suggestion(name, names));
  return static_cast<std::size_t>(found - names.begin());
}

TomlReader TomlReader::table(std::string_view key, Keys known) const {
  const auto* const value = node(key).as_table();
  if (value == nullptr) refuse(key, "a table");
  return {*document_, *value, full_name(key), known};
}

std::vector<TomlReader> TomlReader::tables(std::string_view key, Keys known) const {
  const auto* const values = node(key).as_array();
  if (values == nullptr || !values->is_homogeneous(toml::node_type::table)) {
    refuse(key, fmt::format("tables, each headed [[{}]]", full_name(key)));
  }
  std::vector<TomlReader> readers;
  for (const toml::node& value : *values) {
    readers.emplace_back(*document_, *value.as_table(), fmt::format("{}[{}]", full_name(key), readers.size()), known);
  }
  return readers;
}

const toml::array& TomlReader::array(const toml::node& value, std::string_view name, std::string_view allowed) const {
  const auto* const values = value.as_array();
  if (values == nullptr) refuse(value, name, allowed);
  return *values;
}

void TomlReader::refuse_others(Keys used, std::string_view reason) const {
  for (const auto& [key, value] : *table_) {
    if (std::ranges::find(used, key.str()) == used.end()) refuse(key.str(), reason);
  }
}

}  // namespace patchgrip::cli
