// The entries of data/reference/friction.json that are about motion.
#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

namespace patchgrip::dynamics {

inline const nlohmann::json& table() {
  static const nlohmann::json all = [] {
    std::ifstream file(PATCHGRIP_DATA_DIR "/reference/friction.json");
    return nlohmann::json::parse(file);
  }();
  return all;
}

// Numbers stand there as text, as fractions, or as themselves.
inline double number(const nlohmann::json& value) {
  if (value.is_number()) return value.get<double>();
  const auto text = value.get<std::string>();
  const auto slash = text.find('/');
  if (slash == std::string::npos) return std::strtod(text.c_str(), nullptr);
  return std::strtod(text.c_str(), nullptr) / std::strtod(text.c_str() + slash + 1, nullptr);
}

}  // namespace patchgrip::dynamics
