#include <patchgrip/contact/half_space/fftw_plan.h>
#include <patchgrip/contact/half_space/spectral_product.h>
#include <patchgrip/contact/half_space/vector_clones.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace patchgrip::contact {
namespace {

using namespace fft;

constexpr int block = 4;  // columns that are copied together: a line of the cache

// std::complex's product would test for infinities.
Complex times(Complex z, Complex w) {
  return {z.real() * w.real() - z.imag() * w.imag(), z.real() * w.imag() + z.imag() * w.real()};
}

}  // namespace

struct SpectralProduct::Body {
  Body(int columns, int rows, Padding padding, Resources resources)
      : nx(columns),
        ny(rows),
        padded(padding == Padding::doubled),
        mx(padded ? 2 * nx : nx),
        my(padded ? 2 * ny : ny),
        spectrum_columns(mx / 2 + 1),
        row_size(round_up(mx, 2 * aligned)),
        stride(round_up(spectrum_columns, block)),
        column_size(round_up(ny, aligned) +
                    aligned),  // not a power of two: columns of a block must not evict each other
        halves(padded ? 2 : 1),
        row_buffer(threads(resources) * row_size, resources.memory),
        spectrum(static_cast<std::size_t>(ny) * stride, resources.memory),
        column_buffer(threads(resources) * buffer_size(), resources.memory),
        turn(static_cast<std::size_t>(ny), resources.memory),
        row_forward(
            [this] { return fftw_plan_dft_r2c_1d(mx, row_buffer.data(), raw(spectrum.data()), FFTW_ESTIMATE); }),
        row_back([this] { return fftw_plan_dft_c2r_1d(mx, raw(spectrum.data()), row_buffer.data(), FFTW_ESTIMATE); }),
        column_forward([this] { return plan_column(FFTW_FORWARD); }),
        column_back([this] { return plan_column(FFTW_BACKWARD); }) {
    for (int j = 0; j < ny; ++j) turn[static_cast<std::size_t>(j)] = std::polar(1., -std::numbers::pi * j / ny);
  }

  // A block of columns, twice if padded, and one column of transforms.
  std::size_t buffer_size() const noexcept { return static_cast<std::size_t>(halves * block + 1) * column_size; }

  fftw_plan plan_column(int sign) {
    Complex* first = column_buffer.data();
    return fftw_plan_dft_1d(ny, raw(first), raw(first + column_size), sign, FFTW_ESTIMATE);
  }

  Complex* spectrum_row(int j) { return spectrum.data() + static_cast<std::size_t>(j) * stride; }

  void fetch_row(int j) {
    if (j < ny) fetch(spectrum_row(j), spectrum_columns);
  }

  void transform_row(int j, int thread, const double* x) {
    const double* from = x + static_cast<std::size_t>(j) * static_cast<std::size_t>(nx);
    fetch_row(j + 1);
    if (std::all_of(from, from + nx, [](double value) { return value == 0; })) {
      std::fill_n(spectrum_row(j), spectrum_columns, Complex());
      return;
    }
    double* row = row_buffer.data() + static_cast<std::size_t>(thread) * row_size;
    std::fill(std::copy_n(from, nx, row), row + mx, 0.);
    fftw_execute_dft_r2c(row_forward.plan, row, raw(spectrum_row(j)));
  }

  void transform_row_back(int j, int thread, double* y) {
    double* row = row_buffer.data() + static_cast<std::size_t>(thread) * row_size;
    fetch_row(j + 1);
    fftw_execute_dft_c2r(row_back.plan, raw(spectrum_row(j)), row);
    std::copy_n(row, nx, y + static_cast<std::size_t>(j) * static_cast<std::size_t>(nx));
  }

  // One of `parts` of a block of columns.
  void fetch_block(int first, int part, int parts) {
    if (first >= spectrum_columns) return;
    for (int j = ny * part / parts; j < ny * (part + 1) / parts; ++j) fetch(spectrum_row(j) + first, block);
  }

