#include <patchgrip/contact/creep/cycles.h>

namespace patchgrip::contact {

PressedSpring press_spring(const SpringLaw& law, const History& approach, double height, double t) {
  Spring spring;
  std::uint64_t course = 0;
  thread_local std::vector<double> relaxing;
  relaxing.assign(law.modes(), 0.);
  const auto& pieces = approach.pieces();
  for (std::size_t k = 0; k < pieces.size() && pieces[k].start <= t; ++k) {
    const auto& piece = pieces[k];
    const int before = spring.changes;
    if (approach.jump(k) != 0) law.jump(spring, relaxing, piece.value - height);
    const double end = k + 1 < pieces.size() ? std::min(t, pieces[k + 1].start) : t;
    if (end > piece.start) law.advance(spring, relaxing, piece.value - height, piece.rate, end - piece.start);
    for (int change = before; change < spring.changes; ++change) course = next_course(course, k);
  }
  return {law.stress(spring, relaxing), spring.depth, spring.is_touching, course};
}

}  // namespace patchgrip::contact
