// Many poles in one call, against a loop over the same arrays and against copying them.
#pragma once

#include <cstddef>
#include <vector>

#include <patchgrip/bench/case.h>
#include <patchgrip/bench/poles.h>

namespace patchgrip::bench {

// The label's parameter is the number of poles in the table.
Case hertz_batch_case(double radius, const PoleSet& poles, std::size_t judged);

constexpr std::size_t small_table = 1024;     // 40 KiB: stays in the cache
constexpr std::size_t large_table = 1 << 23;  // 320 MiB: does not

// For either table: the batch, one call of the scalar function per pole, a copy of the 40 bytes per pole.
std::vector<Case> batch_cases();

}  // namespace patchgrip::bench
