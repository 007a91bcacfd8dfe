#include <patchgrip/grasp/extended_polish.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace patchgrip::grasp {

ExtendedPolish::ExtendedPolish(const ScaledGrasp& grasp)
    : grasp_(&grasp), sum_(grasp.contacts()), most_(grasp.contacts()), forces_(grasp.parts().size()) {
  for (const ScaledGrasp::Part& part : grasp.parts()) has_patches_ |= part.element.kind() == Element::Kind::patch;
  if (!has_patches_) parts_.reserve(grasp.parts().size());  // seldom written to
}

bool ExtendedPolish::applies(const GripProblem& problem) noexcept {
  const bool sized = problem.objective == Objective::max_force || problem.objective == Objective::total_force;
  if (has_patches_ || !sized || !grasp_->centre().isZero(0) || 2 * unit >= 0x1p-53L) return false;
  if (grasp_->rank() == 6) return true;
  const Eigen::Matrix<Long, 6, 6> off = grasp_->unresisted().cast<Long>();
  if (!(off * problem.load.cast<Long>()).isZero(0)) return false;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Element& element = grasp_->parts()[i].element;
    const auto borne = [&](Eigen::Index k) {
      return k == 0 || (k > element.first() && k <= element.first() + element.size());
    };
    for (Eigen::Index k = 0; k < 4; ++k) {
      if (borne(k) && !(off * parts_[i].G.col(k)).isZero(0)) return false;
    }
  }
  return true;
}

void ExtendedPolish::set_columns() noexcept {
  parts_.resize(grasp_->parts().size());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Element& element = grasp_->parts()[i].element;
    const Eigen::Matrix<Long, 3, 3> uvn = element.contact().extended_axes();
    const Column<3> r = element.contact().position().cast<Long>() / grasp_->length();
    auto& G = parts_[i].G;
    G << -uvn.col(2), uvn.leftCols<2>(), Column<3>::Zero(), -r.cross(uvn.col(2)), r.cross(uvn.col(0)),
        r.cross(uvn.col(1)), uvn.col(2);
    const bool point = element.kind() == Element::Kind::point, spin = element.kind() == Element::Kind::spin;
    parts_[i].metric = {spin ? 0.L : 1.L, spin ? 0.L : 1.L, point ? 0.L : Long(element.moment_length())};
  }
}

// As in polish.h: of the active parts of a capped contact the last one takes what the others leave.
void ExtendedPolish::pin(const GripProblem& problem, const Polish& polish) noexcept {
  std::ranges::fill(sum_, 0);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!polish.parts()[i].active) continue;
    const std::size_t contact = grasp_->parts()[i].contact;
    if (polish.is_pinned(i)) parts_[i].force = problem.limits[contact] * s_ - sum_[contact];
    sum_[contact] += parts_[i].force;
  }
}

void ExtendedPolish::find_residual(const GripProblem& problem, const Polish& polish) noexcept {
  pin(problem, polish);
  residual_.setZero(polish.unknowns());
  Column<6> balance = problem.load.cast<Long>();
  Long border = 1;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const PartState& state = polish.parts()[i];
    const Element& element = grasp_->parts()[i].element;
    Part& part = parts_[i];
    if (!state.active) continue;
    part.wrench = part.G.col(0);
    const auto T = part.G.rightCols<3>();
    const Column<3> v = T.transpose() * W_;
    if (element.kind() != Element::Kind::normal && state.slide == Slide::slips) {
      const Column<3> stretched = part.metric.cwiseProduct(v);
      part.friction = -element.mu() * part.metric.cwiseProduct(stretched) / stretched.norm();  // per F
      part.wrench += T * part.friction;
    } else if (element.kind() != Element::Kind::normal) {
      const Eigen::Index at = polish.unknown(i) + (polish.is_pinned(i) ? 0 : 1);
      residual_.segment(at, element.size()) = v.segment(element.first(), element.size()).cast<double>();
      balance += T * part.friction;
    }
    balance += part.force * part.wrench;
    if (polish.is_pinned(i)) border += problem.limits[grasp_->parts()[i].contact] * part.wrench.dot(W_);
  }
  const Long one = problem.objective == Objective::total_force ? 1 : 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!polish.parts()[i].active || polish.is_pinned(i)) continue;
    Long rho = parts_[i].wrench.dot(W_) + one;
    // Relative to the pinned part, which is the next.
    if (polish.is_capped(grasp_->parts()[i].contact)) rho -= parts_[i + 1].wrench.dot(W_) + one;
    residual_[polish.unknown(i)] = static_cast<double>(rho);
  }
  residual_.head<6>() = balance.cast<double>();
  if (problem.limited()) residual_[6] = static_cast<double>(border);
}

