#include <patchgrip/cli/limit/limit.h>

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/progress.h>
#include <patchgrip/cli/scene/place.h>

namespace patchgrip::cli {
namespace {

using friction::AnyPatch;
using friction::GaugeStatus;
using friction::LimitSurface;

constexpr double unit = 0x1p-53;

// The limit surface, and those that tell how far it may be off.
struct Surfaces {
  using Surface = LimitSurface<AnyPatch>;

  static Surfaces of(const Contact& contact) {
    const auto other = [&](const AnyPatch& patch) { return Surface(placed(patch, contact.frame)); };
    Surfaces all{Surface(any_patch(contact)), {}, {}, {}, {contact.frame.x, contact.frame.y}};
    if (contact.coarse) all.coarse.emplace(other(*contact.coarse));
    if (contact.scatter) {
      all.narrow.emplace(other(contact.scatter->narrow));
      all.wide.emplace(other(contact.scatter->wide));
    }
    return all;
  }

  LoadAnswer answer(const Capacity& capacity, const friction::Wrench& load) const {
    if (narrow) return answer_load(own, *narrow, *wide, centre, capacity, load);
    return coarse ? answer_load(own, *coarse, capacity, load) : answer_load(own, capacity, load);
  }

  Surface own;
  std::optional<Surface> coarse, narrow, wide;
  friction::Pole centre;
};

// What holds for all loads: how much force and moment at most.
std::vector<Result> contact_results(const LimitScene& scene, const Surfaces& surfaces, const Capacity& capacity) {
  std::vector<Result> results{
      {"normal_force", scene.contact.normal_force, scene.contact.sum_error * scene.contact.normal_force, "N"}};
  if (!has_friction(scene)) return results;
  if (scene.mu) results.push_back({"mu", *scene.mu, 0, "1"});
  results.push_back({"greatest_force", capacity.value, capacity.relative_error * capacity.value, "N"});
  const LoadAnswer pure = surfaces.answer(capacity, {0, 0, 1});
  if (pure.gauge.value > 0 && std::isfinite(pure.gauge.value)) {
    results.push_back({"greatest_moment_alone", pure.margin.value, pure.margin.error, "N m"});
  }
  return results;
}

}  // namespace

Capacity capacity_of(const LimitScene& scene) {
  Capacity capacity{.shape_error = scene.contact.shape_error};
  if (scene.contact.resistance) {
    capacity.value = *scene.contact.resistance;
    capacity.relative_error = scene.contact.sum_error;
  } else if (scene.mu) {
    capacity.value = *scene.mu * scene.contact.normal_force;
    capacity.relative_error = unit + scene.contact.sum_error;
  }
  return capacity;
}

LimitAnswer answer_limit(const LimitScene& scene) {
  const Surfaces surfaces = Surfaces::of(scene.contact);
  const Capacity capacity = capacity_of(scene);
  LimitAnswer answer{
      at(scene.contact_place, [&] { return contact_results(scene, surfaces, capacity); }), {}, scene.contact.warnings};
  const std::size_t count = scene.loads.size();
  Progress progress("limit", count, Progress::wanted(Progress::no_output));
  answer.loads.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    InterruptGuard::check();
    const friction::Wrench load = scene.loads[i];
    LoadAnswer held = at(scene.loads.place(i), [&] { return surfaces.answer(capacity, load); });
    if (held.gauge.status == GaugeStatus::not_finite || !std::isfinite(held.gauge_error)) {
      scene.loads.place(i).refuse(fmt::format("the gauge of the load ({} N, {} N, {} N m) leaves the range of a double",
                                              load.fx, load.fy, load.m));
    }
    answer.loads.push_back(std::move(held));
    progress.at(i);
  }
  if (count > most_loads_listed) {
    answer.warnings.push_back(
        fmt::format("the first {} of {} loads are listed here; --table writes all", most_loads_listed, count));
  }
  return answer;
}

}  // namespace patchgrip::cli
