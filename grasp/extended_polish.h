// The solution of polish.h refined to 64 bits, and what it proves there: for brackets that double precision leaves open.
//
// In double a bracket is no narrower than some 2^-53 |W| / sum c_i rho_i+, as each number of the grasp is rounded
// (bracket.h). Next to a cone that is not closed |W| grows with the inverse square of what is missing. Here the frames of
// the contacts are normalised in long double, the residual of the equations of polish.h is evaluated in it, and each step
// against it is taken with the matrix of polish.h in double (iterative refinement). The bounds are those of bracket.h with
// roundings of 2^-64; they hold whatever the iteration came to. The twist and forces themselves are handed over in
// double: evaluated from those the bracket is as wide as before.
//
// Domain   max_force and total_force; contacts without patches, whose D is known in double; grasps about the origin; and
//          nothing off the range of a deficient grasp (scaled_grasp.h), not even by rounding, which would count as real.
//          run() does nothing elsewhere, or where long double is no longer than double.
// Memory   allocated by the constructor.
#pragma once

#include <limits>
#include <vector>

#include <patchgrip/grasp/bracket.h>
#include <patchgrip/grasp/polish.h>

namespace patchgrip::grasp {

class ExtendedPolish {
 public:
  explicit ExtendedPolish(const ScaledGrasp& grasp);

  // From the states of `polish`; what it proves goes to `bracket`. False outside the domain.
  bool run(const GripProblem& problem, Polish& polish, Bracket& bracket) noexcept;

 private:
  using Long = long double;
  template <int n>
  using Column = Eigen::Matrix<Long, n, 1>;

  struct Part {
    Eigen::Matrix<Long, 6, 4> G;
    Column<3> metric;  // D = |metric v|
    Long force = 0;
    Column<3> friction = Column<3>::Zero();
    Column<6> wrench = Column<6>::Zero();  // per F
  };

  static constexpr Long unit = std::numeric_limits<Long>::epsilon() / 2;

  bool applies(const GripProblem& problem) noexcept;
  void set_columns() noexcept;
  void pin(const GripProblem& problem, const Polish& polish) noexcept;
  void find_residual(const GripProblem& problem, const Polish& polish) noexcept;
  Long take_step(const GripProblem& problem, const Polish& polish, const Polish::Column& step) noexcept;
  void bound(const GripProblem& problem, const Polish& polish, Bracket& bracket) noexcept;

  const ScaledGrasp* grasp_;
  bool has_patches_ = false;
  std::vector<Part> parts_;
  std::vector<Long> sum_, most_;  // of forces, of rho+, by contact
  std::vector<PartForce> forces_;
  Column<6> W_ = Column<6>::Zero();
  Long s_ = 0;
  Polish::Column residual_;
};

}  // namespace patchgrip::grasp
