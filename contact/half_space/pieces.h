// Loops and sums over the cells of a grid, shared out to threads in pieces of fixed length.
//
// The sums of the pieces are added in order, so that they do not depend on the number of threads. Nothing is allocated
// after construction.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <patchgrip/contact/half_space/workers.h>

namespace patchgrip::contact {

// Sums over a range of cells, and the largest of a quantity in it, at least 0.
struct Tally {
  std::array<double, 7> sums{};
  double largest = 0;

  Tally& operator+=(const Tally& other) noexcept {
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += other.sums[k];
    largest = std::max(largest, other.largest);
    return *this;
  }
};

class Pieces {
 public:
  Pieces(std::size_t size, Workers& workers) : size_(size), partial_((size + length - 1) / length), workers_(workers) {}

  // act(begin, count) for every piece.
  template <class Act>
  void each(const Act& act) {
    workers_.run(static_cast<int>(partial_.size()), [&](int index, int) {
      const std::size_t begin = static_cast<std::size_t>(index) * length;
      act(begin, std::min(length, size_ - begin));
    });
  }

  // The same; the tallies that it returns are added up.
  template <class Sum>
  Tally total(const Sum& sum) {
    each([&](std::size_t begin, std::size_t count) { partial_[begin / length] = sum(begin, count); });
    Tally total;
    for (const Tally& part : partial_) total += part;
    return total;
  }

 private:
  static constexpr std::size_t length = 8192;

  std::size_t size_;
  std::vector<Tally> partial_;
  Workers& workers_;
};

}  // namespace patchgrip::contact
