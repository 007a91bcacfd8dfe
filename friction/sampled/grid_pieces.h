// The cells of a pressure grid in boxes: corner sums of each and the loads in their place.
#pragma once

#include <cstddef>
#include <vector>

#include <patchgrip/friction/sampled/corner_sums.h>
#include <patchgrip/friction/sampled/sampled_pressure.h>

namespace patchgrip::friction::kernels {

// Cells i0 <= i < i1, j0 <= j < j1.
struct CellRange {
  std::size_t i0, i1, j0, j1;

  std::size_t columns() const noexcept { return i1 - i0; }
  std::size_t rows() const noexcept { return j1 - j0; }
};

class GridPieces : public Pieces {
 public:
  // Grid lines, and a pressure per cell between them, x running fastest; the force is 1.
  GridPieces(std::vector<double> x, std::vector<double> y, std::vector<double> pressures, Lanes lanes = widest_lanes());

  // Boxes of boxes over all cells, parents first; leaves of at most `columns` by `rows` cells. Fewer levels than
  // PressureNode::most_levels: each halves columns or rows, and there are at most 2^24 cells.
  std::vector<PressureNode> make_tree(std::size_t columns, std::size_t rows);

  void add(std::size_t leaf, double X, double Y, Derivatives derivatives, DistanceSums& sums) const noexcept override;
  void add_excess(std::size_t leaf, const Twist& u, StribeckSums& sums) const noexcept override;
  Roughness roughness(std::size_t leaf) const override;
  void add_loads(std::size_t leaf, const Box& box, const LoadRule& rule, double* loads) const override;

 private:
  struct Leaf {
    CellRange range;
    std::size_t columns;         // padded
    std::size_t corners, spans;  // where they begin
    double bends;
  };

  bool loaded(const CellRange& range) const noexcept;
  Box box_of(const CellRange& range) const noexcept;
  void add_leaf(const CellRange& range);

  std::size_t nx_, ny_;
  std::size_t lanes_;
  std::vector<double> x_, y_;  // grid lines, x padded for whole vectors
  std::vector<double> pressures_;
  std::vector<double> corners_;  // second differences of the pressure, leaf after leaf
  std::vector<CornerSpan> spans_;
  std::vector<Leaf> leaves_;
  CornerKernel gradient_, hessian_;
};

}  // namespace patchgrip::friction::kernels
