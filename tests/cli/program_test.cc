// The program as its users meet it: exit codes, messages, files left behind.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "scenes.h"
#include "scratch_folder.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

struct Result {
  int code;
  std::string out;
  std::string err;
};

std::string content(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Program : public test::ScratchFolder {
 protected:
  Program() {
    fs::create_directories(folder_ / "scenes");
    std::ofstream(scene("disc")) << test::good_disc;
    std::ofstream(scene("long")) << test::with(
        test::good_disc, "list = [[0.001, 0.002], [0, 0]]",
        "grid = { x = { from = 0, to = 1, count = 10000 }, y = { from = 0, to = 1, count = 10000 } }");
  }

  fs::path scene(const std::string& name) const { return folder_ / "scenes" / (name + ".toml"); }

  std::string scene_text(const std::string& name, const std::string& text) const {
    std::ofstream(scene(name)) << text;
    return scene(name).string();
  }

  // `arguments` as a shell reads them; may redirect.
  Result run(const std::string& arguments) const {
    const std::string command = "cd '" + folder_.string() + "'; { '" + std::string(PATCHGRIP_PROGRAM) + "' " +
                                arguments + "; } >out.txt 2>err.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), content(folder_ / "out.txt"),
            content(folder_ / "err.txt")};
  }

  // Starts the program with standard output and error at the given descriptors.
  pid_t start(const std::vector<std::string>& arguments, int out, int err) const {
    std::vector<std::string> words{PATCHGRIP_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      dup2(out, STDOUT_FILENO);
      dup2(err, STDERR_FILENO);
      execv(argv[0], argv.data());
      _exit(127);
    }
    return child;
  }

  static int code_of(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
};

TEST_F(Program, PrintsItsVersion) {
  const Result result = run("--version");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, StartsWith("patchgrip "));
}

TEST_F(Program, HelpsWithEverySubcommand) {
  for (const auto* const arguments :
       {"--help", "tabulate --help", "press --help", "limit --help", "simulate --help", "accuracy --help", "-h"}) {
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 0) << arguments;
    EXPECT_THAT(result.out, HasSubstr("Usage: patchgrip")) << arguments;
    EXPECT_THAT(result.err, IsEmpty()) << arguments;
  }
}

TEST_F(Program, RefusesUnknownArgumentsWithCode2) {
  for (const auto* const arguments :
       {"", "tabulat x", "--hepl", "tabulate", "tabulate scenes/disc.toml extra", "accuracy", "press", "limit",
        "simulate", "limit scenes/disc.toml --pictures x.svg", "press scenes/disc.toml --tabel x",
        "tabulate scenes/disc.toml --output", "tabulate --no-such-option scenes/disc.toml",
        "accuracy t.json --tolerance nan", "accuracy t.json --tolerance -1", "accuracy t.json --tolerance 1e999",
        "accuracy t.json --tolerance 1x"}) {
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_THAT(result.err, Not(IsEmpty())) << arguments;
    EXPECT_THAT(result.out, IsEmpty()) << arguments;
  }
  EXPECT_THAT(run("tabulat x").err, HasSubstr("did you mean 'tabulate'?"));
}

TEST_F(Program, WritesTheTableToStandardOutput) {
  const Result result = run("tabulate scenes/disc.toml");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, HasSubstr("# scene: scenes/disc.toml\n"));
  EXPECT_THAT(result.out, HasSubstr("\npole_x_m,pole_y_m,spin,"));
  EXPECT_THAT(result.err, IsEmpty());
}

TEST_F(Program, TheSameTableGoesToAnyOutput) {
  const std::string table = run("tabulate scenes/disc.toml").out;
  EXPECT_EQ(run("tabulate scenes/disc.toml -o -").out, table);
  EXPECT_EQ(run("tabulate scenes/disc.toml -o /dev/stdout").out, table);
  EXPECT_EQ(run("tabulate scenes/disc.toml --output table.csv").code, 0);
  EXPECT_EQ(content(folder_ / "table.csv"), table);
}

