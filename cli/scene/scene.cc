#include <patchgrip/cli/scene/scene.h>

#include <utility>

#include <patchgrip/cli/scene/friction_reader.h>
#include <patchgrip/cli/scene/motion_reader.h>
#include <patchgrip/cli/scene/toml_reader.h>

namespace patchgrip::cli {

Scene load_scene(const std::filesystem::path& file) {
  return read_scene(TomlDocument::read(file), MaterialLibrary::for_scene(file));
}

TomlReader scene_table(const TomlDocument& document) {
  return {
      document, document.root(), "", {"title", "contact", "friction", "poles", "adhesion", "load", "profile", "sweep"}};
}

Scene read_scene(const TomlDocument& document, const MaterialLibrary& materials) {
  const TomlReader scene = scene_table(document);
  for (const std::string_view key : {"adhesion", "load"}) {
    if (scene.has(key))
      scene.refuse(key, "not used by 'tabulate', which takes a constant normal force without adhesion");
  }
  if (!scene.has("contact")) scene.refuse("contact", "a table [contact] with a patch or two bodies");
  std::string title = scene.has("title") ? scene.text("title") : "";
  const friction::Law law = read_friction(scene);
  Motions motions = read_motions(scene);
  return {std::move(title), read_contact(scene, materials), law,
          std::move(motions)};  // last what may be costly to make
}

}  // namespace patchgrip::cli
