// Compiled once for each processor of interior_point_kernels.h; PATCHGRIP_KERNELS is the name of what comes out.
#include <patchgrip/grasp/interior_point_kernels.h>

namespace patchgrip::grasp {
namespace {

#define PATCHGRIP_LOOP __attribute__((always_inline))

template <class F>
PATCHGRIP_PACKED void each(const Blocks& blocks, const F& f) {
  for (std::size_t i = 0; i < blocks.count; ++i) f(blocks.cones[i]);
  if (blocks.elastic != nullptr) f(*blocks.elastic);
}

template <class F>
PATCHGRIP_PACKED void each_cap(const Blocks& blocks, const F& f) {
  if (!blocks.capped) return;
  for (std::size_t i = 0; i < blocks.cap_count; ++i) f(blocks.caps[i]);
}

// Caps are those of packs: never of the elastic block.
PATCHGRIP_PACKED Caps* caps_of(const Blocks& blocks, const Cones& b) {
  return blocks.capped ? blocks.caps + b.caps : nullptr;
}
PATCHGRIP_PACKED Caps* caps_of(const Blocks&, const ElasticBlock&) { return nullptr; }

// sum += A x
template <std::size_t d, class S>
PATCHGRIP_PACKED void add_product(Packed<6, S>& sum, const Packed<6, S> (&A)[d], const Packed<d, S>& x) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < d; ++k) sum[i] += A[k][i] * x[k];
  }
}

template <class S>
PATCHGRIP_PACKED Packed<6, S> zero6() {
  return {{S{}, S{}, S{}, S{}, S{}, S{}}};
}

template <class S>
struct Sums {
  Packed<6, S> carried = zero6<S>();
  S product{}, cost{}, dual{}, ray{};
};

template <std::size_t d, class S>
PATCHGRIP_PACKED void block_residuals(Block<d, S>& b, Caps* caps, const double* y, double tau, Sums<S>& sums) {
  add_product(sums.carried, b.A, b.x);
  for (std::size_t k = 0; k < d; ++k) b.rd[k] = -b.live * (dot(b.A[k], y) + b.z[k]);
  if constexpr (d == 4) {
    if (caps != nullptr) {
      caps->rq -= b.live * b.x[0];
      b.rd[0] += b.live * caps->u;
    }
  }
  S rest{};
  for (std::size_t k = 1; k < d; ++k) rest = larger<S>(rest, size<S>(b.rd[k]));
  sums.ray = larger<S>(sums.ray, larger<S>(rest, size<S>(b.rd[0])));
  b.rd[0] += tau * b.cost;
  sums.dual = larger<S>(sums.dual, larger<S>(rest, size<S>(b.rd[0])));
  sums.cost += b.cost * b.x[0];
  sums.product += b.live * dot(b.x, b.z);
}

template <class S>
PATCHGRIP_PACKED void add(Residuals& r, const Sums<S>& sums) {
  for (std::size_t i = 0; i < 6; ++i) r.carried[i] += sum(sums.carried[i]);
  r.product += sum(sums.product);
  r.cost += sum(sums.cost);
  r.dual = larger(r.dual, largest(sums.dual));
  r.ray = larger(r.ray, largest(sums.ray));
}

void residuals(Blocks& blocks, const double* y, double tau, double s, Residuals& r) noexcept {
  r = {};
  each_cap(blocks, [&](Caps& cap) PATCHGRIP_LOOP { cap.rq = cap.live * (cap.c0 * tau + cap.c * s - cap.slack); });
  Sums<Pack> packs;
  for (std::size_t i = 0; i < blocks.count; ++i) {
    Cones& b = blocks.cones[i];
    block_residuals(b, caps_of(blocks, b), y, tau, packs);
  }
  add(r, packs);
  if (blocks.elastic != nullptr) {
    Sums<double> one;
    block_residuals(*blocks.elastic, nullptr, y, tau, one);
    add(r, one);
  }
  Pack primal{}, product{}, share{}, power{};
  each_cap(blocks, [&](const Caps& cap) PATCHGRIP_LOOP {
    primal = larger<Pack>(primal, size<Pack>(cap.rq));
    product += cap.live * cap.slack * cap.u;
    share += cap.c * cap.u;
    power += cap.c0 * cap.u;
  });
  r.primal = largest(primal);
  r.product += sum(product);
  r.limit_share = sum(share);
  r.limit_power = sum(power);
}

