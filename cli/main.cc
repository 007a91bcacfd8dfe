// The program `patchgrip`: command line, exit codes, and nothing else.
//
// Exit codes: 0 done; 1 a question answered with a failure; 2 bad input, or a result that could not be written;
// 128 + n stopped by signal n.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <patchgrip/cli/accuracy/accuracy.h>
#include <patchgrip/cli/grasp/run_grasp.h>
#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/limit/run_limit.h>
#include <patchgrip/cli/output_file.h>
#include <patchgrip/cli/output_names.h>
#include <patchgrip/cli/press/run_press.h>
#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/nearest_name.h>
#include <patchgrip/cli/scene/scene.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/cli/simulate/run_simulate.h>
#include <patchgrip/cli/tabulate.h>
#include <patchgrip/cli/unanswered.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip;

constexpr int done = 0;
constexpr int unanswered = 1;
constexpr int bad_input = 2;
constexpr int by_signal = 128;

constexpr std::string_view about = "Contact, friction and grasping of soft bodies, with the error of every number.";

constexpr std::string_view about_exit_codes =
    "Exit codes: 0 done, 1 a question answered with a failure, 2 bad input or a result that cannot be written.\n"
    "patchgrip SUBCOMMAND --help says more.";

constexpr std::string_view about_tabulate =
    "friction force and moment of a contact against the instantaneous pole (CSV)";

constexpr std::string_view about_press =
    "contact radius, pressure, approach and stiffness of bodies that press on each other (JSON)";

constexpr std::string_view about_limit =
    "does friction hold these loads: gauge, margin and the slip that is next (JSON); the limit surface as VTK, CSV, "
    "SVG";

constexpr std::string_view about_grasp =
    "does a grasp hold its load, with how little grip, and what slips first: with certificates (JSON), CSV, SVG, VTK";

constexpr std::string_view about_simulate =
    "how a body moves on its contact: when it breaks away, when it stops (JSON), and the motion over time (CSV)";

constexpr std::string_view about_scenes =
    "SCENE names what touches, how it is loaded and what is asked for. Its format is described key by key in\n"
    "data/scenes/README.md (installed: share/patchgrip/scenes), beside ready-made scenes.\n"
    "Materials named there are looked for in materials/ beside the scene or beside its folder, then among those of "
    "patchgrip.";

constexpr std::string_view about_accuracy = "errors of every entry of reference tables (JSON), and what is not covered";

constexpr std::string_view about_failure =
    "Exit code 1 if an error exceeds the tolerance, or if something is not covered and --allow-uncovered is not given.";

constexpr std::array<std::string_view, 6> subcommands{"tabulate", "press", "limit", "grasp", "simulate", "accuracy"};

struct Arguments {
  std::string scene;
  std::string output = "-";
  std::string table;
  std::string surface;
  std::string picture;
  std::string vectors;
  std::string inequalities;
  std::string question;
  std::string materials;
  std::vector<std::string> tables;
  std::string tolerance = "1e-12";
  bool allow_uncovered = false;
};

// With a standard descriptor closed, the next file to be opened would take its place and receive our messages.
void occupy_standard_descriptors() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) == -1) (void)open("/dev/null", O_RDONLY);
  }
}

cli::MaterialLibrary materials_of(const Arguments& arguments) {
  if (arguments.materials.empty()) return cli::MaterialLibrary::for_scene(arguments.scene);
  if (!std::filesystem::is_directory(arguments.materials)) {
    throw cli::SceneError(arguments.materials, 0, "is not a folder of materials");
  }
  return cli::MaterialLibrary({arguments.materials});
}

void refuse_clashes(const Arguments& arguments) {
  const std::array<cli::NamedOutput, 6> outputs{{{"--output", arguments.output},
                                                 {"--table", arguments.table},
                                                 {"--surface", arguments.surface},
                                                 {"--vectors", arguments.vectors},
                                                 {"--inequalities", arguments.inequalities},
                                                 {"--picture", arguments.picture}}};
  cli::refuse_clashes(arguments.scene, outputs);
}

int run_limit(const Arguments& arguments) {
  const cli::InterruptGuard guard;
  const cli::MaterialLibrary materials = materials_of(arguments);
  refuse_clashes(arguments);
  cli::run_limit({arguments.scene, arguments.output, arguments.table, arguments.surface, arguments.picture}, materials);
  return done;
}

int run_grasp(const Arguments& arguments) {
  const cli::InterruptGuard guard;
  const cli::MaterialLibrary materials = materials_of(arguments);
  refuse_clashes(arguments);
  cli::run_grasp({arguments.scene, arguments.output, arguments.table, arguments.vectors, arguments.picture,
                  arguments.inequalities},
                 arguments.question, materials);
  return done;
}

int run_press(const Arguments& arguments) {
  const cli::InterruptGuard guard;
  const cli::MaterialLibrary materials = materials_of(arguments);
  refuse_clashes(arguments);
  cli::run_press({arguments.scene, arguments.output, arguments.table}, materials);
  return done;
}

int run_simulate(const Arguments& arguments) {
  const cli::InterruptGuard guard;
  const cli::MaterialLibrary materials = materials_of(arguments);
  refuse_clashes(arguments);
  cli::run_simulate({arguments.scene, arguments.output, arguments.table}, materials);
  return done;
}

