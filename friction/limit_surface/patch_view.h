// A patch without its type: its derivatives alone.
#pragma once

#include <stdexcept>

#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

struct PatchView {
  const void* patch;
  BoundedWrench (*gradient)(const void* patch, const Twist& v) noexcept;
  bool (*hessian)(const void* patch, const Twist& v, Hessian& h) noexcept;  // false where it is infinite
};

template <Patch P>
PatchView view(const P& patch) noexcept {
  return {&patch, [](const void* p, const Twist& v) noexcept { return static_cast<const P*>(p)->bounded_gradient(v); },
          [](const void* p, const Twist& v, Hessian& h) noexcept {
            try {
              h = static_cast<const P*>(p)->hessian(v);
            } catch (const std::domain_error&) {
              return false;
            }
            return true;
          }};
}

}  // namespace patchgrip::friction
