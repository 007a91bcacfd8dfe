#include <patchgrip/cli/grasp/grasp_answer.h>

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/progress.h>

namespace patchgrip::cli {
namespace {

using grasp::Contact;
using grasp::Grasp;
using grasp::GripAnswer;
using grasp::Vector3;
using grasp::Vector6;
using grasp::Verdict;

// With the friction of each contact times 1 + `share` of its relative error.
std::vector<Contact> with_friction(const std::vector<GraspContact>& contacts, double share) {
  std::vector<Contact> all;
  for (const GraspContact& c : contacts) {
    all.emplace_back(c.frame, c.cone.with_mu(c.cone.mu() * (1 + share * c.shape_error)));
  }
  return all;
}

std::vector<Contact> frictionless(const std::vector<GraspContact>& contacts) {
  std::vector<Contact> all;
  for (const GraspContact& c : contacts) all.emplace_back(c.frame, grasp::FrictionCone::frictionless());
  return all;
}

std::vector<double> limits_of(const GraspScene& scene) {
  std::vector<double> limits;
  for (const GraspContact& c : scene.contacts) limits.push_back(c.limit.value_or(0));
  return limits;
}

const GripAnswer& ask(Grasp& grasp, const GraspScene& scene, const Vector6& load) {
  switch (scene.question) {
    case GraspQuestion::least_total_grip:
      return grasp.least_total_grip(load);
    case GraspQuestion::least_quadratic_grip:
      return grasp.least_quadratic_grip(load, scene.epsilon, scene.length);
    case GraspQuestion::holds_within:
      return grasp.holds_within(load, limits_of(scene));
    case GraspQuestion::load_factor:
      return grasp.load_factor(scene.weight, load, limits_of(scene));
    case GraspQuestion::distance:
      return grasp.distance(load, scene.length);
    case GraspQuestion::force_closure:
    case GraspQuestion::form_closure:
      return grasp.force_closure();
    default:
      return grasp.least_grip(load);
  }
}

Vector6 load_of(const GraspScene& scene, std::size_t i) {
  return scene.question == GraspQuestion::load_factor ? scene.loads[i] : Vector6(scene.weight + scene.loads[i]);
}

// Of shares of the relative error of friction: none where there is none.
std::vector<double> shares_of(const GraspScene& scene) {
  const bool uncertain = std::ranges::any_of(scene.contacts, [](const GraspContact& c) { return c.shape_error > 0; });
  return uncertain ? std::vector<double>{0, -1, 1} : std::vector<double>{0};
}

template <class Answer>
void widen(Answer& answer, double lower, double upper, Verdict verdict) {
  answer.lower = std::min(answer.lower, lower);
  answer.upper = std::max(answer.upper, upper);
  if (verdict != answer.verdict) answer.verdict = Verdict::undecided;
}

// The proof of closure: the forces found, and one more newton of each finger, load nothing.
void squeeze(GripAnswer& answer) {
  for (grasp::ContactAnswer& c : answer.contacts) {
    c.normal_force += 1;
    c.state = grasp::ContactState::sticks;
    c.at_limit = false;
  }
}

// The answer, widened by those with less and with more friction where that is known no better.
class Questioned {
 public:
  explicit Questioned(const GraspScene& scene) : scene_(&scene) {
    const bool forms = scene.question == GraspQuestion::form_closure;
    grasps_.emplace_back(forms ? frictionless(scene.contacts) : contacts_of(scene.contacts));
    if (forms) return;
    for (const double share : shares_of(scene)) {
      if (share != 0) grasps_.emplace_back(with_friction(scene.contacts, share));
    }
  }

  GraspLoadAnswer answer(const Vector6& load) {
    const GripAnswer& own = ask(grasps_.front(), *scene_, load);
    GraspLoadAnswer result{load, own, own.lower, own.upper, own.verdict};
    for (std::size_t i = 1; i < grasps_.size(); ++i) {
      const GripAnswer& other = ask(grasps_[i], *scene_, load);
      widen(result, other.lower, other.upper, other.verdict);
    }
    if (asks_of_closure(scene_->question) && result.verdict == Verdict::holds) squeeze(result.grip);
    return result;
  }

