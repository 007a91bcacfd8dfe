#include <patchgrip/cli/simulate/run_simulate.h>

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/output_file.h>
#include <patchgrip/cli/scene/friction_reader.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/cli/simulate/simulate_answer.h>
#include <patchgrip/cli/simulate/simulate_patch.h>
#include <patchgrip/cli/simulate/simulate_scene.h>
#include <patchgrip/cli/unanswered.h>
#include <patchgrip/version.h>

namespace patchgrip::cli {
namespace {

std::vector<std::string> head_of(const SimulateFiles& files, const SimulateScene& scene, const MotionRecord& record) {
  std::vector<std::string> head{fmt::format("patchgrip {} simulate: the motion over time", version),
                                fmt::format("scene: {}", printable(files.scene, std::string::npos))};
  if (!scene.title.empty()) head.push_back("title: " + scene.title);
  for (const std::string& note : scene.contact.notes) head.push_back("contact: " + note);
  head.push_back("friction: " + in_words(scene.law, false));
  if (scene.upper) {
    for (const std::string& note : scene.upper->contact.notes) head.push_back("contact of the upper body: " + note);
    head.push_back("friction of the upper body: " + in_words(scene.upper->law, false));
  }
  head.push_back(fmt::format("method: {}", name_of(scene.following.method)));
  add_warnings(head, record.warnings);
  return head;
}

void write(const SimulateFiles& files, const SimulateScene& scene, const MotionRecord& record) {
  std::optional<OutputFile> table;
  if (!files.table.empty()) table.emplace(files.table);
  OutputFile output(files.output);
  output.write(to_json(record, scene, files.scene));
  if (table) {
    table->write(to_csv(table_of(record, scene.point), head_of(files, scene, record)));
    table->commit();
  }
  output.commit();
}

void simulate(const SimulateScene& scene, bool second, MotionRecord& record) {
  at(scene.place, [&] {
    if (scene.point) {
      simulate_point(scene, second, record);
    } else if (scene.upper) {
      simulate_stack(scene, second, record);
    } else {
      simulate_patch(scene, second, record);
    }
  });
}

// What there is of it if it ends early, and why it does.
struct Run {
  MotionRecord record;
  std::exception_ptr end{};
};

Run run(const SimulateScene& scene) {
  Run r;
  r.record.warnings = scene.contact.warnings;
  if (scene.upper) std::ranges::copy(scene.upper->contact.warnings, std::back_inserter(r.record.warnings));
  MotionRecord other;
  try {
    simulate(scene, false, r.record);
    simulate(scene, true, other);
    if (scene.following.method == FrictionMethod::return_mapping) {
      estimate_errors(r.record, other, 2, 0);
    } else {
      estimate_errors(r.record, other, 1, scene.following.tolerance);
    }
  } catch (const SceneError&) {
    throw;
  } catch (const Interrupted&) {
    r.end = std::current_exception();
  } catch (const std::runtime_error& error) {
    r.end = std::make_exception_ptr(Unanswered(scene.place, error.what()));
  }
  return r;
}

}  // namespace

void run_simulate(const SimulateFiles& files, const MaterialLibrary& materials) {
  const SimulateScene scene = read_simulate_scene(TomlDocument::read(files.scene), materials);
  Run r = run(scene);
  if (!r.end) return write(files, scene, r.record);
  if (!r.record.rows.empty()) {
    r.record.warnings.push_back(
        fmt::format("stopped before its end: what follows t = {} s is missing, and errors are not known",
                    r.record.rows.back().time));
    for (auto* rows : {&r.record.rows, &r.record.upper_rows}) {
      for (MotionRow& row : *rows) row.error.setConstant(not_known);
    }
    for (MotionEvent& event : r.record.events) event.time_error = not_known;
    for (auto* rest : {&r.record.rest, &r.record.upper_rest}) {
      if (*rest) (*rest)->time_error = not_known;
    }
    InterruptGuard::forget();
    write(files, scene, r.record);
  }
  std::rethrow_exception(r.end);
}

}  // namespace patchgrip::cli
