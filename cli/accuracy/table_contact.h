// A contact of a reference table as a patch of the library, with its sizes rounded and moved (inputs.h).
#pragma once

#include <array>
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <patchgrip/cli/accuracy/inputs.h>
#include <patchgrip/cli/accuracy/node.h>
#include <patchgrip/cli/accuracy/report.h>
#include <patchgrip/cli/patch_variant.h>

namespace patchgrip::cli {

class TableContact {
 public:
  // Nothing if the library does not have it, or a field of it is unknown here: the report then names what is not
  // covered. Throws TableError where it makes no sense.
  static std::optional<TableContact> read(const TableNode& contact, std::string_view section, AccuracyReport& report);

  const std::string& type() const noexcept { return about_.type; }
  bool is_round() const noexcept { return about_.round; }
  bool is_exact() const noexcept { return about_.exact; }
  double extent() const noexcept { return about_.extent; }

  // f(patch)
  template <class F>
  decltype(auto) visit(Inputs inputs, F&& f) const {
    const Instance& instance = instances_[static_cast<std::size_t>(inputs)];
    return visit_patch(instance.patch, {instance.centre.x, instance.centre.y}, std::forward<F>(f));
  }

 private:
  struct Instance {
    PatchVariant patch;
    friction::Pole centre;
  };

  struct Description {
    std::string type;
    bool round = false;
    bool exact = false;  // no size of it was rounded
    double extent = 0;   // farthest point of the patch from its centroid [m]
  };

  TableContact(Description about, std::array<Instance, input_steps.size()> instances)
      : about_(std::move(about)), instances_(std::move(instances)) {}

  Description about_;
  std::array<Instance, input_steps.size()> instances_;  // by Inputs
};

// R = sum of mu_i F_i of several patches, 1 of a single one: what D and the gauge of `patch` are taken per unit of.
template <class P>
double resistance_of(const P& patch) {
  if constexpr (std::same_as<P, friction::Several>) {
    return patch.resistance();
  } else if constexpr (std::same_as<P, friction::Placed<friction::Several>>) {
    return patch.patch().resistance();
  } else {
    return 1;
  }
}

}  // namespace patchgrip::cli