TEST_F(Program, AddsToARedirectedStandardOutput) {
  const Result result = run("tabulate scenes/disc.toml -o /dev/stdout; echo end");
  EXPECT_TRUE(result.out.ends_with("end\n"));
  EXPECT_THAT(result.out, StartsWith("# patchgrip"));
}

TEST_F(Program, RefusesABadSceneWithCode2AndTouchesNoFile) {
  std::ofstream(folder_ / "table.csv") << "old";
  scene_text("bad", test::with(test::good_disc, "0.005", "-0.005"));
  const Result result = run("tabulate scenes/bad.toml --output table.csv");
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err, "scenes/bad.toml:3: contact.radius = -0.005: a radius in m, from 1e-60 to 1e+60\n");
  EXPECT_EQ(content(folder_ / "table.csv"), "old");
}

TEST_F(Program, PressWritesAnswerAndTable) {
  const std::string scene = scene_text("ball", test::good_bodies);
  const Result result = run("press " + scene + " --table surface.csv");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_THAT(result.out, HasSubstr("\"law\": \"hertz\""));
  EXPECT_THAT(content(folder_ / "surface.csv"), HasSubstr("\nx_m,y_m,pressure_Pa,pressure_error_Pa,"));
  EXPECT_EQ(run("press " + scene + " -o answer.json").code, 0);
  EXPECT_EQ(content(folder_ / "answer.json"), result.out);
}

TEST_F(Program, PressRefusesABadSceneWithCode2AndTouchesNoFile) {
  std::ofstream(folder_ / "answer.json") << "old";
  std::ofstream(folder_ / "surface.csv") << "old";
  const std::string scene =
      scene_text("bad", test::with(test::good_bodies, "normal_force = 5.0", "normal_force = 1e999"));
  const std::string saddle =
      scene_text("saddle", test::with(test::good_bodies, "radius = 0.01", "radii = [0.01, -0.02]"));
  for (const auto& bad : {scene, saddle, std::string("scenes/disc.toml"), std::string("scenes/no.toml")}) {
    const Result result = run("press " + bad + " -o answer.json --table surface.csv");
    EXPECT_EQ(result.code, 2) << bad;
    EXPECT_THAT(result.err, HasSubstr(".toml")) << bad;
  }
  EXPECT_EQ(run("press scenes/disc.toml -o same --table same").code, 2);
  EXPECT_EQ(content(folder_ / "answer.json"), "old");
  EXPECT_EQ(content(folder_ / "surface.csv"), "old");
}

TEST_F(Program, LimitWritesAnswerTableSurfaceAndPicture) {
  const std::string scene = scene_text("loads", test::good_disc + "[[loads]]\nforce = [3, 0.5]\nmoment = 0.002\n");
  const Result result = run("limit " + scene + " --table loads.csv --surface surface.vtk --picture picture.svg");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("\"verdict\": \"holds\""));
  EXPECT_THAT(content(folder_ / "loads.csv"), HasSubstr("\nforce_x_N,force_y_N,moment_Nm,gauge_N,"));
  EXPECT_THAT(content(folder_ / "surface.vtk"), StartsWith("# vtk DataFile Version 3.0\n"));
  EXPECT_THAT(content(folder_ / "picture.svg"), StartsWith("<svg "));
  EXPECT_EQ(run("limit " + scene + " -o answer.json --surface surface.csv").code, 0);
  EXPECT_EQ(content(folder_ / "answer.json"), result.out);
  EXPECT_THAT(content(folder_ / "surface.csv"), HasSubstr("\n# net: meridians 96, parallels 48\n"));
}

TEST_F(Program, LimitLeavesFilesAloneWhenItRefuses) {
  std::ofstream(folder_ / "kept.csv") << "old";
  const std::string bad = scene_text("bad", test::good_disc + "[[loads]]\nforce = 3\n");
  const Result result = run("limit " + bad + " -o kept.json --table kept.csv");
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.err, HasSubstr("bad.toml:10: loads[0].force = 3: a force [x, y] in N"));
  EXPECT_EQ(content(folder_ / "kept.csv"), "old");
  EXPECT_FALSE(fs::exists(folder_ / "kept.json"));
  EXPECT_EQ(run("limit scenes/disc.toml --surface kept.csv --picture no/such/folder/p.svg").code, 2);
  EXPECT_EQ(content(folder_ / "kept.csv"), "old");
}

