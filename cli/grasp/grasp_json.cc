#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include <patchgrip/cli/grasp/grasp_answer.h>
#include <patchgrip/cli/result_json.h>

namespace patchgrip::cli {
namespace {

using grasp::ContactAnswer;
using grasp::ContactState;
using grasp::Vector3;
using grasp::Vector6;
using grasp::Verdict;
using nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> verdicts{"holds", "cannot_hold", "undecided"};
constexpr std::array<std::string_view, 3> states{"opens", "sticks", "slips"};

template <class V>
ordered_json list(const V& v) {
  auto numbers = ordered_json::array();
  for (const double x : v) numbers.push_back(x == 0 ? 0.0 : x);
  return numbers;
}

ordered_json entry(double value, double error, std::string_view unit) {
  return {{"value", value}, {"error", error}, {"unit", unit}};
}

// The bracket, as a value with its error where it has two ends.
ordered_json to_value(const GraspLoadAnswer& load, const GraspScene& scene) {
  const std::string name(grasp_questions[static_cast<std::size_t>(scene.question)]);
  const std::string_view unit = unit_of(scene.question);
  ordered_json results = ordered_json::object();
  if (std::isfinite(load.lower) && std::isfinite(load.upper)) {
    const double value = std::clamp(load.grip.value, load.lower, load.upper);
    results[name] = entry(value, std::max(load.upper - value, value - load.lower), unit);
  } else if (std::isfinite(load.lower)) {
    results[name + "_at_least"] = entry(load.lower, 0, unit);
  } else if (std::isfinite(load.upper)) {
    results[name + "_at_most"] = entry(load.upper, 0, unit);
  }
  return results;
}

// How the value changes with mu of the contact, where that follows from the answer.
bool has_friction_slope(GraspQuestion question) {
  return question == GraspQuestion::least_grip || question == GraspQuestion::least_total_grip ||
         question == GraspQuestion::load_factor || asks_of_a_set(question);
}

bool is_factor(GraspQuestion question) {
  return question == GraspQuestion::load_factor || question == GraspQuestion::worst_load_factor;
}

// `pace` is what the twist is divided by.
ordered_json to_contact(const ContactAnswer& c, std::size_t number, const GraspScene& scene, bool held, double pace) {
  ordered_json json;
  json["contact"] = number;
  const bool closes = asks_of_closure(scene.question);
  if (held) {
    json["state"] = states[static_cast<std::size_t>(c.state)];
    json["normal_force"] = {{"value", c.normal_force}, {"unit", "N"}};
    json["friction"] = {{"value", list(c.friction.head<2>())}, {"unit", "N"}};
    json["friction_moment"] = {{"value", c.friction[2]}, {"unit", "N m"}};
    if (c.at_limit) json["at_limit"] = true;
  }
  if (closes && held) return json;
  json["resistance"] = c.resistance / pace;
  const bool slides = c.sliding.vx != 0 || c.sliding.vy != 0 || c.sliding.w != 0;
  if (slides && (c.state == ContactState::slips || !held)) {
    json["sliding"] = list(std::array{c.sliding.vx / pace, c.sliding.vy / pace, c.sliding.w / pace});
    if (c.sliding.w != 0) {
      const friction::Pole pole{-c.sliding.vy / c.sliding.w, c.sliding.vx / c.sliding.w};
      if (std::isfinite(pole.x) && std::isfinite(pole.y)) {
        json["pole"] = {{"value", list(std::array{pole.x, pole.y})}, {"unit", "m"}};
      }
    }
  }
  if (held && has_friction_slope(scene.question)) {
    const double sign = is_factor(scene.question) ? 1 : -1;
    json["slope_of_value_with_mu"] = sign * c.normal_force * c.dissipation;
  }
  return json;
}

ordered_json to_load(const GraspLoadAnswer& load, const GraspScene& scene) {
  ordered_json json;
  if (!asks_of_closure(scene.question)) {
    json["load"] = {{"force", {{"value", list(load.load.head<3>())}, {"unit", "N"}}},
                    {"moment", {{"value", list(load.load.tail<3>())}, {"unit", "N m"}}}};
  }
  json["verdict"] = verdicts[static_cast<std::size_t>(load.verdict)];
  if (!asks_of_closure(scene.question)) json["results"] = to_value(load, scene);
  const bool held = load.verdict == Verdict::holds;
  Vector6 W = load.grip.escape_twist;
  const double pace = pace_of(load, scene);
  W /= pace;
  if (!W.isZero(0) && !(asks_of_closure(scene.question) && held)) {
    json["escape_twist"] = {{"velocity", list(W.head<3>())}, {"turn_rate", list(W.tail<3>())}};
    const Vector6 w = (Vector6() << load.load.head<3>(), load.load.tail<3>() / scene.length).finished();
    const Vector6 V = (Vector6() << W.head<3>(), W.tail<3>() * scene.length).finished();
    const double power = std::fabs(w.dot(V));
    if (power > 0) json["condition"] = w.norm() * V.norm() / power;
  }
  json["contacts"] = ordered_json::array();
  for (std::size_t i = 0; i < load.grip.contacts.size(); ++i) {
    json["contacts"].push_back(to_contact(load.grip.contacts[i], i + 1, scene, held, pace));
  }
  json["balance_residual"] = load.grip.balance_residual;
  json["iterations"] = load.grip.effort.iterations + load.grip.effort.newton_steps;
  return json;
}

ordered_json to_ball(const grasp::HeldBall& ball, const GraspScene& scene) {
  ordered_json json;
  json["held_ball"] = entry((ball.lower + ball.upper) / 2, (ball.upper - ball.lower) / 2, "1");
  json["lower"] = ball.lower;
  json["upper"] = ball.upper;
  json["measure"] = scene.measure == grasp::GripMeasure::total_force ? "total_force" : "largest_force";
  json["weakest_load"] = {{"force", list(ball.load.head<3>())}, {"moment", list(ball.load.tail<3>())}};
  json["normal"] = {{"velocity", list(ball.twist.head<3>())}, {"turn_rate", list(ball.twist.tail<3>())}};
  json["simplices"] = ball.simplices;
  return json;
}

ordered_json to_internal(const grasp::InternalForces& internal) {
  ordered_json json;
  json["rank"] = internal.rank;
  json["components"] = internal.components;
  json["dimension"] = internal.components - internal.rank;
  json["basis"] = ordered_json::array();
  for (const auto& forces : internal.basis) {
    auto one = ordered_json::array();
    for (const grasp::ContactForce& f : forces) {
      one.push_back({{"normal_force", f.normal}, {"friction", list(f.friction.head<2>())}, {"moment", f.friction[2]}});
    }
    json["basis"].push_back(std::move(one));
  }
  return json;
}

ordered_json to_family(const GraspAnswer& answer, const GraspScene& scene) {
  constexpr std::array<std::string_view, 4> parameters{"turn", "offset", "mu", "spread"};
  constexpr std::array<std::string_view, 4> units{"rad", "m", "1", "1"};
  const auto parameter = static_cast<std::size_t>(scene.family->parameter);
  const auto count = [&](Verdict v) { return std::ranges::count(answer.family, v, &FamilyMember::verdict); };
  ordered_json json{{"parameter", parameters[parameter]},
                    {"unit", units[parameter]},
                    {"holds", count(Verdict::holds)},
                    {"cannot_hold", count(Verdict::cannot_hold)},
                    {"undecided", count(Verdict::undecided)}};
  json["boundaries"] = list(answer.boundaries);
  return json;
}

}  // namespace

std::string to_json(const GraspAnswer& answer, const GraspScene& scene, std::string_view scene_path) {
  ordered_json json = answer_head(scene_path, scene.title);
  json["question"] = grasp_questions[static_cast<std::size_t>(scene.question)];
  json["length"] = {{"value", scene.length}, {"unit", "m"}};
  json["contacts"] = ordered_json::array();
  for (const GraspContact& c : scene.contacts) {
    const grasp::Contact contact(c.frame, c.cone);
    ordered_json one{{"contact", c.words}, {"position", list(contact.position())}, {"normal", list(contact.normal())}};
    one["tangent"] = list(contact.u());
    if (c.limit) one["limit"] = {{"value", *c.limit}, {"unit", "N"}};
    json["contacts"].push_back(std::move(one));
  }
  if (answer.ball) json["ball"] = to_ball(*answer.ball, scene);
  if (answer.internal) json["internal_forces"] = to_internal(*answer.internal);
  if (asks_of_a_set(scene.question)) {
    json["set"] = {
        {"corners", scene.loads.size()}, {"axes", scene.disturbance.size()}, {"simplices", answer.simplices}};
  }
  if (scene.family) json["family"] = to_family(answer, scene);
  if (!answer.loads.empty()) {
    const std::size_t listed = std::min(answer.loads.size(), most_grasp_loads_listed);
    json["answers"] = ordered_json::array();
    for (std::size_t i = 0; i < listed; ++i) json["answers"].push_back(to_load(answer.loads[i], scene));
  }
  json["warnings"] = answer.warnings;
  return json.dump(2) + "\n";
}

}  // namespace patchgrip::cli
