#include <patchgrip/contact/half_space/cosine_transform.h>
#include <patchgrip/contact/half_space/fftw_plan.h>

#include <algorithm>
#include <cstddef>

namespace patchgrip::contact {

using namespace fft;

// A line that is even about both ends, from the transform of all its period: two lines at once, one of them imaginary.
// (FFTW's own transform of even lines takes two to three times as long.)
void cosine_transform(int columns, int rows, double factor, double* table, Resources resources) {
  constexpr int pairs = 4;  // of columns, on a line of the cache
  const auto period = [](int count) { return 2 * (count - 1); };
  const std::size_t size = round_up(period(std::max(columns, rows)), aligned) + aligned;
  Array<Complex> buffers(threads(resources) * pairs * size, resources.memory);
  const auto buffer = [&](int thread, int pair) {
    return buffers.data() + static_cast<std::size_t>(thread * pairs + pair) * size;
  };
  const auto plan_line = [&](int count) {
    return [&, count] {
      return fftw_plan_dft_1d(period(count), raw(buffers.data()), raw(buffers.data()), FFTW_FORWARD, FFTW_ESTIMATE);
    };
  };
  const auto transform = [&](const Plan& plan, int count, Complex* line) {
    std::reverse_copy(line + 1, line + count - 1, line + count);
    fftw_execute_dft(plan.plan, raw(line), raw(line));
  };
  const auto row = [&](int j) { return table + static_cast<std::size_t>(j) * static_cast<std::size_t>(columns); };

  const Plan plan_row(plan_line(columns));
  resources.set_up.each_row((rows + 1) / 2, [&](int pair, int thread) {
    double *one = row(2 * pair), *other = row(std::min(2 * pair + 1, rows - 1));  // the last row may have no other
    Complex* line = buffer(thread, 0);
    for (int i = 0; i < columns; ++i) line[i] = {one[i], other[i]};
    transform(plan_row, columns, line);
    for (int i = 0; i < columns; ++i) {
      one[i] = line[i].real();
      other[i] = line[i].imag();
    }
  });

  const Plan plan_column(plan_line(rows));
  resources.set_up.run((columns + 2 * pairs - 1) / (2 * pairs), [&](int part, int thread) {
    const int first = part * 2 * pairs, count = std::min(pairs, (columns - first + 1) / 2);
    const int next = first + 2 * pairs, fetched = std::min(2 * pairs, columns - next);
    const auto other = [&](int i) { return std::min(i + 1, columns - 1); };
    for (int j = 0; j < rows; ++j) {
      const double* from = row(j);
      for (int c = 0, i = first; c < count; ++c, i += 2) buffer(thread, c)[j] = {from[i], from[other(i)]};
    }
    for (int c = 0; c < count; ++c) {
      if (fetched > 0) {
        for (int j = rows * c / count; j < rows * (c + 1) / count; ++j) fetch(row(j) + next, fetched);
      }
      transform(plan_column, rows, buffer(thread, c));
    }
    for (int j = 0; j < rows; ++j) {
      double* to = row(j);
      for (int c = 0, i = first; c < count; ++c, i += 2) {
        const Complex value = factor * buffer(thread, c)[j];
        to[i] = value.real();
        to[other(i)] = i + 1 < columns ? value.imag() : value.real();
      }
    }
  });
}

}  // namespace patchgrip::contact
