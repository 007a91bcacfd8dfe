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

#include <patchgrip/cli/output_file.h>
#include <patchgrip/verification/cases/case.h>
#include <patchgrip/verification/claims/all_claims.h>
#include <patchgrip/verification/claims/stored_run.h>
#include <patchgrip/verification/claims/two_solvers.h>
#include <patchgrip/verification/report/html.h>
#include <patchgrip/verification/report/result_json.h>
#include <patchgrip/verification/report/stored.h>
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

struct Options {
  std::string level = "ci";
  std::filesystem::path output = "verification";
  std::filesystem::path store;  // empty: nothing is stored
  bool check_stored = false;
};

void write(const std::filesystem::path& file, const std::string& text) {
  patchgrip::cli::OutputFile out(file.string());
  out.write(text);
  out.commit();
}

struct Session {
  Options options;
  std::string report;
  std::vector<StoredRun> runs;  // of the cases that were solved
};

// Solves a case; false where it is not as claimed, or not what is stored.
bool verify(const Case& one, Session& session) {
  const Options& options = session.options;
  std::cout << fmt::format("{}: {}\n", one.name, claims_of(one.name).title) << std::flush;
  std::vector<Setting> settings = one.ci;
  if (options.level == "full") settings.insert(settings.end(), one.full.begin(), one.full.end());
  const auto progress = [](const Run& run) { std::cout << progress_line(run) << std::flush; };
  const Study result = study(claims_of(one.name).quantities(), settings, one.solve, progress);
  std::cout << summary(result) << std::flush;
  const std::string file = fmt::format("{}.json", one.name);
  write_result(options.output / file, one, options.level, result);
  write_fields(options.output, one, result);
  session.report += html_of(one, result);
  const StoredRun run = stored_run_of(one, options.level, result);
  if (!options.store.empty()) {
    write(options.store / file, text_of(run));
    if (one.stores_stress) write(options.store / fmt::format("{}_von_mises.csv", one.name), csv_of(*result.stress));
  }
  session.runs.push_back(run);
  bool is_reproduced = true;
  if (options.check_stored) {
    const Reproduction reproduction =
        reproduces(run, read_stored_run(std::filesystem::path(PATCHGRIP_DATA_DIR) / "fe" / file));
    std::cout << reproduction.report << std::flush;
    is_reproduced = reproduction.is_within_bound;
  }
  return is_reproduced && std::all_of(result.comparisons.begin(), result.comparisons.end(),
                                      [](const Comparison& c) { return c.is_as_claimed(); });
}

// Holds the solvers against each other where both solved a case; false where they do not agree.
bool solvers_agree(Session& session) {
  bool agree = true;
  std::vector<std::string> lines;
  for (const SolverPair& pair : solver_pairs()) {
    const auto run_of = [&](std::string_view name) {
      return std::find_if(session.runs.begin(), session.runs.end(), [&](const auto& run) { return run.name == name; });
    };
    const auto first = run_of(pair.first), second = run_of(pair.second);
    if (first == session.runs.end() || second == session.runs.end()) continue;
    const Agreement found = agreement(pair, *first, *second);
    agree = agree && found.is_within_bound;
    lines.push_back(line_of(pair, found));
    std::cout << lines.back() << "\n";
  }
  session.report += html_of_solvers(lines);
  return agree;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Holds patchgrip against finite elements: meshes, solves, compares and reports.", "patchgrip-verify"};
  std::vector<std::string> names;
  Session session;
  Options& options = session.options;
  app.add_option("CASE", names, "names of cases; all without");
  app.add_option("--level", options.level, "ci: minutes; full: one finer mesh each")
      ->check(CLI::IsMember({"ci", "full"}));
  app.add_option("--output", options.output, "folder for what is written")->capture_default_str();
  CLI::Option* store =
      app.add_option("--store", options.store, "folder that also takes the runs in the form of data/fe");
  app.add_flag("--check-stored", options.check_stored, "holds the runs against those of data/fe")->excludes(store);
  std::vector<const Case*> cases;
  try {
    app.parse(argc, argv);
    cases = chosen_cases(names);
    std::filesystem::create_directories(options.output);
    if (!options.store.empty()) std::filesystem::create_directories(options.store);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << "patchgrip-verify: " << error.what() << "\n";
    return 2;
  }
  bool is_fine = true;
  for (const Case* one : cases) {
    try {
      is_fine = verify(*one, session) && is_fine;
    } catch (const std::exception& error) {
      std::cerr << "patchgrip-verify: " << one->name << ": " << error.what() << "\n";
      session.report += html_of_failure(*one, error.what());
      is_fine = false;
    }
  }
  try {
    is_fine = solvers_agree(session) && is_fine;
    write(options.output / "report.html", html_page(options.level, session.report));
  } catch (const std::exception& error) {
    std::cerr << "patchgrip-verify: " << error.what() << "\n";
    return 2;
  }
  return is_fine ? 0 : 1;
}
