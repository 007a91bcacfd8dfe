#include <patchgrip/friction/several.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {
namespace {

constexpr double unit = 0x1p-53;

struct Weighted {
  AnyPatch patch;
  long double friction;  // w_i
  long double pressure;  // share of the normal force
};

// About the common centroid: sum of w_i (polar_i + |s_i - s|^2).
PressureMoments combined(const std::vector<Weighted>& parts, long double Weighted::*weight) {
  long double x = 0, y = 0, polar = 0;
  for (const Weighted& part : parts) {
    const PressureMoments s = part.patch.moments();
    x += part.*weight * s.x;
    y += part.*weight * s.y;
  }
  for (const Weighted& part : parts) {
    const PressureMoments s = part.patch.moments();
    polar += part.*weight * (s.polar + (s.x - x) * (s.x - x) + (s.y - y) * (s.y - y));
  }
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(polar)};
}

}  // namespace

struct Several::Data {
  struct Term {
    AnyPatch patch;
    double weight;  // w_i
  };

  std::vector<Part> parts;
  std::vector<Term> terms;  // without those that bear no friction
  PressureMoments moments;
  PressureMoments pressure_moments;
  double resistance;
  double normal_force;
  double area_radius;
};

Several Several::of_parts(std::vector<Part> parts) {
  if (parts.empty()) throw std::invalid_argument("parts = [] is not allowed: there must be at least one");
  long double resistance = 0, force = 0, square = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string part = "parts[" + std::to_string(i) + "].";
    contact::require_positive(part + "normal_force", parts[i].normal_force);
    contact::require_non_negative(part + "mu", parts[i].mu);
    force += parts[i].normal_force;
    resistance += static_cast<long double>(parts[i].mu) * parts[i].normal_force;
    square += std::pow(static_cast<long double>(parts[i].patch.area_radius()), 2);
  }
  auto data = std::make_shared<Data>();
  data->resistance = contact::require_representable("resistance", static_cast<double>(resistance));
  data->normal_force = contact::require_representable("normal force of all parts", static_cast<double>(force));
  data->area_radius = static_cast<double>(std::sqrt(square));
  std::vector<Weighted> weighted;
  for (const Part& part : parts) {
    weighted.push_back(
        {part.patch, static_cast<long double>(part.mu) * part.normal_force / resistance, part.normal_force / force});
    if (part.mu > 0) data->terms.push_back({part.patch, static_cast<double>(weighted.back().friction)});
  }
  data->moments = combined(weighted, &Weighted::friction);
  data->pressure_moments = combined(weighted, &Weighted::pressure);
  data->parts = std::move(parts);
  return Several(std::move(data));
}

double Several::dissipation(const Twist& v) const noexcept {
  double sum = 0;
  for (const auto& [patch, weight] : data_->terms) sum += weight * patch.dissipation(v);
  return sum;
}

Wrench Several::gradient(const Twist& v) const noexcept {
  Wrench sum;
  for (const auto& [patch, weight] : data_->terms) {
    const Wrench g = patch.gradient(v);
    sum.fx += weight * g.fx;
    sum.fy += weight * g.fy;
    sum.m += weight * g.m;
  }
  return sum;
}

template <class F>
BoundedWrench Several::sum_of(const F& wrench_of) const noexcept {
  BoundedWrench sum;
  for (const auto& [patch, weight] : data_->terms) {
    const BoundedWrench g = wrench_of(patch);
    sum.value.fx += weight * g.value.fx;
    sum.value.fy += weight * g.value.fy;
    sum.value.m += weight * g.value.m;
    // Rounded: the weight, its product, the sum.
    sum.force_error += weight * (g.force_error + 2 * unit * std::hypot(g.value.fx, g.value.fy)) +
                       unit * std::hypot(sum.value.fx, sum.value.fy);
    sum.moment_error += weight * (g.moment_error + 2 * unit * std::fabs(g.value.m)) + unit * std::fabs(sum.value.m);
  }
  return sum;
}

BoundedWrench Several::bounded_gradient(const Twist& v) const noexcept {
  return sum_of([&](const AnyPatch& patch) { return patch.bounded_gradient(v); });
}

BoundedWrench stribeck_excess(const Several& several, const Twist& u) noexcept {
  return several.sum_of([&](const AnyPatch& patch) { return stribeck_excess(patch, u); });
}

Hessian Several::hessian(const Twist& v) const {
  Hessian sum;
  for (const auto& [patch, weight] : data_->terms) {
    const Hessian h = patch.hessian(v);
    sum.xx += weight * h.xx;
    sum.xy += weight * h.xy;
    sum.xw += weight * h.xw;
    sum.yy += weight * h.yy;
    sum.yw += weight * h.yw;
    sum.ww += weight * h.ww;
  }
  return sum;
}

PressureMoments Several::moments() const noexcept { return data_->moments; }
double Several::area_radius() const noexcept { return data_->area_radius; }

std::vector<PointShare> Several::point_shares() const {
  std::vector<PointShare> all;
  for (const auto& [patch, weight] : data_->terms) {
    for (const PointShare& p : patch.point_shares()) all.push_back({p.x, p.y, weight * p.share});
  }
  return all;
}

double Several::resistance() const noexcept { return data_->resistance; }
double Several::normal_force() const noexcept { return data_->normal_force; }
PressureMoments Several::pressure_moments() const noexcept { return data_->pressure_moments; }
const std::vector<Several::Part>& Several::parts() const noexcept { return data_->parts; }

BoundedWrench friction_wrench(const Several& several, const Twist& v) noexcept {
  const double R = several.resistance();
  const auto [g, force_error, moment_error] = several.bounded_gradient(v);
  return {{-R * g.fx, -R * g.fy, -R * g.m},
          R * (force_error + 2 * unit * std::hypot(g.fx, g.fy)),
          R * (moment_error + 2 * unit * std::fabs(g.m))};
}

}  // namespace patchgrip::friction
