#include <patchgrip/cli/limit/load_answer.h>

#include <algorithm>
#include <array>

namespace patchgrip::cli::limit {
namespace {

using friction::BoundedWrench;
using friction::Gauge;
using friction::Hessian;
using friction::PatchView;
using friction::PressureMoments;
using friction::Twist;
using friction::Wrench;

constexpr double unit = 0x1p-53;
constexpr double infinity = std::numeric_limits<double>::infinity();

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) noexcept { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector scaled(const Vector& a, double s) noexcept { return {s * a[0], s * a[1], s * a[2]}; }

// Twists and wrenches about the centroid c of the pressure, spins and moments made speeds and forces by the radius of
// gyration.
struct Frame {
  double x, y, length;

  Vector wrench(const Wrench& t) const noexcept { return {t.fx, t.fy, (t.m - (x * t.fy - y * t.fx)) / length}; }

  Vector times(const Hessian& h, const Vector& u) const noexcept {
    const double w = u[2] / length;
    const Twist v{u[0] + w * y, u[1] - w * x, w};
    return wrench({h.xx * v.vx + h.xy * v.vy + h.xw * v.w, h.xy * v.vx + h.yy * v.vy + h.yw * v.w,
                   h.xw * v.vx + h.yw * v.vy + h.ww * v.w});
  }
};

// Two unit vectors across `t` and each other.
std::array<Vector, 2> plane_across(const Vector& t) noexcept {
  const Vector n = scaled(t, 1 / std::sqrt(dot(t, t)));
  Vector axis{};
  axis[static_cast<std::size_t>(
      std::min_element(n.begin(), n.end(), [](double a, double b) { return std::fabs(a) < std::fabs(b); }) -
      n.begin())] = 1;
  Vector first = cross(n, axis);
  first = scaled(first, 1 / std::sqrt(dot(first, first)));
  return {first, cross(n, first)};
}

// Length of the Newton step for the residual, twice, and of that for an error `noise` of it; in the plane t . u = 1,
// where D has its least value 1/g.
double distance_to_maximiser(const Frame& frame, const Hessian& h, const Vector& t, const Vector& residual,
                             double noise) noexcept {
  const auto [a, b] = plane_across(t);
  const Vector ha = frame.times(h, a);
  const Vector hb = frame.times(h, b);
  const double aa = dot(a, ha), ab = dot(a, hb), bb = dot(b, hb);
  const double ra = dot(a, residual), rb = dot(b, residual);
  const double mean = 0.5 * (aa + bb);
  const double apart = std::hypot(0.5 * (aa - bb), ab);
  const double determinant = aa * bb - ab * ab;
  const double least = determinant > 0 ? determinant / (mean + apart) : mean - apart;
  if (!(least > 0)) return infinity;
  return 2 * std::hypot(bb * ra - ab * rb, aa * rb - ab * ra) / determinant + noise / least;
}

}  // namespace

Slip slip_of(const Gauge& gauge, const Wrench& load, const PatchView& patch, const PressureMoments& moments,
             double shape_error) noexcept {
  const Twist& v = gauge.twist;
  const Frame frame{moments.x, moments.y, std::sqrt(moments.polar)};
  const double speed = std::hypot(v.vx - v.w * frame.y, v.vy + v.w * frame.x);  // of the centroid
  double moved = 8 * unit * (speed + frame.length * std::fabs(v.w));
  Hessian h;
  const bool kinked = gauge.status == friction::GaugeStatus::facet;
  if (!kinked && frame.length > 0 && patch.hessian(patch.patch, v, h)) {
    const BoundedWrench g = patch.gradient(patch.patch, v);
    const Vector t = scaled(frame.wrench(load), 1 / gauge.value);
    const Vector d = frame.wrench(g.value);
    const Vector residual{t[0] - d[0], t[1] - d[1], t[2] - d[2]};
    // A shape that is wider by delta bears a moment that is greater by delta, and takes its pole along.
    const double shape = 2 * shape_error * std::fabs(t[2]);
    moved += shape_error * speed;
    moved += distance_to_maximiser(frame, h, t, residual, g.force_error + g.moment_error / frame.length + shape);
  }
  const double spin_error = frame.length > 0 ? moved / frame.length : 0;
  const double spin = std::fabs(v.w);
  const friction::Pole pole{-v.vy / v.w, v.vx / v.w};
  // dM = (e_z x dv + (c - M) dw) / w about the centroid c, |c - M| = speed / |w|.
  const double pole_error = spin > spin_error ? (moved + speed / spin * spin_error) / (spin - spin_error) : infinity;
  const double arm = std::hypot(frame.x, frame.y);
  return {v, arm > 0 ? moved + arm * spin_error : moved, spin_error, pole, pole_error};
}

LoadAnswer answer_of(const Wrench& load, const Gauge& gauge, const Slip& slip, double area_radius,
                     const Capacity& capacity) noexcept {
  const double g = gauge.value;
  const double grown = capacity.shape_error < 1 ? capacity.shape_error / (1 - capacity.shape_error) : infinity;
  const double upper = gauge.upper * (1 + grown);
  const double lower = gauge.lower * (1 - grown);
  LoadAnswer answer{load, gauge, std::max(upper - g, g - lower), {infinity, 0}, {}, Verdict::undecided, slip};
  answer.stick_radius = {std::numeric_limits<double>::quiet_NaN(), 0};
  const double least = capacity.value * (1 - capacity.relative_error);
  const double most = capacity.value * (1 + capacity.relative_error);
  if (upper <= least) answer.verdict = Verdict::holds;
  if (lower > most) answer.verdict = Verdict::slips;
  if (!answer.loaded()) return answer;
  const double margin = capacity.value / g;
  answer.margin = {margin, std::max(most / lower - margin, margin - least / upper) + unit * margin};
  if (area_radius > 0) {
    const double radius = std::hypot(load.fx, load.fy, load.m / area_radius) / g;
    answer.stick_radius = {radius, radius * (answer.gauge_error / lower + 4 * unit)};
  }
  return answer;
}

}  // namespace patchgrip::cli::limit
