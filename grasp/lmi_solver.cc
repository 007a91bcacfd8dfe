#include <patchgrip/grasp/lmi_solver.h>

#include <sdpa_call.h>

#include <patchgrip/contact/require.h>

namespace patchgrip::grasp {
namespace {

void load(SDPA& sdpa, const GripLmi& lmi) {
  const int unknowns = static_cast<int>(lmi.costs.size()), blocks = static_cast<int>(lmi.blocks.size());
  sdpa.inputConstraintNumber(unknowns);
  sdpa.inputBlockNumber(blocks);
  for (int l = 1; l <= blocks; ++l) {
    const GripLmi::Block& block = lmi.blocks[static_cast<std::size_t>(l - 1)];
    sdpa.inputBlockSize(l, block.diagonal ? -block.size : block.size);
    sdpa.inputBlockType(l, block.diagonal ? SDPA::LP : SDPA::SDP);
  }
  sdpa.initializeUpperTriangleSpace();
  for (int k = 1; k <= unknowns; ++k) sdpa.inputCVec(k, lmi.costs[static_cast<std::size_t>(k - 1)]);
  for (const GripLmi::Entry& e : lmi.entries) sdpa.inputElement(e.matrix, e.block, e.row, e.column, e.value);
  sdpa.initializeUpperTriangle();
  sdpa.initializeSolve();
}

// SDPA's getPhaseValue() calls the problem of x, the primal one of its manual and of getPhaseString(), the dual.
LmiAnswer::Status status(SDPA::PhaseType phase) {
  switch (phase) {
    case SDPA::pdOPT:
      return LmiAnswer::Status::solved;
    case SDPA::dUNBD:
    case SDPA::pINF_dFEAS:
    case SDPA::pdINF:  // one of the two, and W = 0 is always feasible
      return LmiAnswer::Status::cannot_hold;
    default:
      return LmiAnswer::Status::unsolved;
  }
}

// Y, the block of each part.
std::vector<Eigen::MatrixXd> matrices(SDPA& sdpa, const GripLmi& lmi) {
  std::vector<Eigen::MatrixXd> Y;
  for (std::size_t i = 0; i < lmi.parts.size(); ++i) {
    const GripLmi::Block& block = lmi.blocks[i];
    const double* y = sdpa.getResultYMat(static_cast<int>(i) + 1);
    if (block.diagonal) {
      Y.emplace_back(Eigen::Map<const Eigen::VectorXd>(y, block.size).asDiagonal());
    } else {
      Y.emplace_back(Eigen::Map<const Eigen::MatrixXd>(y, block.size, block.size));
    }
  }
  return Y;
}

}  // namespace

void LmiSettings::check() const {
  contact::require_in("tolerance", tolerance, 1e-12, 1e-2);
  if (max_iterations < 1) contact::refuse("max_iterations", max_iterations, "must be at least 1");
}

LmiAnswer solve(const GripLmi& lmi, const LmiSettings& settings) {
  settings.check();
  SDPA sdpa;
  sdpa.setDisplay(nullptr);
  sdpa.setParameterType(SDPA::PARAMETER_DEFAULT);
  sdpa.setParameterEpsilonStar(settings.tolerance);
  sdpa.setParameterEpsilonDash(settings.tolerance);
  sdpa.setParameterMaxIteration(settings.max_iterations);
  sdpa.setNumThreads(1);
  load(sdpa, lmi);
  sdpa.solve();

  LmiAnswer answer;
  answer.status = status(sdpa.getPhaseValue());
  answer.iterations = sdpa.getIteration();
  const std::span<const double> x(sdpa.getResultXVec(), lmi.costs.size());
  answer.lower = lmi_value(lmi, x);
  answer.upper = -lmi.force * sdpa.getDualObj();
  answer.twist = lmi_twist(lmi, x);
  answer.forces = contact_forces(lmi, matrices(sdpa, lmi));
  sdpa.terminate();
  return answer;
}

}  // namespace patchgrip::grasp
