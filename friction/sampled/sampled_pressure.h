// A pressure made of pieces, ready to be evaluated: exact sums near the pole, point loads in its place away from it.
//
// The pieces are gathered in boxes and those in larger boxes up to one that holds all. Each box keeps the loads that
// stand for its pieces (point_loads.h); a pole that is `reach` half diagonals or more away sees those, a nearer one the
// boxes within, and within the smallest the exact sums of the pieces. With one box for everything all poles near the
// patch see exact sums. Beyond 6 radii of the centroid there is the polynomial of kernels/far_field.h.
//
// All of it in a frame of its own: origin at the centroid of the pressure (rounded), lengths divided by a power of two
// near the half diagonal, unit normal force.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <patchgrip/friction/kernels/far_field.h>
#include <patchgrip/friction/patch.h>
#include <patchgrip/friction/sampled/distance_sums.h>
#include <patchgrip/friction/sampled/point_loads.h>
#include <patchgrip/friction/sampled/stribeck_sums.h>

namespace patchgrip::friction::kernels {

// How rough the pieces of a box are: with r >= every distance their exact sums are good to
// u (2 jumps r + bends r^2) in grad S, r times that in S.
struct Roughness {
  double jumps = 0;
  double bends = 0;
};

// The pieces of the smallest boxes (leaves).
class Pieces {
 public:
  virtual ~Pieces() = default;
  // Adds the sums of a leaf's pieces for the pole (X, Y).
  virtual void add(std::size_t leaf, double X, double Y, Derivatives derivatives,
                   DistanceSums& sums) const noexcept = 0;
  // Adds their excess at the twist u, about the frame's origin.
  virtual void add_excess(std::size_t leaf, const Twist& u, StribeckSums& sums) const noexcept = 0;
  virtual Roughness roughness(std::size_t leaf) const = 0;
  // Their loads at the Chebyshev points of `box`, the share of the whole patch: adds to order^2 numbers.
  virtual void add_loads(std::size_t leaf, const Box& box, const LoadRule& rule, double* loads) const = 0;
};

struct PressureNode {
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::uint32_t most_children = 4;
  static constexpr std::uint32_t most_levels = 64;  // below the root; makers of trees prove that theirs have fewer

  Box box;
  std::uint32_t first_child = 0;
  std::uint32_t children = 0;
  std::uint32_t leaf = none;
};

struct PressureFrame {
  double x = 0, y = 0;                     // origin, the rounded centroid [m]
  long double offset_x = 0, offset_y = 0;  // true centroid minus origin [m]
  double centroid_error = 0;               // of that [m]
  double scale = 1;                        // [m], a power of two
  double polar = 0;                        // second moment about the centroid [m^2]
  double area = 0;                         // [m^2]
  double highest = 0;                      // largest pressure in this frame
};

class SampledPressure {
 public:
  // `nodes` parents first, the root at 0. Throws std::length_error for more levels or children than a node may have.
  SampledPressure(const PressureFrame& frame, std::vector<PressureNode> nodes, std::unique_ptr<const Pieces> pieces,
                  double tolerance);

  double dissipation(const Twist& v) const noexcept;
  Wrench gradient(const Twist& v) const noexcept;
  BoundedWrench bounded_gradient(const Twist& v) const noexcept;
  Hessian hessian(const Twist& v) const;
  BoundedWrench stribeck_excess(const Twist& u) const noexcept;
  const PressureFrame& frame() const noexcept { return frame_; }
  double tolerance() const noexcept { return tolerance_; }

 private:
  struct Local;
  struct NodeError {
    double share;  // sum of the loads' sizes
    Roughness roughness;
  };

  void fill_loads();
  FarField far_field() const;
  Local local(const Twist& v) const noexcept;
  template <class Far, class Near>
  void visit(const Twist& v, Far&& far, Near&& near) const noexcept;
  Wrench centred_gradient(const Twist& v) const noexcept;
  BoundedWrench centred_bound(const Twist& v) const noexcept;
  Hessian centred_hessian(const Twist& v) const noexcept;

  PressureFrame frame_;
  double tolerance_;
  LoadRule rule_;
  double radius_;  // of the farthest corner of the root box
  std::vector<PressureNode> nodes_;
  std::vector<NodeError> errors_;
  std::vector<double> loads_;
  std::unique_ptr<const Pieces> pieces_;
  FarField far_;
  LoadKernels kernels_;
};

}  // namespace patchgrip::friction::kernels
