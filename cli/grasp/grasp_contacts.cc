#include <patchgrip/cli/grasp/grasp_contacts.h>

#include <fmt/format.h>

#include <array>
#include <memory>
#include <utility>

#include <patchgrip/cli/rubbed_bodies.h>
#include <patchgrip/cli/scene/body_reader.h>
#include <patchgrip/cli/scene/csv_reader.h>
#include <patchgrip/cli/scene/patch_reader.h>
#include <patchgrip/cli/scene/vector_reader.h>
#include <patchgrip/contact/mesh_curvature.h>

namespace patchgrip::cli {
namespace {

using friction::AnyPatch;
using grasp::FrictionCone;
using grasp::Vector3;

constexpr std::size_t most_contacts = 10'000;
constexpr Quantity coordinate = any_sign("a coordinate in m");
constexpr Quantity force_range = positive("a force in N");
constexpr Quantity coefficient = non_negative("a coefficient of friction");

Vector3 to_vector(const SpaceVector& v) { return {v[0], v[1], v[2]}; }

struct DescribedCone {
  FrictionCone cone;
  std::string words;
};

DescribedCone read_model(const TomlReader& table) {
  constexpr std::array<std::string_view, 4> models{"frictionless", "point", "soft_elliptic", "soft_linear"};
  const std::size_t model = table.choice("model", models);
  const auto refuse_unless = [&](bool taken, std::string_view key) {
    if (!taken && table.has(key)) table.refuse(key, fmt::format("not used by a {} contact", models[model]));
  };
  refuse_unless(model > 0, "mu");
  refuse_unless(model > 1, "moment_length");
  for (const std::string_view key : {"radius", "sides", "semi_axes", "vertices", "centre", "angle", "normal_force"}) {
    refuse_unless(false, key);
  }
  if (model == 0) return {FrictionCone::frictionless(), "frictionless"};
  const double mu = table.number("mu", coefficient);
  if (model == 1) return {FrictionCone::point(mu), fmt::format("point with friction, mu = {}", mu)};
  const double e = table.number("moment_length", positive("the length D(0, 0, 1) in m"));
  std::string words =
      fmt::format("{} soft finger, mu = {}, moment length {} m", model == 2 ? "elliptic" : "linear", mu, e);
  return {model == 2 ? FrictionCone::soft_elliptic(mu, e) : FrictionCone::soft_linear(mu, e), std::move(words)};
}

AnyPatch patch_of(const PatchVariant& patch, const friction::PlanarFrame& frame) {
  return visit_patch(patch, frame, [](const auto& own) { return AnyPatch(own); });
}

DescribedCone read_patch_cone(const TomlReader& table) {
  const double mu = table.number("mu", coefficient);
  DescribedPatch patch = read_patch(table);
  const friction::PlanarFrame frame = read_frame(table);
  const std::string where = in_words(frame);
  return {made(table, "patch", [&] { return FrictionCone::patch(mu, patch_of(patch.patch, frame)); }),
          fmt::format("{}{}{}, mu = {}", patch.words, where.empty() ? "" : ", ", where, mu)};
}

// The bodies stay with the contact, to be pressed anew.
void read_bodies_cone(const TomlReader& table, const MaterialLibrary& materials, GraspContact& contact) {
  table.refuse_others(
      {"position", "normal", "tangent", "near", "limit", "mu", "bodies", "normal_force", "centre", "angle"},
      "not used beside 'bodies', from which the patch follows");
  const auto pair = std::make_shared<const BodyPair>(read_two_bodies(table, "bodies", materials));
  if (pair->first.relaxing || pair->second.relaxing) table.refuse("bodies", "friction acts between elastic bodies");
  const double mu = table.number("mu", coefficient);
  const double force = table.number("normal_force", force_range);
  const friction::PlanarFrame frame = read_frame(table);
  const auto pressed = [pair, frame, table](double F) {
    RubbedBodies rubbed = rub(*pair, F, table);
    friction::PlanarFrame turned = frame;
    turned.angle += rubbed.angle;
    return std::pair{patch_of(rubbed.patch, turned), std::move(rubbed)};
  };
  auto [patch, rubbed] = made(table, "bodies", [&] { return pressed(force); });
  if (rubbed.coarse) table.refuse("bodies", "a pressure that is computed on a grid: give it as a patch");
  contact.cone = made(table, "bodies", [&, own = patch] { return FrictionCone::patch(mu, own); });
  contact.grown = [pressed, mu](double F) { return FrictionCone::patch(mu, pressed(F).first); };
  contact.shape_error = rubbed.shape_error;
  contact.words = fmt::format("{}, mu = {}; body A: {}; body B: {}; pressed with {} N", rubbed.notes.front(), mu,
                              pair->first.words, pair->second.words, force);
  contact.warnings = std::move(rubbed.warnings);
}

// Where the scene names a mesh of the object, a contact may be given by a point near its surface.
struct ObjectMesh {
  contact::TriangleMesh mesh;
  double unit;
};

std::optional<ObjectMesh> read_object_mesh(const TomlReader& scene) {
  if (!scene.has("object")) return std::nullopt;
  const TomlReader object = scene.table("object", {"mass", "centre_of_mass", "inertia", "gravity", "mesh", "unit"});
  if (!object.has("mesh")) {
    if (object.has("unit")) object.refuse("unit", "used with 'mesh'");
    return std::nullopt;
  }
  const double unit =
      object.has("unit") ? object.number("unit", positive("the unit of the mesh's coordinates in m")) : 1;
  const std::string file = beside_scene(object, "mesh").string();
  return ObjectMesh{made(object, "mesh", [&] { return contact::TriangleMesh::read(file); }), unit};
}

grasp::ContactFrame read_frame_of(const TomlReader& table, const std::optional<ObjectMesh>& object) {
  grasp::ContactFrame frame;
  if (table.has("near")) {
    if (!object) table.refuse("near", "a point near the surface of the object: give its 'mesh' in [object]");
    for (const std::string_view key : {"position", "normal"}) {
      if (table.has(key)) table.refuse(key, "not used beside 'near', which finds it on the mesh");
    }
    const SpaceVector near = read_vector(table, "near", "a point [x, y, z] in m", coordinate);
    const contact::MeshCurvature at = made(table, "near", [&] {
      return contact::curvature_near(object->mesh,
                                     {near[0] / object->unit, near[1] / object->unit, near[2] / object->unit});
    });
    frame.position = object->unit * Vector3(at.point[0], at.point[1], at.point[2]);
    frame.normal = {at.curvatures.normal[0], at.curvatures.normal[1], at.curvatures.normal[2]};
  } else {
    frame.position = to_vector(read_vector(table, "position", "a place [x, y, z] in m", coordinate));
    frame.normal = to_vector(read_direction(table, "normal", "the outward normal [x, y, z] of the object, not 0"));
  }
  if (table.has("tangent")) {
    frame.tangent = to_vector(read_direction(table, "tangent", "a direction [x, y, z] across the normal, not 0"));
  }
  return frame;
}

GraspContact read_one(const TomlReader& table, const MaterialLibrary& materials,
                      const std::optional<ObjectMesh>& object) {
  GraspContact contact{read_frame_of(table, object), FrictionCone::frictionless(), {}, {}, 0, {}, {}, table.place()};
  const bool model = table.has("model"), patch = table.has("patch"), bodies = table.has("bodies");
  if (model + patch + bodies != 1 && !(patch && model)) {
    table.refuse_table("needs one of 'model' (a name), 'patch' (a name) and two tables [[contacts.bodies]]");
  }
  if (bodies) {
    read_bodies_cone(table, materials, contact);
  } else {
    if (patch && table.has("normal_force")) table.refuse("normal_force", "used with 'bodies': the grip is asked for");
    if (table.has("moment_length") && patch) table.refuse("moment_length", "that of a patch follows from its pressure");
    DescribedCone described = patch ? read_patch_cone(table) : read_model(table);
    contact.cone = std::move(described.cone);
    contact.words = std::move(described.words);
  }
  if (table.has("limit")) contact.limit = table.number("limit", force_range);
  const std::string_view key = table.has("tangent") ? "tangent" : table.has("near") ? "near" : "normal";
  made(table, key, [&] { return grasp::Contact(contact.frame, contact.cone); });
  return contact;
}

}  // namespace

std::vector<GraspContact> read_grasp_contacts(const TomlReader& scene, const MaterialLibrary& materials) {
  if (!scene.has("contacts")) scene.refuse("contacts", "contacts, each under [[contacts]]");
  const auto tables = scene.tables(
      "contacts", {"position",      "normal",       "tangent", "near",      "limit",  "mu",        "model",
                   "moment_length", "patch",        "radius",  "exponent",  "alpha",  "semi_axes", "length",
                   "sides",         "vertices",     "holes",   "pressures", "points", "cell",      "mesh",
                   "unit",          "normal_force", "bodies",  "centre",    "angle"});
  if (tables.empty() || tables.size() > most_contacts) {
    scene.refuse("contacts", fmt::format("1 to {} contacts, each under [[contacts]]", most_contacts));
  }
  const std::optional<ObjectMesh> object = read_object_mesh(scene);
  std::vector<GraspContact> all;
  all.reserve(tables.size());
  for (const TomlReader& table : tables) all.push_back(read_one(table, materials, object));
  return all;
}

std::vector<grasp::Contact> contacts_of(const std::vector<GraspContact>& contacts) {
  std::vector<grasp::Contact> all;
  all.reserve(contacts.size());
  for (const GraspContact& c : contacts) all.emplace_back(c.frame, c.cone);
  return all;
}

}  // namespace patchgrip::cli
