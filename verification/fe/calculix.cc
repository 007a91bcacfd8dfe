#include <patchgrip/verification/fe/calculix.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <patchgrip/verification/fe/work_folder.h>

namespace patchgrip::verification {
namespace {

std::string end_of(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  const std::string all = text.str();
  constexpr std::size_t shown = 600;
  return all.size() > shown ? all.substr(all.size() - shown) : all;
}

}  // namespace

std::string calculix_version() { return PATCHGRIP_CCX_VERSION; }

CalculixResult run_calculix(const std::string& input) {
  auto stem = new_work_file("");
  const auto with = [&](const char* extension) { return std::filesystem::path(stem.string() + extension); };
  std::ofstream(with(".inp")) << input;
  std::string program = PATCHGRIP_CCX, option = "-i", job = stem.string();
  std::array<char*, 4> arguments{program.data(), option.data(), job.data(), nullptr};
  const std::string log = with(".log").string();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  // It leaves files where it runs.
  posix_spawn_file_actions_addchdir_np(&actions, stem.parent_path().c_str());
  pid_t child = 0;
  const int failed = posix_spawn(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed != 0 || waitpid(child, &status, 0) != child) throw std::runtime_error(program + " cannot be started");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("ccx did not converge; its log ends with:\n" + end_of(log));
  }
  return {with(".dat"), with(".frd")};
}

std::vector<std::vector<double>> CalculixResult::printed(std::string_view heading) const {
  std::ifstream in(table);
  std::string line;
  std::vector<std::vector<double>> rows;
  while (std::getline(in, line)) {
    if (line.find(heading) == std::string::npos) continue;
    while (std::getline(in, line) && line.find_first_not_of(" \r") == std::string::npos) {
    }
    std::istringstream numbers(line);
    rows.emplace_back(std::istream_iterator<double>(numbers), std::istream_iterator<double>());
  }
  if (rows.empty()) throw std::runtime_error(fmt::format("ccx printed no {}", heading));
  return rows;
}

double CalculixResult::total_force(int component) const {
  return printed("total force").back().at(static_cast<std::size_t>(component));
}

std::map<int, double> CalculixResult::field(std::string_view name, std::size_t component) const {
  constexpr std::size_t key = 3, number = 10, width = 12;  // places of the format
  std::ifstream in(fields);
  std::string line;
  std::map<int, double> values;
  bool is_asked = false;
  while (std::getline(in, line)) {
    if (line.starts_with(" -4")) is_asked = line.find(name) != std::string::npos;
    if (line.starts_with(" -3")) is_asked = false;
    if (!is_asked || !line.starts_with(" -1")) continue;
    values[std::stoi(line.substr(key, number))] = std::stod(line.substr(key + number + component * width, width));
  }
  if (values.empty()) throw std::runtime_error(fmt::format("ccx told no {}", name));
  return values;
}

}  // namespace patchgrip::verification
