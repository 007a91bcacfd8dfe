#include <patchgrip/friction/polygon.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <patchgrip/friction/kernels/edge_sum.h>
#include <patchgrip/friction/kernels/far_field.h>
#include <patchgrip/friction/polygon_rings.h>

namespace patchgrip::friction {
namespace {

using kernels::Boundary;
using kernels::EdgeSum;
using kernels::Vertex;
using kernels::Want;

// Area, centroid and polar moment lose digits where rings nearly cancel; far poles see all of it. Twice the precision
// is cheap.
using Wide = boost::multiprecision::cpp_bin_float_quad;

struct AreaMoments {
  Wide area{0}, x{0}, y{0}, polar{0};
};

AreaMoments area_moments(const std::vector<std::vector<Vertex>>& rings) {
  const Wide x0 = rings[0][0].x;
  const Wide y0 = rings[0][0].y;
  Wide area = 0, mx = 0, my = 0, second = 0;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex& p = ring[i];
      const Vertex& q = ring[(i + 1) % ring.size()];
      const Wide px = Wide(p.x) - x0, py = Wide(p.y) - y0, qx = Wide(q.x) - x0, qy = Wide(q.y) - y0;
      const Wide cross = px * qy - qx * py;
      area += cross / 2;
      mx += cross * (px + qx) / 6;
      my += cross * (py + qy) / 6;
      second += cross * (px * px + px * qx + qx * qx + py * py + py * qy + qy * qy) / 12;
    }
  }
  mx /= area;
  my /= area;
  return {area, x0 + mx, y0 + my, second / area - mx * mx - my * my};
}

// The long edges of a needle are nearly along their own vertices: in 64 bits a weight would lose them by its aspect.
std::vector<kernels::BoundarySample> boundary_samples(const std::vector<std::vector<Vertex>>& rings, const Vertex& c,
                                                      const Wide& area) {
  // Exact for the far field's degree: 12 points integrate degree 23.
  using Gauss = boost::math::quadrature::gauss<long double, 12>;
  std::vector<kernels::BoundarySample> samples;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex& p = ring[i];
      const Vertex& q = ring[(i + 1) % ring.size()];
      const long double px = static_cast<long double>(p.x) - c.x, py = static_cast<long double>(p.y) - c.y;
      const long double ex = static_cast<long double>(q.x) - p.x, ey = static_cast<long double>(q.y) - p.y;
      const Wide cross = (Wide(p.x) - c.x) * (Wide(q.y) - p.y) - (Wide(p.y) - c.y) * (Wide(q.x) - p.x);
      const auto share = static_cast<long double>(cross / area);  // h times the length of the edge, over the area
      for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
        for (const int side : {-1, 1}) {
          const long double t = (1 + side * Gauss::abscissa()[k]) / 2;
          samples.push_back({px + t * ex, py + t * ey, share * Gauss::weights()[k] / 2});
        }
      }
    }
  }
  return samples;
}

}  // namespace

struct Polygon::Data {
  Boundary<double> boundary;
  Boundary<long double> fine_boundary;
  Boundary<Wide> wide_boundary;
  double area;
  long double fine_area;
  Wide wide_area;
  Vertex centroid;  // rounded
  double polar;
  double radius;        // of the farthest vertex about the centroid
  double double_reach;  // poles nearer than this to the centroid: double precision is enough
  kernels::FarField far;

  Twist at_centroid(const Twist& v) const noexcept {
    return {std::fma(-v.w, centroid.y, v.vx), std::fma(v.w, centroid.x, v.vy), v.w};
  }

  BoundedWrench at_origin(BoundedWrench g) const noexcept {
    constexpr double unit = 0x1p-53;
    const double arm = std::fabs(centroid.x) + std::fabs(centroid.y);
    const double moment = centroid.x * g.value.fy - centroid.y * g.value.fx;
    g.value.m += moment;
    g.moment_error +=
        arm * (g.force_error + 2 * unit * std::hypot(g.value.fx, g.value.fy)) + unit * std::fabs(g.value.m);
    return g;
  }

  template <class Real, Want want>
  EdgeSum<Real> sum(const Twist& v) const {
    const Real X = -Real(v.vy) / Real(v.w);
    const Real Y = Real(v.vx) / Real(v.w);
    if constexpr (std::is_same_v<Real, double>) {
      return kernels::edge_sum<want>(boundary, X, Y);
    } else if constexpr (std::is_same_v<Real, long double>) {
      return kernels::edge_sum<want>(fine_boundary, X, Y);
    } else {
      return kernels::edge_sum<want>(wide_boundary, X, Y);
    }
  }