int run_tabulate(const Arguments& arguments) {
  const cli::InterruptGuard guard;
  const cli::MaterialLibrary materials = materials_of(arguments);
  refuse_clashes(arguments);
  const cli::Scene scene = cli::read_scene(cli::TomlDocument::read(arguments.scene), materials);
  cli::OutputFile out(arguments.output);
  cli::tabulate(scene, arguments.scene, out);
  out.commit();
  return done;
}

double tolerance_of(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value > 0) || !std::isfinite(value)) {
    throw CLI::ValidationError("--tolerance", fmt::format("'{}' is not a positive number", cli::printable(text)));
  }
  return value;
}

void refuse_unknown_subcommand(int argc, char** argv) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (first.empty() || first.starts_with('-') || std::ranges::find(subcommands, first) != subcommands.end()) return;
  throw CLI::ExtrasError(
      fmt::format("unknown subcommand '{}'{}", cli::printable(first), cli::suggestion(first, subcommands)),
      CLI::ExitCodes::ExtrasError);
}

int run(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{std::string(about), "patchgrip"};
  app.footer(std::string(about_exit_codes));
  app.set_version_flag("--version", fmt::format("patchgrip {}", version));
  app.require_subcommand(1);

  const auto add_scene_command = [&](const char* name, std::string_view description) {
    CLI::App* command = app.add_subcommand(name, std::string(description));
    command->footer(std::string(about_scenes));
    command->add_option("SCENE", arguments.scene, "scene file (TOML)")->required();
    command
        ->add_option("-o,--output", arguments.output,
                     "file to write; it is replaced only by a whole result. Default: standard output")
        ->type_name("FILE");
    command
        ->add_option("--materials", arguments.materials, "folder to look for materials in, instead of the usual ones")
        ->type_name("DIR");
    return command;
  };
  const CLI::App* tabulate = add_scene_command("tabulate", about_tabulate);
  CLI::App* press = add_scene_command("press", about_press);
  press
      ->add_option("--table", arguments.table,
                   "CSV file to write: pressure and displacement along a line, the answers of a sweep, or a history")
      ->type_name("FILE");

  CLI::App* limit = add_scene_command("limit", about_limit);
  limit->add_option("--table", arguments.table, "CSV file to write: a row for each load")->type_name("FILE");
  limit
      ->add_option("--surface", arguments.surface,
                   "file to write the limit surface to: .vtk (PolyData with normals and slips) or .csv")
      ->type_name("FILE");
  limit->add_option("--picture", arguments.picture, ".svg file to draw the limit surface and the loads in")
      ->type_name("FILE");

  CLI::App* grasp = add_scene_command("grasp", about_grasp);
  grasp->add_option("--question", arguments.question, "what is asked, instead of what the scene asks")
      ->type_name("NAME");
  grasp->add_option("--table", arguments.table, "CSV file to write: a row for each load, or each member of a family")
      ->type_name("FILE");
  grasp->add_option("--picture", arguments.picture, ".svg file to draw contacts, forces, load and escape in")
      ->type_name("FILE");
  grasp->add_option("--vectors", arguments.vectors, ".vtk file to write normals, forces and the escape to")
      ->type_name("FILE");

  grasp
      ->add_option(
          "--inequalities", arguments.inequalities,
          ".dat-s file to write the grip of the first load to, as linear matrix inequalities for SDPA and others")
      ->type_name("FILE");

  CLI::App* simulate = add_scene_command("simulate", about_simulate);
  simulate
      ->add_option("--table", arguments.table,
                   "CSV file to write: place, twist, friction and energies over time; after Ctrl-C up to there")
      ->type_name("FILE");

  CLI::App* accuracy = app.add_subcommand("accuracy", std::string(about_accuracy));
  accuracy->footer(std::string(about_failure));
  accuracy->add_option("TABLE", arguments.tables, "reference tables (JSON)")->required();
  accuracy
      ->add_option("--tolerance", arguments.tolerance,
                   "largest error relative to the scale of a quantity. Default: 1e-12")
      ->type_name("T");
  accuracy->add_flag("--allow-uncovered", arguments.allow_uncovered,
                     "kinds and fields that are not covered are no failure");

  try {
    refuse_unknown_subcommand(argc, argv);
    app.parse(argc, argv);
    if (tabulate->parsed()) return run_tabulate(arguments);
    if (press->parsed()) return run_press(arguments);
    if (limit->parsed()) return run_limit(arguments);
    if (grasp->parsed()) return run_grasp(arguments);
    if (simulate->parsed()) return run_simulate(arguments);
    return cli::run_accuracy(arguments.tables, tolerance_of(arguments.tolerance), arguments.allow_uncovered, std::cout);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "patchgrip: " << error.what() << "\nRun patchgrip --help for what it can do.\n";
    return bad_input;
  }
}

}  // namespace

int main(int argc, char** argv) {
  occupy_standard_descriptors();
  int code = bad_input;
  try {
    code = run(argc, argv);
  } catch (const cli::Interrupted& stop) {
    return by_signal + stop.signal;
  } catch (const cli::ClosedPipe&) {
    return bad_input;
  } catch (const cli::Unanswered& error) {
    std::cerr << error.what() << '\n';
    return unanswered;
  } catch (const std::bad_alloc&) {
    std::cerr << "patchgrip: out of memory\n";
    return bad_input;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return bad_input;
  }
  if (!std::cout.flush()) {
    std::cerr << "standard output: cannot be written\n";
    return bad_input;
  }
  return code;
}
