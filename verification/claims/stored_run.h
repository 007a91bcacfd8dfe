// Runs of finite elements that are kept in data/fe, so that the library is held against them without any solver.
//
// A file is JSON: case, level, versions, meshes, and FE's values with their errors. Its checksum is FNV-1a (64 bits) of
// everything else, as the JSON library prints it without spaces.
//
// Throws   std::runtime_error, naming the file, where it cannot be read, is not such a run, or has been altered.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace patchgrip::verification {

struct StoredMesh {
  double elements, extent;
  double seconds;
  std::vector<std::vector<double>> values;  // of each quantity
};

struct StoredQuantity {
  std::string name;
  std::vector<double> fe, fe_error;
};

struct StoredRun {
  std::string name;  // of the case
  std::string level;
  std::map<std::string, std::string> versions;
  std::vector<StoredMesh> meshes;  // from coarse to fine
  std::vector<StoredQuantity> quantities;
};

std::string text_of(const StoredRun& run);
StoredRun read_stored_run(const std::filesystem::path& file);

}  // namespace patchgrip::verification