 private:
  const GraspScene* scene_;
  std::vector<Grasp> grasps_;
};

GraspLoadAnswer growing_answer(const GraspScene& scene, const Vector6& load) {
  GraspLoadAnswer answer;
  for (const double share : shares_of(scene)) {
    std::vector<grasp::GrowingContact> contacts;
    for (const GraspContact& c : scene.contacts) {
      contacts.emplace_back([&c, share](double force) {
        InterruptGuard::check();
        const grasp::FrictionCone cone = c.grown ? c.grown(force) : c.cone;
        return Contact(c.frame, cone.with_mu(cone.mu() * (1 + share * c.shape_error)));
      });
    }
    grasp::GrowingGrip grip = least_growing_grip(contacts, load);
    if (share != 0) {
      widen(answer, grip.lower, grip.upper, grip.verdict);
      continue;
    }
    const bool held = grip.verdict == Verdict::holds;
    answer = {load, held ? std::move(grip.upper_answer) : std::move(grip.lower_answer), grip.lower, grip.upper,
              grip.verdict};
  }
  return answer;
}

// The worst load, with the bracket of the whole set.
GraspLoadAnswer worst_answer(const GraspScene& scene, int& simplices) {
  const bool factor = scene.question == GraspQuestion::worst_load_factor;
  grasp::LoadSet loads{scene.loads, scene.disturbance};
  if (!factor) {
    for (Vector6& w : loads.corners) w += scene.weight;
  }
  grasp::WorstLoadSettings settings = scene.worst;
  settings.check_interrupt = [] { InterruptGuard::check(); };
  const std::vector<double> limits = limits_of(scene);
  GraspLoadAnswer answer;
  for (const double share : shares_of(scene)) {
    const std::vector<Contact> contacts = with_friction(scene.contacts, share);
    const grasp::WorstLoad worst = factor ? worst_load_factor(contacts, scene.weight, loads, limits, settings)
                                          : worst_grip(contacts, loads, scene.measure, settings);
    if (share == 0) {
      answer = {worst.load, worst.answer, worst.lower, worst.upper, worst.verdict};
      simplices = worst.simplices;
    } else {
      widen(answer, worst.lower, worst.upper, worst.verdict);
    }
  }
  return answer;
}

// One member of a family after the other; loads that turn start from the solution before.
class Family {
 public:
  explicit Family(const GraspScene& scene)
      : scene_(&scene), load_(scene.weight + scene.loads.front()), shares_(shares_of(scene)) {
    for (const double share : shares_) grasps_.emplace_back(with_friction(scene.contacts, share));
    for (const GraspContact& c : scene.contacts) {
      centroid_ += c.frame.position / static_cast<double>(scene.contacts.size());
    }
  }

  FamilyMember member(double value) {
    InterruptGuard::check();
    FamilyMember member;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      const GripAnswer answer = answer_at(value, i);
      if (i == 0) {
        member = {value, answer.verdict, answer.value, answer.lower, answer.upper};
      } else {
        widen(member, answer.lower, answer.upper, answer.verdict);
      }
    }
    return member;
  }

 private:
  GripAnswer answer_at(double value, std::size_t which) {
    Grasp& own = grasps_[which];
    const GraspFamily& family = *scene_->family;
    if (family.parameter == GraspFamily::Parameter::turn) {
      const Eigen::AngleAxisd turn(value, family.axis);
      return own.next_least_grip(grasp::spatial(turn * load_.head<3>(), turn * load_.tail<3>()));
    }
    if (family.parameter == GraspFamily::Parameter::offset) {
      const Vector3 force = load_.head<3>(), arm = value * family.axis;
      return own.next_least_grip(grasp::spatial(force, load_.tail<3>() + arm.cross(force)));
    }
    std::vector<Contact> contacts;
    for (const GraspContact& c : scene_->contacts) {
      grasp::ContactFrame frame = c.frame;
      grasp::FrictionCone cone = c.cone;
      if (family.parameter == GraspFamily::Parameter::mu) {
        cone = cone.with_mu(value * (1 + shares_[which] * c.shape_error));
      } else {
        cone = cone.with_mu(cone.mu() * (1 + shares_[which] * c.shape_error));
        frame.position = centroid_ + value * (frame.position - centroid_);
      }
      contacts.emplace_back(frame, cone);
    }
    return Grasp(std::move(contacts)).least_grip(load_);
  }

  const GraspScene* scene_;
  Vector6 load_;
  std::vector<double> shares_;
  std::vector<Grasp> grasps_;
  Vector3 centroid_ = Vector3::Zero();
};

// Between a member that holds and one that does not.
double boundary_between(Family& family, double a, double b, Verdict verdict_a) {
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (a + b) / 2;
    if (middle == a || middle == b) break;
    (family.member(middle).verdict == verdict_a ? a : b) = middle;
  }
  return (a + b) / 2;
}

void answer_family(const GraspScene& scene, GraspAnswer& answer) {
  Family family(scene);
  const Sequence& values = scene.family->values;
  Progress progress("grasp", values.size(), Progress::wanted(Progress::no_output));
  for (std::size_t i = 0; i < values.size(); ++i) {
    InterruptGuard::check();
    answer.family.push_back(family.member(values[i]));
    progress.at(i);
  }
  for (std::size_t i = 0; i + 1 < answer.family.size(); ++i) {
    const FamilyMember &a = answer.family[i], &b = answer.family[i + 1];
    const bool decided = a.verdict != Verdict::undecided && b.verdict != Verdict::undecided;
    if (!decided || a.verdict == b.verdict) continue;
    InterruptGuard::check();
    answer.boundaries.push_back(boundary_between(family, a.value, b.value, a.verdict));
  }
}

}  // namespace

