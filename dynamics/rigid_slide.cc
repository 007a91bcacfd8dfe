#include <patchgrip/dynamics/rigid_slide.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

namespace patchgrip::dynamics {
namespace {

namespace odeint = boost::numeric::odeint;

// n, ln rho, t and place, both in units of the time and way that the start's push would take.
using Stretched = std::array<double, 8>;

// Of rho to its start: t has converged by then.
constexpr double at_rest = 1e-17;

class Motion {
 public:
  Motion(const SlideProblem& problem, const PlanarState& from) : problem_(problem), root_(problem.mass.cwiseSqrt()) {
    const Vector3 p = root_.cwiseProduct(from.twist);
    start_ = p.norm();
    const Vector3 n = p / start_;
    y_ = {n[0], n[1], n[2], 0, 0, 0, 0, 0};
    place_ = from.place;
    const double first = push(y_).norm();
    if (first > 0) time_ = start_ / first;
    way_ = time_ * start_;
  }

  Slide run(double tolerance, double longest) {
    auto stepper = odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<Stretched>());
    const auto rates = [this](const Stretched& y, Stretched& dy, double) { rate(y, dy); };
    double s = 0, ds = 1e-3;
    while (y_[3] > std::log(at_rest) && time_ * y_[4] < longest && ds > 0) {
      if (stepper.try_step(rates, y_, s, ds) == odeint::success) renormalise();
    }
    return result();
  }

 private:
  // rho = exp(y[3]) times the start's.
  double rho(const Stretched& y) const { return start_ * std::exp(y[3]); }
  double turn(const Stretched& y) const { return place_[2] + way_ * y[7]; }
  Vector3 twist(const Stretched& y) const { return Vector3(y[0], y[1], y[2]).cwiseQuotient(root_); }

  // G
  Vector3 push(const Stretched& y) {
    ++evaluations_;
    const Vector3 v = rho(y) * twist(y);
    const double c = std::cos(turn(y)), s = std::sin(turn(y));
    const friction::Wrench t = (*problem_.friction)({c * v[0] + s * v[1], c * v[1] - s * v[0], v[2]});
    const Vector3 f = problem_.load + Vector3(c * t.fx - s * t.fy, s * t.fx + c * t.fy, t.m);
    return f.cwiseQuotient(root_);
  }

  void rate(const Stretched& y, Stretched& dy) {
    const Vector3 n(y[0], y[1], y[2]), G = time_ / start_ * push(y), v = twist(y);
    const double along = n.dot(G), r = std::exp(y[3]);
    for (int i = 0; i < 3; ++i) {
      dy[static_cast<std::size_t>(i)] = G[i] - along * n[i];
      dy[static_cast<std::size_t>(i + 5)] = r * r * v[i];
    }
    dy[3] = along;
    dy[4] = r;
  }

  void renormalise() {
    const double size = std::sqrt(y_[0] * y_[0] + y_[1] * y_[1] + y_[2] * y_[2]);
    for (std::size_t i = 0; i < 3; ++i) y_[i] /= size;
  }

  Slide result() const {
    Slide r;
    r.stopped = y_[3] <= std::log(at_rest);
    r.time = time_ * y_[4];
    r.last_direction = twist(y_);
    r.state.place = place_ + way_ * Vector3(y_[5], y_[6], y_[7]);
    r.state.anchor = r.state.place;
    if (!r.stopped) r.state.twist = rho(y_) * r.last_direction;
    r.evaluations = evaluations_;
    return r;
  }

  const SlideProblem& problem_;
  Vector3 root_;  // M^(1/2)
  double start_;
  double time_ = 1, way_ = 1;
  Vector3 place_;
  Stretched y_;
  long evaluations_ = 0;
};

}  // namespace

void SlideSettings::check() const {
  contact::require_in("tolerance", tolerance, 1e-14, 1e-2);
  contact::require_positive("longest", longest);
}

Slide slide_to_rest(const SlideProblem& problem, const PlanarState& from, const SlideSettings& settings) {
  settings.check();
  contact::require_positive("size of the twist", from.twist.norm());
  Slide r = Motion(problem, from).run(settings.tolerance, settings.longest);
  const Slide rough = Motion(problem, from).run(100 * settings.tolerance, settings.longest);
  r.time_error = std::fabs(r.time - rough.time);
  r.place_error = (r.state.place - rough.state.place).cwiseAbs();
  r.evaluations += rough.evaluations;
  return r;
}

}  // namespace patchgrip::dynamics