// Relative size of the change.
ExtendedPolish::Long ExtendedPolish::take_step(const GripProblem& problem, const Polish& polish,
                                               const Polish::Column& step) noexcept {
  W_ += step.head<6>().cast<Long>();
  if (problem.limited()) s_ += step[6];
  Long change = step.head<6>().norm() / W_.norm(), most = std::fabs(s_), moved = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const PartState& state = polish.parts()[i];
    if (!state.active) continue;
    const Element& element = grasp_->parts()[i].element;
    Eigen::Index at = polish.unknown(i);
    const auto add = [&](Long& x) {
      moved = std::max(moved, Long(std::fabs(step[at])));
      x += step[at++];
      most = std::max(most, std::fabs(x));
    };
    if (!polish.is_pinned(i)) add(parts_[i].force);
    if (element.kind() == Element::Kind::normal || state.slide == Slide::slips) continue;
    for (Eigen::Index k = 0; k < element.size(); ++k) add(parts_[i].friction[element.first() + k]);
  }
  return std::max(change, moved / most);
}

void ExtendedPolish::bound(const GripProblem& problem, const Polish& polish, Bracket& bracket) noexcept {
  // Each number of G has less than 24 roundings, those of D and of sums of six come on top.
  constexpr Long lost = 64 * unit, to_double = 0x1p-52L;
  const Long size = W_.norm();
  std::ranges::fill(most_, 0);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Element& element = grasp_->parts()[i].element;
    const Column<3> v = parts_[i].G.rightCols<3>().transpose() * W_;
    const Long D = parts_[i].metric.cwiseProduct(v).norm();
    const Long rho = element.mu() * D - parts_[i].G.col(0).dot(W_);
    // |r / L| is what the moments are longer by.
    const Long arm = 1 + parts_[i].G.bottomRows<3>().colwise().norm().maxCoeff();
    const Long error = lost * size * arm * (1 + element.mu() * (1 + parts_[i].metric[2]));
    Long& most = most_[grasp_->parts()[i].contact];
    most = std::max(most, rho + error);
  }
  Long resistance = 0;
  for (std::size_t c = 0; c < most_.size(); ++c) {
    resistance = problem.limited() ? resistance + problem.limits[c] * most_[c] : std::max(resistance, most_[c]);
  }
  resistance *= 1 + unit * static_cast<Long>(most_.size());
  const Long power = problem.load.cast<Long>().dot(W_) - lost * problem.load.norm() * size;

  Column<6> balance = problem.load.cast<Long>();
  Long total = 0, value = 0;
  std::ranges::fill(sum_, 0);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    forces_[i] = {};
    if (!polish.parts()[i].active) continue;
    const Element& element = grasp_->parts()[i].element;
    const bool slips = polish.parts()[i].slide == Slide::slips;
    Part& part = parts_[i];
    Long F = std::max<Long>(part.force, 0);
    Column<3> t = Column<3>::Zero();
    if (element.kind() != Element::Kind::normal) {
      t = slips ? Column<3>(F * part.friction) : part.friction;
      Column<3> over = t;
      for (int k = 0; k < 3; ++k) over[k] = part.metric[k] > 0 ? t[k] / part.metric[k] : 0;
      F = std::max(F, over.norm() / element.mu() * (1 + lost));
    }
    balance += part.G.col(0) * F + part.G.rightCols<3>() * t;
    total += F;
    Long& sum = sum_[grasp_->parts()[i].contact];
    sum += F;
    forces_[i] = {static_cast<double>(F), t.cast<double>(), slips};
  }
  if (problem.limited()) {
    for (std::size_t c = 0; c < sum_.size(); ++c) value = std::max(value, sum_[c] / problem.limits[c]);
  } else {
    value = total;
  }
  const Long residual = balance.norm() + lost * (total + problem.load.norm());
  // What is left must be rounding: its charge is no proof (bracket.h).
  if (!(resistance > 0) || !(residual <= 0x1p-53L * (total + problem.load.norm()))) return;
  bracket.add_extended(static_cast<double>(power / resistance * (1 - to_double)), (W_ / resistance).cast<double>(),
                       forces_, static_cast<double>(value * (1 + to_double)), static_cast<double>(residual));
}

bool ExtendedPolish::run(const GripProblem& problem, Polish& polish, Bracket& bracket) noexcept {
  constexpr int most_steps = 30;
  if (has_patches_) return false;
  set_columns();
  if (!applies(problem) || !polish.factor(problem)) return false;
  W_ = polish.twist().cast<Long>();
  s_ = polish.value();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].force = polish.parts()[i].force;
    parts_[i].friction = polish.parts()[i].friction.cast<Long>();
  }
  Long before = std::numeric_limits<Long>::infinity();
  for (int k = 0; k < most_steps; ++k) {
    find_residual(problem, polish);
    const Polish::Column& step = polish.step(residual_);
    if (!step.allFinite()) return true;
    const Long change = take_step(problem, polish, step);
    if (change < 8 * unit || change > before / 2) break;
    before = change;
  }
  find_residual(problem, polish);
  bound(problem, polish, bracket);
  return true;
}

}  // namespace patchgrip::grasp