TEST_F(Program, LimitRefusesFilesItCannotWrite) {
  EXPECT_THAT(run("limit scenes/disc.toml --surface surface.stl").err,
              HasSubstr("--surface writes a .vtk or a .csv file"));
  EXPECT_THAT(run("limit scenes/disc.toml --picture picture.png").err, HasSubstr("--picture writes an .svg file"));
  EXPECT_THAT(run("limit scenes/disc.toml --table a.csv --surface a.csv").err, HasSubstr("name the same file"));
  EXPECT_EQ(run("limit scenes/disc.toml --picture p.png").code, 2);
}

TEST_F(Program, LimitStopsWhenAsked) {
  const std::string scene = scene_text(
      "many", test::good_polygon + "[[loads]]\nmoment = { from = 0, to = 1, count = 1000000 }\nforce = [1, 2]\n");
  const int null = open("/dev/null", O_RDWR);
  const pid_t child = start({"limit", scene, "-o", (folder_ / "never.json").string()}, null, null);
  std::this_thread::sleep_for(300ms);
  kill(child, SIGTERM);
  EXPECT_EQ(code_of(child), 128 + SIGTERM);
  close(null);
  EXPECT_FALSE(fs::exists(folder_ / "never.json"));
}

TEST_F(Program, DoesNotReplaceItsScene) {
  EXPECT_THAT(run("tabulate scenes/disc.toml --output scenes/../scenes/disc.toml").err,
              HasSubstr("is the scene itself"));
  EXPECT_EQ(content(scene("disc")), test::good_disc);
}

TEST_F(Program, RefusesWhatIsNoFileWithCode2) {
  for (const auto* const file : {"no.toml", "scenes", "/dev/null", "/dev/zero", "''"}) {
    EXPECT_EQ(run("tabulate " + std::string(file)).code, 2) << file;
  }
}

TEST_F(Program, ReadsASceneFromAPipe) { EXPECT_EQ(run("tabulate /dev/stdin < scenes/disc.toml").code, 0); }

TEST_F(Program, FindsMaterialsBesideTheScene) {
  fs::create_directories(folder_ / "scenes" / "materials");
  std::ofstream(folder_ / "scenes" / "materials" / "jelly.toml")
      << "youngs_modulus = { value = 1e4, source = \"here\" }\npoisson_ratio = { value = 0.5, source = \"here\" }\n";
  scene_text("jelly", test::with(test::good_bodies, "rubber", "jelly"));
  EXPECT_THAT(run("tabulate scenes/jelly.toml").out, HasSubstr("jelly, E = 10000 Pa, nu = 0.5"));
}

TEST_F(Program, FindsItsOwnMaterialsAndThoseOfAFolder) {
  scene_text("bodies", test::good_bodies);
  EXPECT_EQ(run("tabulate scenes/bodies.toml").code, 0);
  EXPECT_EQ(run("tabulate scenes/bodies.toml --materials '" + (test::data_folder / "materials").string() + "'").code,
            0);
  fs::create_directories(folder_ / "empty");
  EXPECT_THAT(run("tabulate scenes/bodies.toml --materials empty").err, HasSubstr("no folder of materials"));
  EXPECT_EQ(run("tabulate scenes/bodies.toml --materials nowhere").code, 2);
}

TEST_F(Program, AMaterialWithoutSourceIsRefusedInItsOwnFile) {
  fs::create_directories(folder_ / "own");
  std::ofstream(folder_ / "own" / "rubber.toml") << "youngs_modulus = { value = 1e6 }\n";
  scene_text("bodies", test::good_bodies);
  const Result result = run("tabulate scenes/bodies.toml --materials own");
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.err, HasSubstr("own/rubber.toml:1: youngs_modulus.source: missing"));
}

