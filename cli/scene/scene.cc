#include <patchgrip/cli/scene/scene.h>

#include <cmath>
#include <optional>
#include <utility>

#include <patchgrip/cli/scene/friction_reader.h>
#include <patchgrip/cli/scene/motion_reader.h>
#include <patchgrip/cli/scene/toml_reader.h>

namespace patchgrip::cli {

Scene load_scene(const std::filesystem::path& file) {
  return read_scene(TomlDocument::read(file), MaterialLibrary::for_scene(file));
}

TomlReader scene_table(const TomlDocument& document) {
  return {document, document.root(), "", {"title",   "contact",  "friction",    "poles",   "adhesion", "load",
                                          "profile", "sweep",    "loads",       "surface", "contacts", "object",
                                          "carried", "question", "family",      "view",    "body",     "normal_force",
                                          "applied", "motion",   "disturbance", "upper"}};
}

Scene read_scene(const TomlDocument& document, const MaterialLibrary& materials) {
  const TomlReader scene = scene_table(document);
  for (const std::string_view key : {"adhesion", "load"}) {
    if (scene.has(key))
      scene.refuse(key, "not used by 'tabulate', which takes a constant normal force without adhesion");
  }
  if (!scene.has("contact")) scene.refuse("contact", "a table [contact] with a patch or two bodies");
  std::string title = scene.has("title") ? scene.text("title") : "";
  std::optional<friction::Law> law;
  if (scene.has("friction")) law = read_friction(scene);
  Motions motions = read_motions(scene);
  Contact contact = read_contact(scene, materials);  // last what may be costly to make
  if (contact.resistance) {
    // Parts with their own coefficients are a patch of the friction stress: their mean coefficient makes mu F_N of it.
    law = friction::Law::coulomb(*contact.resistance / contact.normal_force);
  } else if (!law) {
    law = read_friction(scene);  // says that it is missing
  }
  const bool local = is_local_stribeck(scene);
  if (local) {
    if (contact.resistance) scene.refuse("friction", "parts with their own 'mu' rub by Coulomb's law: give 'mu' alone");
    if (!std::isfinite(stribeck_excess(any_patch(contact), friction::Twist{}).force_error)) {
      friction_table(scene).refuse("stribeck",
                                   "\"mean\" with this contact: a xydas_kao_disc, and a stamp of revolution without a "
                                   "flat end, take Stribeck's law in the mean alone");
    }
  }
  return {std::move(title), std::move(contact), *law, std::move(motions), local};
}

}  // namespace patchgrip::cli
