// Marks a function to be compiled for the vectors of several processors; the loader takes the version that fits.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PATCHGRIP_VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PATCHGRIP_VECTOR_CLONES
#endif
