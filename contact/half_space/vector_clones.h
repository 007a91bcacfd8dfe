// Marks a function to be compiled for the vectors of several processors; the loader takes the version that fits. (Not
// under the thread sanitizer, which is not ready yet when the loader chooses.)
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define PATCHGRIP_VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PATCHGRIP_VECTOR_CLONES
#endif