  PATCHGRIP_VECTOR_CLONES void filter_columns(int first, int thread, const double* symbol) {
    Complex* buffer = column_buffer.data() + static_cast<std::size_t>(thread) * buffer_size();
    Complex* even = buffer;
    Complex* odd = even + static_cast<std::size_t>(block) * column_size;
    Complex* transform = even + static_cast<std::size_t>(halves * block) * column_size;
    for (int j = 0; j < ny; ++j) {
      const Complex* from = spectrum_row(j) + first;
      const auto row = static_cast<std::size_t>(j);
      for (std::size_t c = 0; c < block; ++c) even[c * column_size + row] = from[c];
      if (!padded) continue;
      for (std::size_t c = 0; c < block; ++c) odd[c * column_size + row] = times(from[c], turn[row]);
    }

    for (int c = 0; c < std::min(block, spectrum_columns - first); ++c) {
      const double* factors = symbol + static_cast<std::size_t>(first + c) * static_cast<std::size_t>(my / 2 + 1);
      for (int half = 0; half < halves; ++half) {
        fetch_block(first + block, c * halves + half, block * halves);
        Complex* column = (half == 0 ? even : odd) + static_cast<std::size_t>(c) * column_size;
        fftw_execute_dft(column_forward.plan, raw(column), raw(transform));
        // Frequencies up to my / 2, then the same ones back.
        const int middle = (my / 2 - half) / halves + 1;
        for (int j = 0; j < middle; ++j) transform[j] *= factors[halves * j + half];
        for (int j = middle; j < ny; ++j) transform[j] *= factors[my - halves * j - half];
        fftw_execute_dft(column_back.plan, raw(transform), raw(column));
      }
    }

    for (int j = 0; j < ny; ++j) {
      Complex* to = spectrum_row(j) + first;
      const auto row = static_cast<std::size_t>(j);
      for (std::size_t c = 0; c < block; ++c) to[c] = even[c * column_size + row];
      if (!padded) continue;
      for (std::size_t c = 0; c < block; ++c) to[c] += times(odd[c * column_size + row], std::conj(turn[row]));
    }
  }

  int nx, ny;
  bool padded;
  int mx, my, spectrum_columns;
  std::size_t row_size, stride, column_size;
  int halves;
  Array<double> row_buffer;
  Array<Complex> spectrum, column_buffer;
  Array<Complex> turn;  // exp(-i pi j / ny)
  Plan row_forward, row_back, column_forward, column_back;
};

SpectralProduct::SpectralProduct(int nx, int ny, Padding padding, Resources resources)
    : body_(std::make_unique<Body>(nx, ny, padding, resources)) {}
SpectralProduct::~SpectralProduct() = default;
SpectralProduct::SpectralProduct(SpectralProduct&&) noexcept = default;
SpectralProduct& SpectralProduct::operator=(SpectralProduct&&) noexcept = default;

int SpectralProduct::columns() const noexcept { return body_->spectrum_columns; }
int SpectralProduct::rows() const noexcept { return body_->my / 2 + 1; }
std::size_t SpectralProduct::symbol_size() const noexcept {
  return static_cast<std::size_t>(rows()) * static_cast<std::size_t>(columns());
}
double SpectralProduct::normalisation() const noexcept { return static_cast<double>(body_->mx) * body_->my; }

void SpectralProduct::apply(const double* symbol, const double* x, double* y, Workers& workers) {
  Body& body = *body_;
  workers.each_row(body.ny, [&](int j, int thread) { body.transform_row(j, thread, x); });
  workers.run((body.spectrum_columns + block - 1) / block,
              [&](int part, int thread) { body.filter_columns(part * block, thread, symbol); });
  workers.each_row(body.ny, [&](int j, int thread) { body.transform_row_back(j, thread, y); });
}

}  // namespace patchgrip::contact
