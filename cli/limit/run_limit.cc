#include <patchgrip/cli/limit/run_limit.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <optional>
#include <utility>
#include <vector>

#include <patchgrip/cli/limit/limit.h>
#include <patchgrip/cli/limit/limit_answer.h>
#include <patchgrip/cli/limit/limit_mesh.h>
#include <patchgrip/cli/limit/limit_scene.h>
#include <patchgrip/cli/limit/surface_files.h>
#include <patchgrip/cli/limit/surface_picture.h>
#include <patchgrip/cli/output_file.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/version.h>

namespace patchgrip::cli {
namespace {

using friction::AnyPatch;

void refuse_extension(const std::string& file, std::string_view option, std::string_view allowed) {
  throw OutputError(fmt::format("{}: {} writes {}", printable(file, std::string::npos), option, allowed));
}

bool is_vtk(const LimitFiles& files) { return files.surface.ends_with(".vtk"); }

void check_names(const LimitFiles& files) {
  if (!files.surface.empty() && !is_vtk(files) && !files.surface.ends_with(".csv")) {
    refuse_extension(files.surface, "--surface", "a .vtk or a .csv file");
  }
  if (!files.picture.empty() && !files.picture.ends_with(".svg")) {
    refuse_extension(files.picture, "--picture", "an .svg file");
  }
}

std::vector<std::string> head_of(const LimitFiles& files, const LimitScene& scene, std::string_view what) {
  std::vector<std::string> head{fmt::format("patchgrip {} limit: {}", version, what),
                                fmt::format("scene: {}", printable(files.scene, std::string::npos))};
  if (!scene.title.empty()) head.push_back("title: " + scene.title);
  for (const std::string& note : scene.contact.notes) head.push_back("contact: " + note);
  if (scene.mu) head.push_back(fmt::format("friction: mu = {}", *scene.mu));
  add_warnings(head, scene.contact.warnings);
  return head;
}

struct Written {
  std::string path, content;
};

std::vector<Written> written(const LimitFiles& files, const LimitScene& scene) {
  LimitAnswer answer = answer_limit(scene);
  std::vector<Written> all{{files.output, to_json(answer, scene, files.scene)}};
  if (!files.table.empty()) {
    all.push_back({files.table, to_csv(load_rows(answer), head_of(files, scene, "what holds each load"))});
  }
  if (files.surface.empty() && files.picture.empty()) return all;

  const AnyPatch patch = any_patch(scene.contact);
  const Capacity capacity = capacity_of(scene);
  const friction::PressureMoments centre = patch.moments();
  const double arm = patch.dissipation(friction::twist_about({centre.x, centre.y}, 1));
  const bool known = has_friction(scene);
  if (known && !(capacity.value > 0)) scene.friction_place.refuse("without friction the limit surface is a point");
  const contact::Estimate resistance =
      known ? contact::Estimate{capacity.value, capacity.relative_error * capacity.value} : contact::Estimate{1, 0};
  const LimitMesh mesh = mesh_of(scene.contact, resistance, scene.surface.length.value_or(arm), scene.surface.meridians,
                                 scene.surface.parallels);
  if (is_vtk(files)) {
    all.push_back({files.surface, to_vtk(mesh, fmt::format("patchgrip {} limit surface: fx, fy, m / L {} with L = {} m",
                                                           version, known ? "[N]" : "per mu F_N", mesh.length))});
  } else if (!files.surface.empty()) {
    auto head = head_of(files, scene, "the limit surface");
    head.push_back(fmt::format("pressure: centroid ({}, {}) m, radius of gyration {} m", centre.x, centre.y,
                               std::sqrt(centre.polar)));
    head.push_back(fmt::format("net: meridians {}, parallels {}", mesh.meridians, mesh.parallels));
    all.push_back({files.surface, to_csv(surface_rows(mesh, !known), head)});
  }
  if (!files.picture.empty()) {
    PictureRequest request{scene.title, scene.surface.azimuth, scene.surface.elevation, std::nullopt, {}};
    if (known) request.capacity = capacity.value;
    answer.loads.resize(std::min(answer.loads.size(), most_loads_drawn));
    request.loads = std::move(answer.loads);
    all.push_back({files.picture, picture_of(mesh, request)});
  }
  return all;
}

}  // namespace

void run_limit(const LimitFiles& files, const MaterialLibrary& materials) {
  check_names(files);
  const LimitScene scene = read_limit_scene(TomlDocument::read(files.scene), materials);
  const std::vector<Written> all = at(scene.contact_place, [&] { return written(files, scene); });
  std::list<OutputFile> outputs;
  for (const Written& one : all) outputs.emplace_back(one.path).write(one.content);
  for (OutputFile& output : outputs) output.commit();
}

}  // namespace patchgrip::cli
