// A convolution on a grid as a product in Fourier space: y = F^-1 (symbol . F x), the symbol real and even.
//
// Padding `doubled` puts the field into a square of twice its sides filled up with zeros, so that nothing comes round
// from the other side; `none` takes the field for one period.
//
// The padded square is never stored: rows are transformed one by one, then columns, a few at a time, copied into
// buffers that stay in the cache. A column of n values and n zeros has two transforms of length n: of x_j for the even
// frequencies, of x_j exp(-i pi j / n) for the odd ones. 16 (padded) or 8 bytes a cell are all the memory, and nothing
// is allocated after construction. Plans are FFTW's estimates, so that a run repeats to the last bit.
//
// The result does not depend on the number of threads. FFTW makes its plans one at a time in a process: all plans of
// this library take the same lock; a program that plans transforms of its own meanwhile must call
// fftw_make_planner_thread_safe().
//
// Throws   std::bad_alloc, std::runtime_error when FFTW makes no plan.
#pragma once

#include <cstddef>
#include <memory>

#include <patchgrip/contact/half_space/resources.h>

namespace patchgrip::contact {

enum class Padding { none, doubled };

class SpectralProduct {
 public:
  SpectralProduct(int nx, int ny, Padding padding, Resources resources);
  ~SpectralProduct();
  SpectralProduct(SpectralProduct&&) noexcept;
  SpectralProduct& operator=(SpectralProduct&&) noexcept;

  // The symbol is given for the frequencies 0 ... n/2 in each direction, n the (padded) length: that of x frequency i
  // and y frequency j at index i rows() + j, 0 <= i < columns(), 0 <= j < rows().
  int columns() const noexcept;
  int rows() const noexcept;
  std::size_t symbol_size() const noexcept;
  double normalisation() const noexcept;  // what the symbol must be divided by

  // x and y may be the same.
  void apply(const double* symbol, const double* x, double* y, Workers& workers);

  // The symbol that apply() takes: value(i, j) of x frequency i and y frequency j, over the normalisation.
  template <class Value>
  void fill_symbol(const Value& value, double* symbol, Workers& workers) const {
    workers.run(columns(), [&](int i, int) {
      double* column = symbol + static_cast<std::ptrdiff_t>(i) * rows();
      for (int j = 0; j < rows(); ++j) column[j] = value(i, j) / normalisation();
    });
  }

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace patchgrip::contact
