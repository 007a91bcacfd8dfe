// Prony series in 113 bits and back to double: for what is formed there and rounded once.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <patchgrip/contact/creep/conversion.h>

namespace patchgrip::contact {

using Wide = boost::multiprecision::cpp_bin_float_quad;

template <class To, class From>
Modes<To> modes_as(const Modes<From>& modes) {
  Modes<To> converted;
  for (const auto& mode : modes) converted.push_back({static_cast<To>(mode.strength), static_cast<To>(mode.time)});
  return converted;
}

template <class To, class From>
BasicRelaxationModulus<To> modulus_as(const BasicRelaxationModulus<From>& modulus) {
  return BasicRelaxationModulus<To>::of(static_cast<To>(modulus.equilibrium()), modes_as<To>(modulus.modes()),
                                        static_cast<To>(modulus.dashpot()));
}

template <class To, class From>
BasicCreepCompliance<To> compliance_as(const BasicCreepCompliance<From>& compliance) {
  return BasicCreepCompliance<To>::of(static_cast<To>(compliance.instantaneous()), modes_as<To>(compliance.modes()),
                                      static_cast<To>(compliance.fluidity()));
}

}  // namespace patchgrip::contact