GraspAnswer answer_grasp(const GraspScene& scene) {
  GraspAnswer answer;
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    for (const std::string& warning : scene.contacts[i].warnings) {
      answer.warnings.push_back(fmt::format("contact {}: {}", i + 1, warning));
    }
  }
  if (scene.question == GraspQuestion::held_ball) {
    grasp::BallSettings settings = scene.ball;
    settings.check_interrupt = [] { InterruptGuard::check(); };
    for (const double share : shares_of(scene)) {
      const auto ball = held_ball(with_friction(scene.contacts, share), scene.measure, scene.length, settings);
      if (share == 0) {
        answer.ball = ball;
      } else {
        answer.ball->lower = std::min(answer.ball->lower, ball.lower);
        answer.ball->upper = std::max(answer.ball->upper, ball.upper);
      }
    }
    return answer;
  }
  if (asks_of_a_set(scene.question)) {
    answer.loads.push_back(worst_answer(scene, answer.simplices));
    return answer;
  }
  if (scene.question == GraspQuestion::internal_forces) {
    answer.internal = internal_forces(contacts_of(scene.contacts));
    return answer;
  }
  if (scene.family) answer_family(scene, answer);
  const std::size_t count = asks_of_no_load(scene.question) ? 1 : scene.loads.size();
  Questioned questioned(scene);
  Progress progress("grasp", count, Progress::wanted(Progress::no_output));
  for (std::size_t i = 0; i < count; ++i) {
    InterruptGuard::check();
    answer.loads.push_back(at(scene.load_places[i], [&] {
      const Vector6 load = load_of(scene, i);
      return scene.question == GraspQuestion::growing_grip ? growing_answer(scene, load) : questioned.answer(load);
    }));
    progress.at(i);
  }
  if (count > most_grasp_loads_listed) {
    answer.warnings.push_back(
        fmt::format("the first {} of {} loads are listed here; --table writes all", most_grasp_loads_listed, count));
  }
  return answer;
}

std::string_view unit_of(GraspQuestion question) {
  switch (question) {
    case GraspQuestion::least_quadratic_grip:
      return "N^2";
    case GraspQuestion::holds_within:
    case GraspQuestion::load_factor:
    case GraspQuestion::worst_load_factor:
    case GraspQuestion::held_ball:
      return "1";
    default:
      return "N";
  }
}

double pace_of(const GraspLoadAnswer& load, const GraspScene& scene) {
  if (load.verdict != Verdict::cannot_hold || scene.question == GraspQuestion::distance) return 1;
  const Vector6& W = load.grip.escape_twist;
  const double size = W.head<3>().norm() + W.tail<3>().norm() * scene.length;
  return size > 0 ? size : 1;
}

Table grasp_rows(const GraspAnswer& answer, const GraspScene& scene) {
  const auto known = [](double x) { return std::isfinite(x) ? x : not_known; };
  const auto verdict = [](Verdict v) { return v == Verdict::undecided ? not_known : v == Verdict::holds ? 1 : 0; };
  if (scene.family) {
    constexpr std::array<std::string_view, 4> names{"turn_rad", "offset_m", "mu", "spread"};
    Table table{{std::string(names[static_cast<std::size_t>(scene.family->parameter)]), "holds", "least_grip_N",
                 "lower_N", "upper_N"},
                {}};
    for (const FamilyMember& m : answer.family) {
      const double grip = m.verdict == Verdict::holds ? m.grip : not_known;
      table.rows.push_back({m.value, verdict(m.verdict), grip, m.lower, known(m.upper)});
    }
    return table;
  }
  Table table{
      {"force_x_N", "force_y_N", "force_z_N", "moment_x_Nm", "moment_y_Nm", "moment_z_Nm", "holds", "lower", "upper"},
      {}};
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    for (const char* component : {"normal_N", "friction_u_N", "friction_v_N", "friction_moment_Nm"}) {
      table.columns.push_back(fmt::format("contact_{}_{}", i + 1, component));
    }
  }
  for (const GraspLoadAnswer& load : answer.loads) {
    std::vector<double> row(load.load.begin(), load.load.end());
    row.insert(row.end(), {verdict(load.verdict), known(load.lower), known(load.upper)});
    const bool held = load.verdict == Verdict::holds;
    for (const grasp::ContactAnswer& c : load.grip.contacts) {
      for (const double x : {c.normal_force, c.friction[0], c.friction[1], c.friction[2]}) {
        row.push_back(held ? x : not_known);
      }
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace patchgrip::cli
