// What a step of interior_point.h does to every contact: loops over blocks of four, for the processor at hand.
//
// Lanes without a part have `live` 0, A = 0 and x = z = e_0: their residuals and steps are 0. The first parts of contacts
// 4 k .. 4 k + 3 are the lanes of pack k, and share its caps; their further parts are packs behind those of all contacts,
// in the same lanes.
#pragma once

#include <cstddef>

#include <patchgrip/grasp/lorentz.h>

namespace patchgrip::grasp {

template <std::size_t d, class S>
struct alignas(sizeof(S)) Block {
  using V = Packed<d, S>;
  Packed<6, S> A[d];  // columns
  V x, z;
  lorentz::Scaling<d, S> scaling;
  V rd, rx;          // residual of the dual, right-hand side of the complementarity
  V dx, dz, px, pz;  // step; what it changes by for a change of tau by one
  S cost, live;
  std::size_t caps = 0;  // index
  bool joins = false;    // there are parts before it under the same caps
};

using Cones = Block<4, Pack>;
using ElasticBlock = Block<7, double>;

struct alignas(sizeof(Pack)) Caps {
  Pack slack, u;      // slack of F_i <= c_i s, multiplier
  Pack c, c0, live;   // F + slack = c s + c0 tau
  Pack h, pivot, D;   // slack / u, sum of eta^2 c of its parts, both
  Packed<6, Pack> a;  // sum of A H e_0
  Pack rq, rc, q;     // residuals, right-hand side
  Pack dv, dslack, pv, pslack;
};

struct Blocks {
  Cones* cones;
  std::size_t count;
  Caps* caps;  // one for each pack of contacts
  std::size_t cap_count;
  ElasticBlock* elastic;  // or none
  bool capped;
};

struct Residuals {
  double carried[6];                // sum A x
  double product, cost;             // sum x . z + slack u, of c . x
  double primal, dual, ray;         // largest; of the ray's residual, without cost
  double limit_share, limit_power;  // sum c u, c0 u
};

struct NormalMatrix {
  double lower[21];  // of M, row by row
  double border[6], corner;
};

struct RightSide {
  double right[6], corner;
};

struct Gain {
  double limit_share;  // sum c dv
  double objective;    // of c dx - c0 dv
};

// `corrector`: the step to the residuals times eta; else what a change of tau by one asks for.
struct InteriorPointKernels {
  void (*residuals)(Blocks&, const double* y, double tau, double s, Residuals&) noexcept;
  void (*factor)(Blocks&, NormalMatrix&) noexcept;
  void (*add_right_side)(Blocks&, bool corrector, double eta, RightSide&) noexcept;
  Gain (*directions)(Blocks&, bool corrector, double eta, const double* dy, double ds) noexcept;
  void (*add_tau)(Blocks&, double dtau) noexcept;
  double (*longest)(const Blocks&, double most) noexcept;
  void (*predict)(Blocks&) noexcept;
  void (*correct)(Blocks&, double target) noexcept;
  bool (*inside)(const Blocks&, double a) noexcept;
  void (*advance)(Blocks&, double a) noexcept;
  void (*shift)(Blocks&, const double* u) noexcept;  // x += H A^T u
};

// Of the processor at hand; those that every processor can.
const InteriorPointKernels& interior_point_kernels() noexcept;
const InteriorPointKernels& baseline_interior_point_kernels() noexcept;

}  // namespace patchgrip::grasp
