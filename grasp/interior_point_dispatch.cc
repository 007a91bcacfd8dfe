#include <patchgrip/grasp/interior_point_kernels.h>

namespace patchgrip::grasp {

extern const InteriorPointKernels baseline_kernels;
#ifdef PATCHGRIP_AVX2_KERNELS
extern const InteriorPointKernels avx2_kernels;
#endif

const InteriorPointKernels& interior_point_kernels() noexcept {
#ifdef PATCHGRIP_AVX2_KERNELS
  if (__builtin_cpu_supports("x86-64-v3")) return avx2_kernels;
#endif
  return baseline_kernels;
}

const InteriorPointKernels& baseline_interior_point_kernels() noexcept { return baseline_kernels; }

}  // namespace patchgrip::grasp
