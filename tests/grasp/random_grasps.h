// Random grasps whose verdict is known by construction.
//
//     inside        admissible forces are drawn, the load is what they carry
//     near_inside   a twist and forces on the limit surface of its slip, less delta: just held
//     near_outside  the same, the load pushed out by delta: W is a certificate that it cannot be held
//     outside       pushed out by as much as the load
//     deficient     rank below 6: two points, points on a line, frictionless on a plane or round an axis; some loads off range
//     wide_mu       mu from 1e-6 to 10
//     duplicates    half of the contacts twice
//     not_closed    next to a cone that is not closed: least grip (1 + delta^2) / delta sqrt 1.25
//     unknown       any load
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/grasp/grasp.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::grasp {

// Sizes of a contact before it is one: tests change units and models.
struct DrawnContact {
  enum class Model { point, elliptic, linear, hertz, frictionless, rectangle };
  static constexpr int models = 6;

  Model model = Model::point;
  Vector3 r = {0, 0, 0}, n = {0, 0, 1}, u = {1, 0, 0};
  double mu = 0, e = 0, a = 0, side_u = 0, side_v = 0;

  FrictionCone cone() const {
    switch (model) {
      case Model::point:
        return FrictionCone::point(mu);
      case Model::elliptic:
        return FrictionCone::soft_elliptic(mu, e);
      case Model::linear:
        return FrictionCone::soft_linear(mu, e);
      case Model::hertz:
        return FrictionCone::patch(mu, friction::HertzDisc::of_radius(a));
      case Model::rectangle:
        return FrictionCone::patch(mu, friction::Rectangle::of_sides(side_u, side_v));
      default:
        return FrictionCone::frictionless();
    }
  }

  Contact contact() const { return {{r, n, u}, cone()}; }

  // D and a friction on the limit surface of unit mu F, in the contact's frame.
  double dissipation(const Vector3& v) const {
    if (model == Model::frictionless) return 0;
    const double speed = std::hypot(v[0], v[1]);
    if (model == Model::point) return speed;
    if (model == Model::elliptic) return std::hypot(speed, e * v[2]);
    if (model == Model::linear) return std::max(speed, e * std::fabs(v[2]));
    return cone().surface().patch().dissipation({v[0], v[1], v[2]});
  }
  Vector3 gradient(const Vector3& v) const {
    if (model == Model::frictionless) return Vector3::Zero();
    const double speed = std::hypot(v[0], v[1]);
    const Vector3 force(v[0], v[1], 0);
    if (model == Model::point || (model == Model::linear && speed > e * std::fabs(v[2]))) return force / speed;
    if (model == Model::linear) return {0, 0, std::copysign(e, v[2])};
    if (model == Model::elliptic) return Vector3(v[0], v[1], e * e * v[2]) / dissipation(v);
    const friction::Wrench g = cone().surface().patch().gradient({v[0], v[1], v[2]});
    return {g.fx, g.fy, g.m};
  }

  DrawnContact in_units(double lengths) const {
    DrawnContact c = *this;
    c.r *= lengths;
    for (double* x : {&c.e, &c.a, &c.side_u, &c.side_v}) *x *= lengths;
    return c;
  }
};

struct DrawnGrasp {
  std::vector<DrawnContact> contacts;
  Vector6 load = Vector6::Zero();
  double delta = 0;
  double known = 0;  // a grip that holds; of not_closed the least one
  enum class Truth { held, not_held, value, unknown } truth = Truth::unknown;

  std::vector<Contact> made() const {
    std::vector<Contact> all;
    for (const DrawnContact& c : contacts) all.push_back(c.contact());
    return all;
  }
};

class GraspDraws {
 public:
  enum class Class { inside, near_inside, near_outside, outside, deficient, wide_mu, duplicates, not_closed, unknown };
  static constexpr std::array names{"inside",  "near_inside", "near_outside", "outside", "deficient",
                                    "wide_mu", "duplicates",  "not_closed",   "unknown"};

  explicit GraspDraws(unsigned seed) : engine_(seed) {}

  // In place of drawn ones where they are not 0: how near the boundary (or the cone that is not closed), and wide_mu.
  double fixed_delta = 0, fixed_mu = 0;

  DrawnGrasp draw(Class kind);
  DrawnContact contact();
  Vector3 vector() { return {normal(), normal(), normal()}; }
  Vector6 load() { return spatial(vector(), 0.02 * vector()); }
  double uniform(double lo, double hi) { return testing::uniform(engine_, lo, hi); }
  double log_uniform(double lo, double hi) { return testing::log_uniform(engine_, lo, hi); }
  bool chance(double p) { return uniform(0, 1) < p; }

 private:
  double normal() { return std::normal_distribution<double>()(engine_); }
  Vector3 on_surface(const DrawnContact& c, double F);
  DrawnGrasp held(Class kind, int count);
  DrawnGrasp near_boundary(Class kind, int count);
  DrawnGrasp deficient();
  DrawnGrasp not_closed();

  std::mt19937_64 engine_;
};

inline DrawnContact GraspDraws::contact() {
  DrawnContact c;
  c.model = static_cast<DrawnContact::Model>(static_cast<int>(uniform(0, 1) * DrawnContact::models));
  const Vector3 direction = vector().normalized();
  c.r = 0.05 * uniform(0.8, 1.2) * direction;
  c.n = (direction + 0.15 * vector()).normalized();
  c.u = c.n.cross(vector()).normalized();
  c.mu = c.model == DrawnContact::Model::frictionless ? 0 : uniform(0.2, 0.9);
  c.e = uniform(0.001, 0.006);
  c.a = uniform(0.002, 0.01);
  c.side_u = uniform(0.004, 0.02);
  c.side_v = uniform(0.004, 0.02);
  return c;
}

inline Vector3 GraspDraws::on_surface(const DrawnContact& c, double F) {
  Vector3 v = vector();
  v[2] *= 200;
  return -c.mu * F * c.gradient(v);
}

inline DrawnGrasp GraspDraws::held(Class kind, int count) {
  DrawnGrasp g;
  for (int i = 0; i < count; ++i) {
    DrawnContact c = contact();
    if (kind == Class::wide_mu && c.mu > 0) c.mu = fixed_mu > 0 ? fixed_mu : log_uniform(1e-6, 10);
    if (kind == Class::duplicates && i > 0 && chance(0.5)) {
      c = g.contacts[static_cast<std::size_t>(uniform(0, 1) * i)];
    }
    const double F = chance(0.2) ? 0 : uniform(0.1, 1);
    const Vector3 t = F > 0 ? Vector3(uniform(0, 1) * on_surface(c, F)) : Vector3::Zero();
    g.contacts.push_back(c);
    g.load -= c.contact().wrench(F, t);
    g.known = std::max(g.known, F);
  }
  g.truth = DrawnGrasp::Truth::held;
  return g;
}

inline DrawnGrasp GraspDraws::near_boundary(Class kind, int count) {
  DrawnGrasp g;
  const Vector3 omega = vector(), v = 0.05 * vector();
  const Vector6 W = spatial(v, omega);
  g.delta = kind == Class::outside ? 1 : fixed_delta > 0 ? fixed_delta : std::pow(10., -uniform(3, 10));
  bool active = false;
  for (int i = 0; i < count; ++i) {
    DrawnContact c = contact();
    const Vector3 w = v + omega.cross(c.r);
    if (c.n.dot(w) > 0) c.n = -c.n;
    c.u = c.n.cross(vector()).normalized();
    const Vector3 slide(c.u.dot(w), c.n.cross(c.u).dot(w), c.n.dot(omega));
    const double D = c.dissipation(slide);
    bool on = chance(0.6) && c.model != DrawnContact::Model::frictionless;
    if (D > 0 && c.mu > 0) {
      const double mu = -c.n.dot(w) / D;  // rho = 0
      if (mu > 20 || mu < 0.01) on = false;
      c.mu = on ? mu : std::min(c.mu, 0.7 * mu);
    }
    g.contacts.push_back(c);
    if (kind == Class::outside) {
      const double F = uniform(0, 1);
      g.load -= c.contact().wrench(F, uniform(0, 1) * on_surface(c, F));
    } else if (on) {
      const double F = uniform(0.1, 1);
      const Vector3 t = -c.mu * F * c.gradient(slide) * (kind == Class::near_inside ? 1 - g.delta : 1);
      g.load -= c.contact().wrench(F, t);
      g.known = std::max(g.known, F);
      active = true;
    }
  }
  if (!active && kind != Class::outside) {
    g.load = load();
    return g;
  }
  if (kind == Class::near_inside) {
    g.truth = DrawnGrasp::Truth::held;
    return g;
  }
  g.truth = DrawnGrasp::Truth::not_held;
  const Vector6 out = spatial(v, 0.0025 * omega) / W.dot(spatial(v, 0.0025 * omega));
  const double size = std::sqrt(g.load.head<3>().squaredNorm() + g.load.tail<3>().squaredNorm() / 0.0025);
  const double pace = std::sqrt(v.squaredNorm() + 0.0025 * omega.squaredNorm());
  const double behind = kind == Class::outside ? std::max(0., -g.load.dot(W)) : 0;
  g.load += out * (behind + (kind == Class::outside ? uniform(0.05, 1) : g.delta) * size * pace);
  return g;
}

inline DrawnGrasp GraspDraws::deficient() {
  DrawnGrasp g;
  const Vector3 a = vector().normalized(), b = a.cross(vector()).normalized(), c = a.cross(b);
  const int type = static_cast<int>(uniform(0, 4));
  const int count = type == 0 ? 2 : 3 + static_cast<int>(uniform(0, 4));
  for (int i = 0; i < count; ++i) {
    DrawnContact k = contact();
    k.model = type < 2 ? DrawnContact::Model::point : DrawnContact::Model::frictionless;
    k.mu = type < 2 ? uniform(0.2, 0.9) : 0;
    if (type == 0) {
      k.r = (i > 0 ? -0.03 : 0.03) * a + 0.01 * b;
      k.n = i > 0 ? Vector3(-a) : a;
    } else if (type == 1) {
      k.r = uniform(-0.05, 0.05) * a;
      k.n = b;
    } else if (type == 2) {
      k.r = 0.05 * (uniform(-1, 1) * b + uniform(-1, 1) * c);
      k.n = -a;
    } else {
      const double angle = uniform(0, 6.28);
      k.n = std::cos(angle) * b + std::sin(angle) * c;
      k.r = 0.05 * k.n + 0.01 * (uniform(0, 1) * b + uniform(0, 1) * c);
    }
    k.u = k.n.cross(vector()).normalized();
    g.contacts.push_back(k);
    const double F = uniform(0.1, 1);
    g.load -= k.contact().wrench(F, uniform(0, 1) * on_surface(k, F));
    g.known = std::max(g.known, F);
  }
  g.truth = DrawnGrasp::Truth::held;
  if (chance(0.4)) {
    g.delta = std::pow(10., -uniform(0, 9));
    const double size = g.delta * g.load.head<3>().norm();
    // About the line, along the plane, along the axis.
    const Vector3 none = Vector3::Zero();
    g.load += size * (type == 0   ? spatial(none, 0.05 * a)
                      : type == 1 ? spatial(none, 0.05 * a)
                      : type == 2 ? spatial(b, none)
                                  : spatial(a, none));
    g.truth = DrawnGrasp::Truth::not_held;
  }
  return g;
}

inline DrawnGrasp GraspDraws::not_closed() {
  DrawnGrasp g;
  const Matrix3 Q = Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized().toRotationMatrix();
  // Beside the origin moments are rounded.
  const Vector3 shift = chance(0.5) ? Vector3(0.02 * vector()) : Vector3(Vector3::Zero());
  g.delta = fixed_delta > 0 ? fixed_delta : std::pow(10., -uniform(1, 6));
  DrawnContact a = contact();
  a.model = DrawnContact::Model::point;
  a.mu = 0.5;
  a.r = shift;
  a.n = Q * Vector3(0, 0, -1);
  a.u = Q * Vector3(1, 0, 0);
  DrawnContact b = a;
  b.model = DrawnContact::Model::frictionless;
  b.mu = 0;
  b.n = Q * Vector3(.5, 0, 1).normalized();
  b.u = Q * Vector3(0, 1, 0);
  g.contacts = {a, b};
  const Vector3 f = Q * Vector3(g.delta, -1, 0);
  g.load = spatial(f, shift.cross(f));
  g.known = (1 + g.delta * g.delta) / g.delta * std::sqrt(1.25);
  g.truth = DrawnGrasp::Truth::value;
  return g;
}

inline DrawnGrasp GraspDraws::draw(Class kind) {
  const int count = 2 + static_cast<int>(chance(0.3) ? uniform(0, 5) : uniform(0, 29));
  switch (kind) {
    case Class::inside:
    case Class::wide_mu:
    case Class::duplicates:
      return held(kind, count);
    case Class::near_inside:
    case Class::near_outside:
    case Class::outside:
      return near_boundary(kind, count);
    case Class::deficient:
      return deficient();
    case Class::not_closed:
      return not_closed();
    default: {
      DrawnGrasp g;
      for (int i = 0; i < count; ++i) g.contacts.push_back(contact());
      g.load = load();
      return g;
    }
  }
}

// Grasps that hold a load well, a tenth of `count` under the slow presets.
inline std::vector<DrawnGrasp> held_grasps(unsigned seed, int count) {
  GraspDraws draws(seed);
  std::vector<DrawnGrasp> all;
  for (int i = 0; i < testing::cases(count); ++i) {
    DrawnGrasp g = draws.draw(GraspDraws::Class::inside);
    if (g.load.norm() > 0) all.push_back(std::move(g));
  }
  return all;
}

}  // namespace patchgrip::grasp
