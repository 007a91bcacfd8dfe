// Strict reading of one TOML table: every key is known, every value has the right type and lies in its range.
//
// A whole number is accepted where a real one is asked for; nothing else is converted. An unknown key is refused, with
// the nearest known name, when the reader is made.
//
// Throws   SceneError "file:line: key = value: what is allowed", from every function that reads.
#pragma once

#include <toml++/toml.h>

#include <array>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/scene/place.h>
#include <patchgrip/cli/scene/toml_document.h>

namespace patchgrip::cli {

// Which numbers a key admits, and how an error says so.
struct Quantity {
  bool admits(double value) const noexcept;
  std::string allowed() const;  // "a radius in m, from 1e-60 to 1e+60"

  std::string_view what;
  double low;
  double high;
  bool or_zero = false;      // 0 as well as [low, high]
  bool or_negative = false;  // -value in [low, high] as well
  bool above_low = false;    // (low, high] instead of [low, high]
};

// Sizes of 1e-60 to 1e60 in SI units: wide enough for any contact, and the products that friction needs stay doubles.
constexpr double smallest_size = 1e-60;
constexpr double largest_size = 1e60;

constexpr Quantity positive(std::string_view what) { return {what, smallest_size, largest_size}; }
constexpr Quantity non_negative(std::string_view what) { return {what, smallest_size, largest_size, true}; }
constexpr Quantity any_sign(std::string_view what) { return {what, smallest_size, largest_size, true, true}; }
// A turn at most: what is larger was meant in degrees.
constexpr double largest_angle = 6.2832;  // [rad]
constexpr Quantity any_angle(std::string_view what) { return {what, smallest_size, largest_angle, true, true}; }

class TomlReader {
 public:
  // Names of keys, for the length of a call: {"radius", "alpha"}, or an array of them.
  struct Keys : std::span<const std::string_view> {
    Keys(std::initializer_list<std::string_view> names) : span(std::data(names), names.size()) {}
    template <std::size_t N>
    Keys(const std::array<std::string_view, N>& names) : span(names) {}
  };

  // `path` names the table in errors; it is empty for the whole file. `document` must outlive the reader.
  TomlReader(const TomlDocument& document, const toml::table& table, std::string path, Keys known);

  bool has(std::string_view key) const { return table_->contains(key); }
  const toml::node& node(std::string_view key) const;  // refuses a missing key

  double number(std::string_view key, const Quantity& quantity) const;
  std::string text(std::string_view key) const;
  bool flag(std::string_view key) const;                                                    // false when missing
  std::size_t choice(std::string_view key, std::span<const std::string_view> names) const;  // index of the name

  TomlReader table(std::string_view key, Keys known) const;
  std::vector<TomlReader> tables(std::string_view key, Keys known) const;  // [[key]]

  // The same for a value that is not the value of a key: an element of an array, say.
  double number(const toml::node& value, std::string_view name, const Quantity& quantity) const;
  const toml::array& array(const toml::node& value, std::string_view name, std::string_view allowed) const;

  // Refuses every key but those of `used`; `reason` says why ("a rectangle takes 'sides' and nothing else").
  void refuse_others(Keys used, std::string_view reason) const;

  [[noreturn]] void refuse(std::string_view key, std::string_view allowed) const;  // a key, present or missing
  [[noreturn]] void refuse(const toml::node& value, std::string_view name, std::string_view allowed) const;  // a value
  [[noreturn]] void refuse_table(std::string_view allowed) const;  // the table as a whole

  Place place(std::string_view key) const;  // of a key that is there
  Place place() const;                      // of the table as a whole

  std::string full_name(std::string_view key) const;
  const TomlDocument& document() const noexcept { return *document_; }

 private:
  std::size_t line() const;

  const TomlDocument* document_;
  const toml::table* table_;
  std::string path_;
};

// What a factory refuses, told at the key that gave it the value.
template <class F>
auto made(const TomlReader& table, std::string_view key, F&& factory) {
  try {
    return factory();
  } catch (const std::invalid_argument& error) {
    table.refuse(key, error.what());
  }
}

}  // namespace patchgrip::cli