TEST_F(Program, ReportsAFullDiskWithCode2) {
  for (const auto* const arguments :
       {"tabulate scenes/disc.toml --output /dev/full", "tabulate scenes/disc.toml >/dev/full", "--help >/dev/full",
        "--version >/dev/full"}) {
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr("cannot be written")) << arguments;
  }
}

TEST_F(Program, ReportsAnOutputThatCannotBeMadeWithCode2) {
  const Result result = run("tabulate scenes/disc.toml --output no/such/folder/table.csv");
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.err, HasSubstr("no/such/folder/table.csv: cannot be made: No such file or directory"));
  EXPECT_EQ(run("tabulate scenes/disc.toml --output scenes").code, 2);
}

TEST_F(Program, SurvivesClosedStandardDescriptors) {
  EXPECT_EQ(run("tabulate scenes/disc.toml --output table.csv >&- 2>&- <&-").code, 0);
  EXPECT_THAT(content(folder_ / "table.csv"), StartsWith("# patchgrip"));
  EXPECT_EQ(run("tabulate scenes/disc.toml >&-").code, 2);
  EXPECT_EQ(run("tabulate scenes/no.toml --output other.csv 2>&-").code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "other.csv"));
}

TEST_F(Program, EndsQuietlyWhenItsReaderLeaves) {
  const Result result = run("tabulate scenes/long.toml | head -n 1");
  EXPECT_THAT(result.out, StartsWith("# patchgrip"));
  EXPECT_THAT(result.err, IsEmpty());
}

class Interrupt : public Program, public ::testing::WithParamInterface<int> {};

TEST_P(Interrupt, LeavesTheOldTableAndNothingElse) {
  std::ofstream(folder_ / "table.csv") << "old";
  const int null = open("/dev/null", O_RDWR);
  const pid_t child = start({"tabulate", scene("long"), "--output", (folder_ / "table.csv").string()}, null, null);
  const auto entries = [&] { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); };
  for (int i = 0; i < 1000 && entries() < 3; ++i) std::this_thread::sleep_for(10ms);
  EXPECT_EQ(entries(), 3) << "scenes, table.csv and the temporary";
  kill(child, GetParam());
  EXPECT_EQ(code_of(child), 128 + GetParam());
  EXPECT_EQ(content(folder_ / "table.csv"), "old");
  EXPECT_EQ(entries(), 2);
  close(null);
}

INSTANTIATE_TEST_SUITE_P(Program, Interrupt, ::testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& signal) { return std::string("Signal") + std::to_string(signal.param); });

// What was found until then is written: rows, and events, whose errors nobody knows yet.
class InterruptedMotion : public Interrupt {
 protected:
  // Stops a motion by `method` after a second; the answer.
  std::string stopped(const std::string& method) {
    const std::string scene = scene_text("slow", R"([contact]
patch = "rectangle"
sides = [0.1, 0.03]
normal_force = 10
[friction]
mu = 0.5
[body]
mass = 1
inertia = 0.001
[[applied]]
force = [6, 0]
sine = { angular_frequency = 3 }
[motion]
times = { from = 0, to = 5000, count = 500001 }
)" + method);
    const auto table = folder_ / "motion.csv", json = folder_ / "answer.json";
    const int null = open("/dev/null", O_RDWR);
    const pid_t child = start({"simulate", scene, "-o", json.string(), "--table", table.string()}, null, null);
    std::this_thread::sleep_for(1s);
    kill(child, GetParam());
    EXPECT_EQ(code_of(child), 128 + GetParam());
    close(null);
    const std::string rows = content(table);
    EXPECT_THAT(rows, HasSubstr("# warning: stopped before its end"));
    EXPECT_GT(std::count(rows.begin(), rows.end(), '\n'), 12);
    return content(json);
  }
};

TEST_P(InterruptedMotion, OfBristlesIsKept) {
  const std::string json = stopped("method = \"return_mapping\"\nstep = 1e-5\nstiffness = 1e6\nturn_stiffness = 1e3\n");
  EXPECT_THAT(json, HasSubstr("stopped before its end: what follows t = "));
  EXPECT_THAT(json, HasSubstr("\"event\": \"break_away\""));
}

