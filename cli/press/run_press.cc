#include <patchgrip/cli/press/run_press.h>

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include <patchgrip/cli/output_file.h>
#include <patchgrip/cli/press/press_creep.h>
#include <patchgrip/cli/press/press_tables.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/cli/unanswered.h>
#include <patchgrip/version.h>

namespace patchgrip::cli {
namespace {

std::vector<std::string> head_of(const PressFiles& files, const PressScene& scene, std::string_view what) {
  std::vector<std::string> head{fmt::format("patchgrip {} press: {}", version, what),
                                fmt::format("scene: {}", printable(files.scene, std::string::npos))};
  if (!scene.title.empty()) head.push_back("title: " + scene.title);
  for (const std::string& note : scene.notes) head.push_back("contact: " + note);
  return head;
}

struct Written {
  std::string json;
  std::string csv;
};

Written written_over_time(const PressFiles& files, const PressScene& scene) {
  const PressedOverTime pressed = press_over_time(scene);
  auto head = head_of(files, scene, scene.profile.times ? "the surface over time" : "the contact over time");
  head.insert(head.end(), pressed.head.begin(), pressed.head.end());
  head.push_back("law: " + pressed.answer.main.law);
  add_warnings(head, pressed.answer.warnings);
  return {to_json(pressed.answer, files.scene, scene.title, scene.notes), to_csv(pressed.table, head)};
}

// At the load of the scene; where that is swept, at the first value that has an answer, and says which have none.
Pressed press_or_first(const PressScene& scene) {
  if (!scene.load_is_swept) return press(scene);
  std::optional<SceneError> first;
  for (std::size_t i = 0; i < scene.sweep->values.size(); ++i) {
    try {
      Pressed pressed = press_swept(scene, i);
      if (first) {
        pressed.answer.warnings.push_back(fmt::format("the answer is that at {}; the values before it have none: {}",
                                                      load_place(at_sweep_value(scene, i)).words, first->what()));
      }
      return pressed;
    } catch (const SceneError& error) {
      if (!first) first = error;
    }
  }
  throw *first;
}

Written written(const PressFiles& files, const PressScene& scene) {
  if (std::holds_alternative<TimedLoad>(scene.load)) return written_over_time(files, scene);
  Pressed pressed = press_or_first(scene);
  Written result;
  if (!files.table.empty()) {
    const bool sweeps = scene.sweep.has_value();
    // They are among those of the sweep.
    if (scene.load_is_swept) pressed.answer.warnings.clear();
    const Table table = sweeps ? sweep_table(scene, pressed.answer.warnings) : surface_table(scene, pressed);
    auto head = head_of(files, scene,
                        sweeps                                   ? "answers over a sweep"
                        : pressed.map && !scene.profile.distance ? "pressure over the cells of a grid"
                                                                 : "pressure and displacement along a line");
    head.push_back("law: " + pressed.answer.main.law);
    add_warnings(head, pressed.answer.warnings);
    result.csv = to_csv(table, head);
  }
  result.json = to_json(pressed.answer, files.scene, scene.title, scene.notes);
  return result;
}

}  // namespace

void run_press(const PressFiles& files, const MaterialLibrary& materials) {
  const PressScene scene = read_press_scene(TomlDocument::read(files.scene), materials);
  const Written result = [&] {
    try {
      return at(load_place(scene), [&] { return written(files, scene); });
    } catch (const SceneError&) {
      throw;
    } catch (const Unanswered&) {
      throw;
    } catch (const std::runtime_error& error) {
      throw Unanswered(load_place(scene), error.what());
    }
  }();
  std::optional<OutputFile> table;
  if (!files.table.empty()) table.emplace(files.table);
  OutputFile output(files.output);
  output.write(result.json);
  if (table) {
    table->write(result.csv);
    table->commit();
  }
  output.commit();
}

}  // namespace patchgrip::cli