template <class S>
struct Lower {
  S m[21] = {};

  // += sum k C C^T over the columns
  template <std::size_t n>
  PATCHGRIP_PACKED void add(const Packed<6, S> (&C)[n]) {
    for (std::size_t i = 0, at = 0; i < 6; ++i) {
      for (std::size_t j = 0; j <= i; ++j, ++at) {
        for (std::size_t k = 0; k < n; ++k) m[at] += C[k][i] * C[k][j];
      }
    }
  }
};

template <class S>
PATCHGRIP_PACKED void add(NormalMatrix& M, const Lower<S>& lower) {
  for (std::size_t i = 0; i < 21; ++i) M.lower[i] += sum(lower.m[i]);
}

// Parts of one contact share its cap: what a part adds to those before it is the square of their difference, and of
// their sum under the cap,
//
//     a_1 a_1^T / p_1 + a_2 a_2^T / p_2 = (a_1 + a_2)(a_1 + a_2)^T / (p_1 + p_2) + d d^T p_1 p_2 / (p_1 + p_2)
template <std::size_t d, class S>
PATCHGRIP_PACKED void block_factor(Block<d, S>& b, Caps* caps, Lower<S>& lower) {
  b.scaling.set(b.x, b.z);
  const auto& w = b.scaling.w;
  const S c = 1.0 + 2.0 * dot<1>(w, w);
  Packed<6, S> q = w[1] * b.A[1];
  for (std::size_t k = 2; k < d; ++k) q += w[k] * b.A[k];
  // (1 - c^-1/2) / |w_1|^2 = 2 (1 - c^-1/2) / (c - 1)
  const S r = root(c), share = 2.0 / (r * (1.0 + r));
  Packed<6, S> squares[d];
  for (std::size_t k = 1; k < d; ++k) squares[k] = b.scaling.eta * (b.A[k] - S(share * w[k]) * q);
  const S pivot = b.scaling.eta2 * c;
  const Packed<6, S> a = b.scaling.eta2 * (c * b.A[0] + S(2.0 * w[0]) * q);
  if constexpr (d == 4) {
    if (caps != nullptr && !b.joins) {
      caps->pivot = pivot;
      caps->a = a;
      const Packed<6, S> three[] = {squares[1], squares[2], squares[3]};
      lower.add(three);
      return;
    }
    if (caps != nullptr) {
      const S weight = b.live * root(S(pivot * caps->pivot / (pivot + caps->pivot)));
      squares[0] = weight * (S(1.0 / pivot) * a - S(1.0 / caps->pivot) * caps->a);
      caps->pivot += b.live * pivot;
      caps->a += a;
      lower.add(squares);
      return;
    }
  }
  squares[0] = S(1.0 / root(pivot)) * a;
  lower.add(squares);
}

void factor(Blocks& blocks, NormalMatrix& M) noexcept {
  M = {};
  Lower<Pack> lower;
  for (std::size_t i = 0; i < blocks.count; ++i) {
    Cones& b = blocks.cones[i];
    block_factor(b, caps_of(blocks, b), lower);
  }
  Packed<6, Pack> border = zero6<Pack>();
  Pack corner{};
  each_cap(blocks, [&](Caps& cap) PATCHGRIP_LOOP {
    cap.h = cap.slack / cap.u;
    cap.D = cap.h + cap.pivot;
    const Pack share = cap.c / cap.D;
    border += share * cap.a;
    corner += cap.c * share;
    const Packed<6, Pack> square[] = {root(Pack(cap.h / (cap.pivot * cap.D))) * cap.a};
    lower.add(square);
  });
  add(M, lower);
  for (std::size_t i = 0; i < 6; ++i) M.border[i] = sum(border[i]);
  M.corner = sum(corner);
  if (blocks.elastic != nullptr) {
    Lower<double> one;
    block_factor(*blocks.elastic, nullptr, one);
    add(M, one);
  }
}