TEST_P(InterruptedMotion, OfARigidBodyIsKept) {
  const std::string json = stopped("method = \"rigid\"\n");
  EXPECT_THAT(json, HasSubstr("stopped before its end: what follows t = "));
  EXPECT_THAT(json, HasSubstr("\"event\": \"break_away\""));
  EXPECT_THAT(json, HasSubstr("\"error\": null"));
}

INSTANTIATE_TEST_SUITE_P(Program, InterruptedMotion, ::testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& signal) { return std::string("Signal") + std::to_string(signal.param); });

class Terminal : public Program {
 protected:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    grantpt(master_);
    unlockpt(master_);
    slave_ = open(ptsname(master_), O_RDWR | O_NOCTTY);
    fcntl(master_, F_SETFL, O_NONBLOCK);
  }
  ~Terminal() override {
    close(slave_);
    close(master_);
  }

  std::string shown() const {
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t n = 0; (n = read(master_, part.data(), part.size())) > 0;) {
      text.append(part.data(), static_cast<std::size_t>(n));
    }
    return text;
  }

  // What is shown until `sign` appears, and for a second more.
  std::string shown_after(std::string_view sign) const {
    std::string text;
    const auto start = std::chrono::steady_clock::now();
    while (text.find(sign) == std::string::npos && std::chrono::steady_clock::now() < start + 60s) {
      std::this_thread::sleep_for(1ms);
      text += shown();
    }
    const auto end = std::chrono::steady_clock::now() + 1s;
    while (std::chrono::steady_clock::now() < end) text += shown();
    return text;
  }

  int master_;
  int slave_ = -1;
};

TEST_F(Terminal, ShowsProgressOfALongTableAndErasesIt) {
  const int null = open("/dev/null", O_RDWR);
  const pid_t child = start({"tabulate", scene("long"), "--output", (folder_ / "table.csv").string()}, null, slave_);
  std::string text = shown_after("%");
  kill(child, SIGINT);
  EXPECT_EQ(code_of(child), 128 + SIGINT);
  text += shown();
  EXPECT_THAT(text, StartsWith("\r\x1b[Ktabulate: 0 %"));
  EXPECT_TRUE(text.ends_with("\r\x1b[K")) << "the line stays";
  EXPECT_LE(std::count(text.begin(), text.end(), '%'), 13) << "more than ten a second";
  close(null);
}

TEST_F(Terminal, ShowsProgressOfAFineLimitSurface) {
  const int null = open("/dev/null", O_RDWR);
  const std::string fine = scene_text("fine", test::with(test::good_disc, "[poles]\nlist = [[0.001, 0.002], [0, 0]]",
                                                         "[surface]\nmeridians = 4000\nparallels = 4000"));
  const pid_t child = start({"limit", fine, "--surface", (folder_ / "surface.vtk").string()}, null, slave_);
  std::string text = shown_after("%");
  kill(child, SIGINT);
  EXPECT_EQ(code_of(child), 128 + SIGINT);
  text += shown();
  EXPECT_THAT(text, StartsWith("\r\x1b[Klimit surface: "));
  EXPECT_TRUE(text.ends_with("\r\x1b[K")) << "the line stays";
  close(null);
}

TEST_F(Terminal, ShowsNoProgressOfAShortTable) {
  const int null = open("/dev/null", O_RDWR);
  EXPECT_EQ(code_of(start({"tabulate", scene("disc")}, null, slave_)), 0);
  EXPECT_THAT(shown(), IsEmpty());
  close(null);
}

TEST_F(Terminal, ShowsNoProgressAmongTheRows) {
  const pid_t child = start({"tabulate", scene("long")}, slave_, slave_);
  const std::string text = shown_after("# patchgrip");
  kill(child, SIGTERM);
  code_of(child);
  EXPECT_THAT(text, HasSubstr("# patchgrip"));
  EXPECT_THAT(text, Not(HasSubstr("%")));
}

}  // namespace
}  // namespace patchgrip::cli
