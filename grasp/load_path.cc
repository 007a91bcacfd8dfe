#include <patchgrip/grasp/load_path.h>

#include <algorithm>

namespace patchgrip::grasp {

Eigen::Ref<Eigen::VectorXd> LoadPath::add(const Vector6& load) noexcept {
  lengths_[next_] = count_ > 0 ? lengths_[slot(0)] + (load - loads_.col(slot(0))).norm() : 0;
  loads_.col(next_) = load;
  const Eigen::Index added = next_;
  next_ = (next_ + 1) % most;
  count_ = std::min(count_ + 1, most);
  return solutions_.col(added);
}

LoadPath::Weights LoadPath::weights(Eigen::Index n, double length) const noexcept {
  Weights l = Weights::Zero();
  for (Eigen::Index k = 0; k < n; ++k) {
    double& weight = l[slot(k)] = 1;
    for (Eigen::Index j = 0; j < n; ++j) {
      if (j != k) weight *= (length - lengths_[slot(j)]) / (lengths_[slot(k)] - lengths_[slot(j)]);
    }
  }
  return l;
}

const Eigen::VectorXd& LoadPath::lead(const Vector6& load) noexcept {
  constexpr double alike = 1e-9;    // on a straight line two loads do as well as five
  constexpr double heaviest = 1e3;  // more would lift the rounding of the solutions
  const double step = (load - loads_.col(slot(0))).norm(), length = lengths_[slot(0)] + step;
  Weights best = weights(1, length);
  double least = step;
  for (Eigen::Index n = 2; n <= count_; ++n) {
    const Weights l = weights(n, length);
    const double off = (loads_ * l - load).norm();
    if (!(off <= least + alike * step) || l.cwiseAbs().sum() > heaviest) continue;
    least = std::min(least, off);
    best = l;
  }
  guess_ = best[slot(0)] * solutions_.col(slot(0));
  for (Eigen::Index k = 1; k < count_; ++k) guess_ += best[slot(k)] * solutions_.col(slot(k));
  return guess_;
}

}  // namespace patchgrip::grasp
