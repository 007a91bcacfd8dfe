#include <patchgrip/cli/accuracy/value.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

constexpr std::size_t deepest = 64;

// nlohmann's own document would round the numbers to double.
class Builder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  const std::string& error() const { return error_; }
  TableValue take() { return std::move(root_); }

  bool null() override { return put({}); }
  bool boolean(bool value) override { return put({TableValue::Kind::boolean, value ? "true" : "false", {}, {}}); }
  bool number_integer(number_integer_t value) override { return put_number(std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override { return put_number(std::to_string(value)); }
  bool number_float(number_float_t, const string_t& text) override { return put_number(text); }
  bool string(string_t& text) override { return put({TableValue::Kind::text, std::move(text), {}, {}}); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(TableValue::Kind::object); }
  bool start_array(std::size_t) override { return open(TableValue::Kind::list); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    for (const auto& [known, value] : open_.back()->members) {
      if (known == name) return refuse(fmt::format("the name '{}' is there twice in one object", printable(name)));
    }
    open_.back()->members.push_back({std::move(name), {}});
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override {
    const std::string_view what = error.what();
    const std::size_t end_of_id = what.find("] ");
    return refuse("no JSON: " +
                  printable(end_of_id == std::string_view::npos ? what : what.substr(end_of_id + 2), what.size()));
  }

 private:
  bool refuse(std::string message) {
    error_ = std::move(message);
    return false;
  }

  TableValue& next() {
    if (open_.empty()) return root_;
    TableValue& parent = *open_.back();
    return parent.kind == TableValue::Kind::object ? parent.members.back().value : parent.items.emplace_back();
  }

  bool put(TableValue value) {
    next() = std::move(value);
    return true;
  }

  bool put_number(std::string text) { return put({TableValue::Kind::number, std::move(text), {}, {}}); }

  // A parent's items do not grow while a child is open, so the pointers stay valid.
  bool open(TableValue::Kind kind) {
    if (open_.size() == deepest) return refuse(fmt::format("lists and objects nest more than {} deep", deepest));
    TableValue& value = next();
    value.kind = kind;
    open_.push_back(&value);
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  TableValue root_;
  std::vector<TableValue*> open_;
  std::string error_;
};

}  // namespace

TableValue read_table(const std::string& file) {
  const auto fail = [&](std::string_view message) -> TableValue {
    throw TableError(fmt::format("{}: {}", printable(file, file.size()), message));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return fail("is a folder");
  std::ifstream in(file, std::ios::binary);
  if (!in) return fail("cannot be read");
  Builder builder;
  if (!nlohmann::json::sax_parse(in, &builder)) return fail(builder.error());
  return builder.take();
}

}  // namespace patchgrip::cli
