// The triangles of a pressure mesh in boxes: edge sums of each and the loads in their place.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <patchgrip/friction/sampled/edge_jumps.h>
#include <patchgrip/friction/sampled/sampled_pressure.h>

namespace patchgrip::friction::kernels {

// Counter-clockwise; the pressure is linear between its corners.
struct LoadedTriangle {
  std::array<std::size_t, 3> corners;
  std::array<double, 3> pressures;
};

class MeshPieces : public Pieces {
 public:
  // Points x, y; the force of all triangles is 1.
  MeshPieces(std::vector<double> x, std::vector<double> y, std::vector<LoadedTriangle> triangles);

  // Boxes of boxes over all triangles, parents first; leaves of at most `count` triangles. Fewer levels than
  // PressureNode::most_levels: above the last 32 boxes are cut in the middle, below them triangles are halved in number
  // twice a level, and there are less than 2^32.
  std::vector<PressureNode> make_tree(std::size_t count);

  void add(std::size_t leaf, double X, double Y, Derivatives derivatives, DistanceSums& sums) const noexcept override;
  void add_excess(std::size_t leaf, const Twist& u, StribeckSums& sums) const noexcept override;
  Roughness roughness(std::size_t leaf) const override;
  void add_loads(std::size_t leaf, const Box& box, const LoadRule& rule, double* loads) const override;

 private:
  struct Range {
    std::size_t begin, end;
  };

  struct Leaf {
    Range triangles;
    Range edges;
    Roughness roughness;
  };

  Box box_of(const Range& range) const noexcept;
  enum class Cut { middle, median };
  std::vector<Range> halves(const Range& range, Cut cut);
  void add_leaf(const Range& range);

  std::vector<double> x_, y_;
  std::vector<LoadedTriangle> triangles_;  // those of a leaf are neighbours
  EdgeJumps edges_;
  std::vector<Leaf> leaves_;
  EdgeKernel gradient_, hessian_;
};

}  // namespace patchgrip::friction::kernels
