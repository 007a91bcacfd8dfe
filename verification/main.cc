// The program `patchgrip-verify`: cases of finite elements against the library.
//
// Exit codes: 0 all is as claimed or cannot be judged; 1 something differs, or a case was not solved; 2 bad input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <patchgrip/verification/cases/case.h>
#include <patchgrip/verification/report/result_json.h>
#include <patchgrip/verification/report/summary.h>

namespace {

using namespace patchgrip::verification;

std::vector<const Case*> chosen_cases(const std::vector<std::string>& names) {
  std::vector<const Case*> chosen;
  std::string allowed;
  for (const Case& one : all_cases()) allowed += fmt::format(" {}", one.name);
  for (const Case& one : all_cases()) {
    if (names.empty() || std::count(names.begin(), names.end(), one.name) > 0) chosen.push_back(&one);
  }
  for (const auto& name : names) {
    const auto is_it = [&](const Case& one) { return one.name == name; };
    if (std::none_of(all_cases().begin(), all_cases().end(), is_it)) {
      throw CLI::ValidationError("CASE", fmt::format("'{}' is none of:{}", name, allowed));
    }
  }
  return chosen;
}

// Solves a case; false where it is not as claimed.
bool verify(const Case& one, const std::string& level, const std::filesystem::path& output) {
  fmt::print("{}: {}\n", one.name, one.title);
  std::vector<Setting> settings = one.ci;
  if (level == "full") settings.insert(settings.end(), one.full.begin(), one.full.end());
  const auto progress = [](const Run& run) { std::cout << progress_line(run) << std::flush; };
  const Study result = study(one.claims(), settings, one.solve, progress);
  std::cout << summary(result) << std::flush;
  write_result(output / fmt::format("{}.json", one.name), one, level, result);
  return std::all_of(result.comparisons.begin(), result.comparisons.end(),
                     [](const Comparison& c) { return c.is_as_claimed(); });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Holds patchgrip against finite elements: meshes, solves, compares and reports.", "patchgrip-verify"};
  std::vector<std::string> names;
  std::string level = "ci", output = "verification";
  app.add_option("CASE", names, "names of cases; all without");
  app.add_option("--level", level, "ci: minutes; full: one finer mesh each")->check(CLI::IsMember({"ci", "full"}));
  app.add_option("--output", output, "folder for what is written")->capture_default_str();
  std::vector<const Case*> cases;
  try {
    app.parse(argc, argv);
    cases = chosen_cases(names);
    std::filesystem::create_directories(output);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << "patchgrip-verify: " << error.what() << "\n";
    return 2;
  }
  bool is_fine = true;
  for (const Case* one : cases) {
    try {
      is_fine = verify(*one, level, output) && is_fine;
    } catch (const std::exception& error) {
      std::cerr << "patchgrip-verify: " << one->name << ": " << error.what() << "\n";
      is_fine = false;
    }
  }
  return is_fine ? 0 : 1;
}