  // grad D about the centroid from A S and A grad S.
  template <class Real>
  Wrench wrench(const EdgeSum<Real>& sum, const Twist& v, Real A) const noexcept {
    const Real sense = v.w < 0 ? -1 : 1;
    // The pole seen from the centroid, in Real: rounded to double it would spoil T by r units.
    const Real X = -Real(v.vy) / Real(v.w) - centroid.x;
    const Real Y = Real(v.vx) / Real(v.w) - centroid.y;
    const Real T = sum.S - X * sum.gx - Y * sum.gy;
    return {static_cast<double>(sense * sum.gy / A), static_cast<double>(-sense * sum.gx / A),
            static_cast<double>(sense * T / A)};
  }

  template <class Real>
  BoundedWrench bounded_wrench(const EdgeSum<Real>& sum, const Twist& v, const Twist& c, Real A) const noexcept {
    constexpr double unit = 0x1p-53;
    const double fine_unit = static_cast<double>(std::numeric_limits<Real>::epsilon() / 2);
    BoundedWrench g{wrench(sum, v, A)};
    const double force = std::hypot(g.value.fx, g.value.fy);
    const double r = std::hypot(c.vx, c.vy) / std::fabs(c.w);
    const double gradient_terms = static_cast<double>(sum.gradient_terms / A);
    const double S_terms = static_cast<double>(sum.S_terms / A);
    // The pole M = (-vy, vx) / w is rounded, too: |Hess S| <= 2 / a_K, the value of a uniform disc of this area at its
    // centre.
    const double pole = fine_unit * std::hypot(v.vx, v.vy) / std::fabs(v.w);
    const double turn = 2 * pole * std::sqrt(std::numbers::pi / area);
    g.force_error = fine_unit * 5 * gradient_terms + turn + 2 * unit * force;
    g.moment_error =
        fine_unit * (4.0 / 9 * S_terms + 3 * static_cast<double>(sum.S / A) + r * (4 * gradient_terms + 4 * force)) +
        r * turn + 2 * unit * std::fabs(g.value.m);
    return g;
  }

  // The moment about the centroid is positive, but on the axis of a slender patch small of second order: there even 64
  // bits do not last, and twice as many are taken.
  bool cancels(const EdgeSum<long double>& sum, const Wrench& g) const noexcept {
    return std::fabs(g.m) < 3e-5 * static_cast<double>(sum.S / fine_area);
  }

  enum class Way { at_rest, near, middle, far };

  Way way(const Twist& c) const noexcept {
    const double V = std::hypot(c.vx, c.vy);
    if (V == 0 && c.w == 0) return Way::at_rest;
    if (far.reaches(V, c.w)) return Way::far;
    return V < double_reach * std::fabs(c.w) ? Way::near : Way::middle;
  }
};

Polygon Polygon::uniform(const std::vector<Point>& outer, const std::vector<std::vector<Point>>& holes) {
  const auto rings = oriented_rings(outer, holes);
  const AreaMoments m = area_moments(rings);
  auto data = std::make_shared<Data>();
  data->boundary = kernels::make_boundary<double>(rings);
  data->fine_boundary = kernels::make_boundary<long double>(rings);
  data->wide_boundary = kernels::make_boundary<Wide>(rings);
  data->fine_area = static_cast<long double>(m.area);
  data->wide_area = m.area;
  data->area = static_cast<double>(m.area);
  data->centroid = {static_cast<double>(m.x), static_cast<double>(m.y)};
  data->polar = static_cast<double>(m.polar);
  double perimeter = 0;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex& p = ring[i];
      const Vertex& q = ring[(i + 1) % ring.size()];
      perimeter += std::hypot(q.x - p.x, q.y - p.y);
      data->radius = std::max(data->radius, std::hypot(p.x - data->centroid.x, p.y - data->centroid.y));
    }
  }
  if (!(data->area > 0) || !std::isfinite(data->area) || !(data->polar > 0) || !std::isfinite(data->polar)) {
    throw std::invalid_argument("vertices span " + std::to_string(data->radius) +
                                " m: the area and its second moment must be representable");
  }
  // The terms of the edge sums exceed their result by about `condition`, those of the moment by (r / radius)^3 more.
  const double condition = perimeter * data->radius / data->area;
  data->double_reach = condition < 32 ? data->radius * std::cbrt(66 / condition) : 0;
  data->far = kernels::FarField(boundary_samples(rings, data->centroid, m.area), data->radius,
                                static_cast<long double>(m.x - data->centroid.x),
                                static_cast<long double>(m.y - data->centroid.y));
  return Polygon(std::move(data));
}

