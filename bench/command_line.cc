#include <patchgrip/bench/command_line.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace patchgrip::bench {

CommandLine::CommandLine(const std::string& name, const std::string& about, const std::string& short_does)
    : app(about, name) {
  app.add_option("-o,--output", output, "CSV file to write the measurements to, beside what is printed")
      ->type_name("FILE");
  if (!short_does.empty()) app.add_flag("--short", is_short, short_does);
}

void CommandLine::read(int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) std::exit(app.exit(error));
    std::cerr << app.get_name() << ": " << error.what() << "\nRun " << app.get_name()
              << " --help for what it can do.\n";
    std::exit(2);
  }
}

int CommandLine::write(const std::string& path, const Table& table) const {
  if (path.empty()) return EXIT_SUCCESS;
  std::ofstream file(path);
  table(file);
  file.flush();
  if (file) return EXIT_SUCCESS;
  std::cerr << app.get_name() << ": cannot write " << path << '\n';
  return EXIT_FAILURE;
}

}  // namespace patchgrip::bench
