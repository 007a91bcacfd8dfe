// Rows of data/reference/contact.json as numbers of fifty digits.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <patchgrip/tests/support/exact.h>

namespace patchgrip::testing {

struct ContactRow {
  nlohmann::json row;

  double input(const std::string& key) const { return static_cast<double>(field("inputs", key)); }
  Exact output(const std::string& key) const { return field("outputs", key); }

 private:
  Exact field(const char* side, const std::string& key) const {
    const auto& value = row.at(side).at(key).at("value");
    return Exact(value.is_string() ? value.get<std::string>() : value.dump());
  }
};

inline std::vector<ContactRow> contact_rows(const std::string& name) {
  std::ifstream file(PATCHGRIP_DATA_DIR "/reference/contact.json");
  std::vector<ContactRow> rows;
  const auto table = nlohmann::json::parse(file);
  for (const auto& entry : table.at("entries")) {
    if (entry.at("name") == name) rows.push_back({entry});
  }
  return rows;
}

}  // namespace patchgrip::testing
