// Any patch behind one type, for lists of unlike patches: a value that models the concept Patch as what it holds does.
//
//     const std::vector<AnyPatch> fingers{HertzDisc::of_radius(0.004), Placed(Rectangle::of_sides(0.01, 0.02), frame)};
//
// Copies share the patch, which never changes; a copy allocates nothing. Results are those of the patch held, to the
// bit; a call costs one indirect call more.
//
// Units, domain, error   those of the patch held.
// Local    stribeck_excess of a patch held that it does not take is not a number, with an infinite error.
// Fails    what was moved from holds nothing and can only be assigned to.
#pragma once

#include <concepts>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <patchgrip/friction/point_shares.h>
#include <patchgrip/friction/stribeck_excess.h>

namespace patchgrip::friction {

class AnyPatch {
 public:
  template <class P>
  requires(!std::same_as<P, AnyPatch>) && Patch<P> AnyPatch(P patch)
      : held_(std::make_shared<const Held<P>>(std::move(patch))) {}

  double dissipation(const Twist& v) const noexcept { return held_->dissipation(v); }
  Wrench gradient(const Twist& v) const noexcept { return held_->gradient(v); }
  BoundedWrench bounded_gradient(const Twist& v) const noexcept { return held_->bounded_gradient(v); }
  Hessian hessian(const Twist& v) const { return held_->hessian(v); }
  PressureMoments moments() const noexcept { return held_->moments(); }
  double area_radius() const noexcept { return held_->area_radius(); }
  std::vector<PointShare> point_shares() const { return held_->point_shares(); }

  friend BoundedWrench stribeck_excess(const AnyPatch& patch, const Twist& u) noexcept {
    return patch.held_->excess(u);
  }

 private:
  struct Concept {
    virtual ~Concept() = default;
    virtual double dissipation(const Twist&) const noexcept = 0;
    virtual Wrench gradient(const Twist&) const noexcept = 0;
    virtual BoundedWrench bounded_gradient(const Twist&) const noexcept = 0;
    virtual Hessian hessian(const Twist&) const = 0;
    virtual PressureMoments moments() const noexcept = 0;
    virtual double area_radius() const noexcept = 0;
    virtual BoundedWrench excess(const Twist&) const noexcept = 0;
    virtual std::vector<PointShare> point_shares() const = 0;
  };

  template <class P>
  struct Held final : Concept {
    explicit Held(P p) : patch(std::move(p)) {}
    double dissipation(const Twist& v) const noexcept override { return patch.dissipation(v); }
    Wrench gradient(const Twist& v) const noexcept override { return patch.gradient(v); }
    BoundedWrench bounded_gradient(const Twist& v) const noexcept override { return patch.bounded_gradient(v); }
    Hessian hessian(const Twist& v) const override { return patch.hessian(v); }
    PressureMoments moments() const noexcept override { return patch.moments(); }
    double area_radius() const noexcept override { return patch.area_radius(); }
    BoundedWrench excess(const Twist& u) const noexcept override {
      if constexpr (LocalPatch<P>) {
        return stribeck_excess(patch, u);
      } else {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN(), none = std::numeric_limits<double>::infinity();
        return {{nan, nan, nan}, none, none};
      }
    }
    std::vector<PointShare> point_shares() const override { return friction::point_shares(patch); }
    P patch;
  };

  std::shared_ptr<const Concept> held_;
};

}  // namespace patchgrip::friction
