// The widest vector instructions of this CPU that the batch functions can use (friction/batch.h).
#pragma once

#include <string>

namespace patchgrip::bench {

enum class VectorSet { sse2, avx2, avx512 };

VectorSet vector_set();
std::string name_of(VectorSet set);

}  // namespace patchgrip::bench
