#include <patchgrip/verification/claims/stored_run.h>

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace patchgrip::verification {
namespace {

using nlohmann::ordered_json;

std::string checksum_of(const ordered_json& run) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : run.dump()) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

StoredRun run_of(const ordered_json& json) {
  StoredRun run{json.at("case"), json.at("level"), json.at("versions"), {}, {}};
  for (const auto& mesh : json.at("meshes")) {
    run.meshes.push_back({mesh.at("elements"), mesh.at("extent"), mesh.at("seconds"), mesh.at("values")});
  }
  for (const auto& quantity : json.at("quantities")) {
    run.quantities.push_back({quantity.at("name"), quantity.at("fe"), quantity.at("fe_error")});
  }
  return run;
}

}  // namespace

std::string text_of(const StoredRun& run) {
  ordered_json json{{"case", run.name}, {"level", run.level}, {"versions", run.versions}};
  for (const auto& mesh : run.meshes) {
    json["meshes"].push_back(
        {{"elements", mesh.elements}, {"extent", mesh.extent}, {"seconds", mesh.seconds}, {"values", mesh.values}});
  }
  for (const auto& quantity : run.quantities) {
    json["quantities"].push_back({{"name", quantity.name}, {"fe", quantity.fe}, {"fe_error", quantity.fe_error}});
  }
  json["checksum"] = checksum_of(json);
  return json.dump(1) + "\n";
}

StoredRun read_stored_run(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  try {
    ordered_json json = ordered_json::parse(in);
    const std::string stated = json.at("checksum");
    json.erase("checksum");
    if (checksum_of(json) != stated) throw std::runtime_error("has been altered: its checksum is " + checksum_of(json));
    return run_of(json);
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

}  // namespace patchgrip::verification
