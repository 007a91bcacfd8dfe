// A result that the optimiser must not leave out.
#pragma once

namespace patchgrip::bench {

template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

}  // namespace patchgrip::bench