template <bool corrector, std::size_t d, class S>
PATCHGRIP_PACKED void block_right_side(Block<d, S>& b, Caps* caps, double eta, Packed<6, S>& carried) {
  Packed<d, S> t;
  if constexpr (corrector) {
    t = b.rx - b.scaling.H(eta * b.rd);
  } else {
    for (std::size_t k = 1; k < d; ++k) t[k] = S{};
    t[0] = -b.cost;
    t = b.scaling.H(t);
  }
  add_product(carried, b.A, t);
  if constexpr (d == 4) {
    if (caps != nullptr) caps->q -= t[0];
  }
}

template <bool corrector>
PATCHGRIP_PACKED void add_right_side(Blocks& blocks, double eta, RightSide& r) {
  each_cap(blocks, [&](Caps& cap) PATCHGRIP_LOOP {
    if constexpr (corrector) {
      cap.q = eta * cap.rq - cap.rc;
    } else {
      cap.q = cap.c0;
    }
  });
  Packed<6, Pack> carried = zero6<Pack>();
  for (std::size_t i = 0; i < blocks.count; ++i) {
    Cones& b = blocks.cones[i];
    block_right_side<corrector>(b, caps_of(blocks, b), eta, carried);
  }
  Pack corner{};
  each_cap(blocks, [&](Caps& cap) PATCHGRIP_LOOP {
    const Pack share = cap.q / cap.D;
    carried += share * cap.a;
    corner += cap.c * share;
  });
  for (std::size_t i = 0; i < 6; ++i) r.right[i] -= sum(carried[i]);
  r.corner -= sum(corner);
  if (blocks.elastic != nullptr) {
    Packed<6, double> one = zero6<double>();
    block_right_side<corrector>(*blocks.elastic, nullptr, eta, one);
    for (std::size_t i = 0; i < 6; ++i) r.right[i] -= one[i];
  }
}

void right_side(Blocks& blocks, bool corrector, double eta, RightSide& r) noexcept {
  corrector ? add_right_side<true>(blocks, eta, r) : add_right_side<false>(blocks, eta, r);
}

template <bool corrector, std::size_t d, class S>
PATCHGRIP_PACKED void block_directions(Block<d, S>& b, const Caps* caps, double eta, const double* dy, S& objective) {
  Packed<d, S> z;
  for (std::size_t k = 0; k < d; ++k) z[k] = (corrector ? S(eta * b.rd[k]) : S{}) - dot(b.A[k], dy);
  if constexpr (!corrector) z[0] += b.cost;
  if constexpr (d == 4) {
    if (caps != nullptr) z[0] -= b.live * (corrector ? caps->dv : caps->pv);
  }
  const Packed<d, S> Hz = b.scaling.H(z);
  if constexpr (corrector) {
    b.dz = z;
    b.dx = b.rx - Hz;
    objective += b.cost * b.dx[0];
  } else {
    b.pz = z;
    b.px = -1.0 * Hz;
    objective += b.cost * b.px[0];
  }
}

template <bool corrector>
PATCHGRIP_PACKED Gain directions(Blocks& blocks, double eta, const double* dy, double ds) {
  Pack share{}, objective{};
  each_cap(blocks, [&](Caps& cap) PATCHGRIP_LOOP {
    const Pack dv = (cap.q - dot(cap.a, dy) + cap.c * ds) / cap.D;
    share += cap.c * dv;
    objective -= cap.c0 * dv;
    if constexpr (corrector) {
      cap.dv = dv;
      cap.dslack = cap.rc + cap.h * dv;
    } else {
      cap.pv = dv;
      cap.pslack = cap.h * dv;
    }
  });
  for (std::size_t i = 0; i < blocks.count; ++i) {
    Cones& b = blocks.cones[i];
    block_directions<corrector>(b, caps_of(blocks, b), eta, dy, objective);
  }
  double one = 0;
  if (blocks.elastic != nullptr) block_directions<corrector>(*blocks.elastic, nullptr, eta, dy, one);
  return {sum(share), sum(objective) + one};
}

Gain either_directions(Blocks& blocks, bool corrector, double eta, const double* dy, double ds) noexcept {
  return corrector ? directions<true>(blocks, eta, dy, ds) : directions<false>(blocks, eta, dy, ds);
}

