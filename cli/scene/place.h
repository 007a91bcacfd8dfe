// Where a scene says something: kept for what turns out to be wrong only once it is computed with.
//
//     ball.toml:5: contact.normal_force = 1e12: contact_radius = 1e3 is not allowed: must lie in (0, 0.01)
//
// Throws   SceneError, with file, line, key and value.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {

struct Place {
  [[noreturn]] void refuse(std::string_view why) const {
    throw SceneError(file, line, words + ": " + std::string(why));
  }

  std::string file;
  std::size_t line;
  std::string words;  // the key as written, or the name of a table
};

// f(), with what the library refuses told at the place that it follows from. Of places within each other the innermost
// one is told.
template <class F>
auto at(const Place& place, F&& f) {
  try {
    return f();
  } catch (const std::logic_error& error) {
    place.refuse(error.what());
  } catch (const std::range_error& error) {
    place.refuse(error.what());
  } catch (const std::overflow_error& error) {
    place.refuse(error.what());
  }
}

}  // namespace patchgrip::cli
