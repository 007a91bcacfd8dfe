#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

double rim_excess(double vx, double vy, double w, double radius) noexcept {
  const double W = radius * std::fabs(w);
  const double W2 = W * W;
  // Every square as head + tail (the tail exact by fma); the heads cancel exactly near the rim (Sterbenz) once they are
  // summed largest first.
  const double big = std::max(std::fabs(vx), std::fabs(vy));
  const double small = std::min(std::fabs(vx), std::fabs(vy));
  const double big2 = big * big;
  const double small2 = small * small;
  const double W_tail = std::fma(radius, std::fabs(w), -W);
  const double tails =
      std::fma(big, big, -big2) + std::fma(small, small, -small2) - std::fma(W, W, -W2) - 2 * W * W_tail;
  const double difference = big2 - W2;
  const double back = difference - big2;
  const double lost = (big2 - (difference - back)) - (W2 + back);
  const double sum = difference + small2;
  const double part = sum - difference;
  const double lost_again = (difference - (sum - part)) + (small2 - part);
  return sum + (lost + lost_again + tails);
}

}  // namespace patchgrip::friction
