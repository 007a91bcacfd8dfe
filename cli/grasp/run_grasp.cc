#include <patchgrip/cli/grasp/run_grasp.h>

#include <fmt/format.h>

#include <list>
#include <sstream>
#include <utility>
#include <vector>

#include <patchgrip/cli/grasp/grasp_answer.h>
#include <patchgrip/cli/grasp/grasp_files.h>
#include <patchgrip/cli/grasp/grasp_picture.h>
#include <patchgrip/cli/grasp/grasp_scene.h>
#include <patchgrip/cli/output_file.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/grasp/lmi.h>
#include <patchgrip/version.h>

namespace patchgrip::cli {
namespace {

void check_name(const std::string& file, std::string_view option, std::string_view extension) {
  if (file.empty() || file.ends_with(extension)) return;
  throw OutputError(fmt::format("{}: {} writes a {} file", printable(file, std::string::npos), option, extension));
}

std::vector<std::string> head_of(const GraspFiles& files, const GraspScene& scene) {
  std::vector<std::string> head{
      fmt::format("patchgrip {} grasp: {}", version, grasp_questions[static_cast<std::size_t>(scene.question)]),
      fmt::format("scene: {}", printable(files.scene, std::string::npos))};
  if (!scene.title.empty()) head.push_back("title: " + scene.title);
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    head.push_back(fmt::format("contact {}: {}", i + 1, scene.contacts[i].words));
  }
  if (!scene.family) head.push_back(fmt::format("lower and upper [{}]", unit_of(scene.question)));
  return head;
}

std::string inequalities_of(const GraspScene& scene) {
  using grasp::Objective;
  if (scene.question != GraspQuestion::least_grip && scene.question != GraspQuestion::least_total_grip) {
    throw OutputError("--inequalities writes 'least_grip' and 'least_total_grip', not other questions");
  }
  const bool total = scene.question == GraspQuestion::least_total_grip;
  std::ostringstream text;
  write_sdpa(text, grip_lmi(contacts_of(scene.contacts), scene.weight + scene.loads.front(),
                            total ? Objective::total_force : Objective::max_force));
  return text.str();
}

}  // namespace

void run_grasp(const GraspFiles& files, const std::string& question, const MaterialLibrary& materials) {
  check_name(files.vectors, "--vectors", ".vtk");
  check_name(files.picture, "--picture", ".svg");
  check_name(files.inequalities, "--inequalities", ".dat-s");
  const GraspScene scene = read_grasp_scene(TomlDocument::read(files.scene), materials, question);
  const GraspAnswer answer = at(scene.place, [&] { return answer_grasp(scene); });
  std::vector<std::pair<std::string, std::string>> written{{files.output, to_json(answer, scene, files.scene)}};
  if (!files.table.empty()) {
    if (answer.loads.empty()) {
      throw OutputError(fmt::format("{}: --table writes loads and families; '{}' has none",
                                    printable(files.table, std::string::npos),
                                    grasp_questions[static_cast<std::size_t>(scene.question)]));
    }
    written.emplace_back(files.table, to_csv(grasp_rows(answer, scene), head_of(files, scene)));
  }
  if (!files.vectors.empty()) written.emplace_back(files.vectors, to_vtk(answer, scene));
  if (!files.inequalities.empty()) {
    written.emplace_back(files.inequalities, at(scene.place, [&] { return inequalities_of(scene); }));
  }
  if (!files.picture.empty()) written.emplace_back(files.picture, picture_of(answer, scene));
  std::list<OutputFile> outputs;
  for (const auto& [path, content] : written) outputs.emplace_back(path).write(content);
  for (OutputFile& output : outputs) output.commit();
}

}  // namespace patchgrip::cli