double Polygon::dissipation(const Twist& twist) const noexcept {
  const Twist v = finite_or_nan(twist);
  const Twist c = data_->at_centroid(v);
  switch (data_->way(c)) {
    case Data::Way::at_rest:
      return 0;
    case Data::Way::far:
      return data_->far.dissipation(c);
    case Data::Way::middle:
      return std::fabs(v.w) * static_cast<double>(data_->sum<long double, Want::gradient>(v).S / data_->fine_area);
    case Data::Way::near:
      break;
  }
  return std::fabs(v.w) * data_->sum<double, Want::gradient>(v).S / data_->area;
}

Wrench Polygon::gradient(const Twist& twist) const noexcept {
  const Twist v = finite_or_nan(twist);
  const Data& data = *data_;
  const Twist c = data.at_centroid(v);
  BoundedWrench g;
  switch (data.way(c)) {
    case Data::Way::at_rest:
      return {};
    case Data::Way::far:
      g.value = data.far.gradient(c);
      break;
    case Data::Way::middle: {
      const auto fine = data.sum<long double, Want::gradient>(v);
      g.value = data.wrench(fine, v, data.fine_area);
      if (data.cancels(fine, g.value)) g.value = data.wrench(data.sum<Wide, Want::gradient>(v), v, data.wide_area);
      break;
    }
    case Data::Way::near:
      g.value = data.wrench(data.sum<double, Want::gradient>(v), v, data.area);
      break;
  }
  return data.at_origin(g).value;
}

BoundedWrench Polygon::bounded_gradient(const Twist& twist) const noexcept {
  const Twist v = finite_or_nan(twist);
  const Data& data = *data_;
  const Twist c = data.at_centroid(v);
  switch (data.way(c)) {
    case Data::Way::at_rest:
      return {};
    case Data::Way::far:
      return data.at_origin(data.far.bounded_gradient(c));
    case Data::Way::middle: {
      const auto fine = data.sum<long double, Want::bound>(v);
      const BoundedWrench g = data.bounded_wrench(fine, v, c, data.fine_area);
      if (!data.cancels(fine, g.value)) return data.at_origin(g);
      return data.at_origin(data.bounded_wrench(data.sum<Wide, Want::bound>(v), v, c, data.wide_area));
    }
    case Data::Way::near:
      break;
  }
  return data.at_origin(data.bounded_wrench(data.sum<double, Want::bound>(v), v, c, data.area));
}

Hessian Polygon::hessian(const Twist& twist) const {
  const Twist v = finite_or_nan(twist);
  const Data& data = *data_;
  const Twist c = data.at_centroid(v);
  switch (data.way(c)) {
    case Data::Way::at_rest:
      throw std::domain_error("twist = 0 is not allowed: the Hessian of D exists only in motion");
    case Data::Way::far: {
      const Hessian h = data.far.hessian(c);
      // u = A v with A = [1 0 -y; 0 1 x; 0 0 1] at the centroid (x, y): A^T H A.
      const double x = data.centroid.x, y = data.centroid.y;
      const double xw = h.xw - y * h.xx + x * h.xy;
      const double yw = h.yw - y * h.xy + x * h.yy;
      return {h.xx, h.xy, xw, h.yy, yw, h.ww - y * (h.xw + xw) + x * (h.yw + yw)};
    }
    case Data::Way::near:
    case Data::Way::middle:
      break;
  }
  // H = B Hess S B^T / |w|, B = [0 1; -1 0; -X -Y]; the last rows cancel beyond the patch, so always in extended
  // precision.
  const auto s = data.sum<long double, Want::hessian>(v);
  const long double k = 1 / (data.fine_area * std::fabs(static_cast<long double>(v.w)));
  const long double X = -static_cast<long double>(v.vy) / v.w;
  const long double Y = static_cast<long double>(v.vx) / v.w;
  const long double zx = X * s.xx + Y * s.xy;
  const long double zy = X * s.xy + Y * s.yy;
  const auto number = [k](long double a) { return static_cast<double>(k * a); };
  return {number(s.yy), number(-s.xy), number(-zy), number(s.xx), number(zx), number(X * zx + Y * zy)};
}

PressureMoments Polygon::moments() const noexcept { return {data_->centroid.x, data_->centroid.y, data_->polar}; }
double Polygon::area_radius() const noexcept { return std::sqrt(data_->area / std::numbers::pi); }
std::size_t Polygon::edges() const noexcept { return data_->boundary.vertices.size(); }
const Boundary<double>& Polygon::boundary() const noexcept { return data_->boundary; }

}  // namespace patchgrip::friction
