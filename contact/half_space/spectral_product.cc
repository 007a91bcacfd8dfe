#include <patchgrip/contact/half_space/spectral_product.h>
#include <patchgrip/contact/half_space/vector_clones.h>

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <mutex>
#include <numbers>
#include <stdexcept>

namespace patchgrip::contact {
namespace {

using Complex = std::complex<double>;

constexpr int block = 4;    // columns that are copied together: a line of the cache
constexpr int aligned = 4;  // complex numbers: rows and columns start on a line of the cache

std::mutex& planner() {
  static std::mutex lock;
  return lock;
}

struct Plan {
  template <class Make>
  explicit Plan(const Make& make) {
    const std::lock_guard guard(planner());
    plan = make();
    if (plan == nullptr) throw std::runtime_error("FFTW made no plan");
  }
  ~Plan() {
    const std::lock_guard guard(planner());
    fftw_destroy_plan(plan);
  }
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  fftw_plan plan;
};

fftw_complex* raw(Complex* z) { return reinterpret_cast<fftw_complex*>(z); }

std::size_t threads(Resources resources) { return static_cast<std::size_t>(resources.workers.count()); }

std::size_t round_up(int n, int unit) { return static_cast<std::size_t>((n + unit - 1) / unit * unit); }

// What is changed next often lies changed in the cache of another thread: asked for in time, to be changed.
template <class Number>
void fetch(Number* z, int count) {
  constexpr int on_a_line = static_cast<int>(PageMemory::alignment / sizeof(Number));
  const auto one = [z](int k) {
#if defined(__x86_64__)
    asm volatile("prefetchw %0" : : "m"(z[k]));  // __builtin_prefetch only reads for processors of any age
#else
    __builtin_prefetch(z + k, 1);
#endif
  };
  for (int k = 0; k < count - 1; k += on_a_line) one(k);
  one(count - 1);
}

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