void add_tau(Blocks& blocks, double dtau) noexcept {
  each(blocks, [&](auto& b) PATCHGRIP_LOOP {
    b.dx += dtau * b.px;
    b.dz += dtau * b.pz;
  });
  each_cap(blocks, [&](Caps& cap) PATCHGRIP_LOOP {
    cap.dv += dtau * cap.pv;
    cap.dslack += dtau * cap.pslack;
  });
}

template <std::size_t d, class S>
PATCHGRIP_PACKED double shortened(double a, const Packed<d, S>& x, const Packed<d, S>& dx) {
  const auto stays = lorentz::is_well_inside(x + a * dx);
  if (all(stays)) return a;
  const S t = stays ? S{} + a : lorentz::step_to_boundary(x, dx);
  return smaller(a, -largest(S(-t)));
}

// Only what leaves its cone with the step so far makes it shorter.
double longest(const Blocks& blocks, double most) noexcept {
  double a = most;
  each(blocks, [&](const auto& b) PATCHGRIP_LOOP {
    a = shortened(a, b.x, b.dx);
    a = shortened(a, b.z, b.dz);
  });
  Pack least = Pack{} + a;
  each_cap(blocks, [&](const Caps& cap) PATCHGRIP_LOOP {
    least = cap.dslack < 0.0 ? smaller<Pack>(least, -cap.slack / cap.dslack) : least;
    least = cap.dv > 0.0 ? smaller<Pack>(least, cap.u / cap.dv) : least;
  });
  return -largest(Pack(-least));
}

void predict(Blocks& blocks) noexcept {
  each(blocks, [](auto& b) PATCHGRIP_LOOP { b.rx = -1.0 * (b.live * b.x); });
  each_cap(blocks, [](Caps& cap) PATCHGRIP_LOOP { cap.rc = -cap.live * cap.slack; });
}

void correct(Blocks& blocks, double target) noexcept {
  each(blocks, [&](auto& b) PATCHGRIP_LOOP {
    const auto l = b.scaling.T(b.z);
    auto r = lorentz::product(l, l) + lorentz::product(b.scaling.inverse_T(b.dx), b.scaling.T(b.dz));
    r[0] -= target;
    b.rx = -b.live * b.scaling.T(lorentz::quotient(r, l));
  });
  each_cap(blocks, [&](Caps& cap) PATCHGRIP_LOOP {
    cap.rc = cap.live * (target - cap.slack * cap.u + cap.dslack * cap.dv) / cap.u;
  });
}

template <std::size_t d, class S>
PATCHGRIP_PACKED bool is_inside(const Packed<d, S>& x) {
  return all(lorentz::is_well_inside(x)) || all(lorentz::is_inside(x));
}

bool inside(const Blocks& blocks, double a) noexcept {
  bool all = true;
  each(blocks,
       [&](const auto& b) PATCHGRIP_LOOP { all = all && is_inside(b.x + a * b.dx) && is_inside(b.z + a * b.dz); });
  return all;
}

void advance(Blocks& blocks, double a) noexcept {
  each(blocks, [&](auto& b) PATCHGRIP_LOOP {
    b.x += a * b.dx;
    b.z += a * b.dz;
  });
  each_cap(blocks, [&](Caps& cap) PATCHGRIP_LOOP {
    cap.u -= a * cap.dv;
    cap.slack += a * cap.dslack;
  });
}

void shift(Blocks& blocks, const double* u) noexcept {
  each(blocks, [&]<std::size_t d, class S>(Block<d, S>& b) PATCHGRIP_LOOP {
    Packed<d, S> t;
    for (std::size_t k = 0; k < d; ++k) t[k] = dot(b.A[k], u);
    b.x += b.scaling.H(t);
  });
}

}  // namespace

extern const InteriorPointKernels PATCHGRIP_KERNELS;
const InteriorPointKernels PATCHGRIP_KERNELS{residuals, factor,  right_side, either_directions, add_tau, longest,
                                             predict,   correct, inside,     advance,           shift};

}  // namespace patchgrip::grasp
