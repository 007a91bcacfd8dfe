#include <patchgrip/tests/contact/contact_table.h>

#include <fstream>

#include <nlohmann/json.hpp>

namespace patchgrip::testing {
namespace {

// Left out where there is no value.
std::map<std::string, std::string> texts(const nlohmann::json& side) {
  std::map<std::string, std::string> all;
  for (const auto& [key, field] : side.items()) {
    const auto& value = field.at("value");
    if (!value.is_null()) all[key] = value.is_string() ? value.get<std::string>() : value.dump();
  }
  return all;
}

}  // namespace

double ContactRow::input(const std::string& key) const { return static_cast<double>(Exact(inputs.at(key))); }

double ContactRow::input_or(double otherwise, const std::string& key) const {
  return inputs.contains(key) ? input(key) : otherwise;
}

Exact ContactRow::output(const std::string& key) const { return Exact(outputs.at(key)); }

std::vector<ContactRow> contact_rows(const std::string& name) {
  std::ifstream file(PATCHGRIP_DATA_DIR "/reference/contact.json");
  std::vector<ContactRow> rows;
  const auto table = nlohmann::json::parse(file);
  for (const auto& entry : table.at("entries")) {
    if (entry.at("name") == name) rows.push_back({texts(entry.at("inputs")), texts(entry.at("outputs"))});
  }
  return rows;
}

}  // namespace patchgrip::testing
