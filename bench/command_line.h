// The command line of the programs here: --help, --output CSV and --short, and what a program adds to them.
//
//     CommandLine line("creep", "Viscoelastic press: ...", "repeats each measurement fewer times");
//     line.read(argc, argv);
//     if (line.is_short) ...
//     return line.write([&](std::ostream& csv) { ... });
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <ostream>
#include <string>

namespace patchgrip::bench {

struct CommandLine {
  // `short_does` is what the help says of --short; without it there is no such option.
  CommandLine(const std::string& name, const std::string& about, const std::string& short_does = "");

  // Ends the program: with code 0 after --help, with 2 after what it does not know.
  void read(int argc, char** argv);

  using Table = std::function<void(std::ostream& csv)>;
  // The file of --output, or of another option, where one is asked for. The exit code: 1, the path named, if it fails.
  int write(const Table& table) const { return write(output, table); }
  int write(const std::string& path, const Table& table) const;

  CLI::App app;
  std::string output;  // empty: no file is asked for
  bool is_short = false;
};

}  // namespace patchgrip::bench
