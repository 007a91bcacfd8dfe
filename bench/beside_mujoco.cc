// Beside MuJoCo, in one run, steps of 2 ms: a puck that slides and spins to rest, a block on a belt, a held load.
//
//     beside_mujoco [--output CSV] [--short]
//
// Puck: 1 kg, R = 0.05 m, uniform pressure, 1 m/s, 20 rad/s, mu = 0.5, g = 9.81 m/s^2. Belt: 2 kg held back by 800 N/m,
// F_N = 20 N, mu = 0.6 at rest and in motion (MuJoCo knows one coefficient), 0.05 m/s; its place after 5 s. Hold: the
// puck under 95 % of the limit, for 10 s. MuJoCo with elliptic cones and Newton's method, as a cylinder that touches at
// its rim and as one contact with a torsional coefficient 2 R / 3 mu, each with its defaults and with stiffer contacts
// (solref 0.004, impratio 100). Ours: return mapping by SDIRK2, the belt by events. Each ratio is to the best that
// MuJoCo does in that respect. --short repeats less.
#include <fmt/ostream.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/bench/cpu_time.h>
#include <patchgrip/dynamics/bristle_body.h>
#include <patchgrip/dynamics/point_motion.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::dynamics;
using patchgrip::bench::least_cpu_time;
using patchgrip::friction::UniformDisc;

constexpr double h = 2e-3, R = 0.05, J = R * R / 2, gravity = 9.81, mu = 0.5, L = mu * gravity;
constexpr double stop_time = .27325143366306, stop_distance = .12994846567449;
constexpr double belt_mu = 0.6, belt_force = 20, belt_mass = 2, belt_spring = 800, belt_speed = 0.05, belt_end = 5;

// --- what is measured

struct Answer {
  double time = 0, distance = 0;                 // of the puck [s], [m]
  double place = 0;                              // of the block on the belt [m]
  double creep = 0;                              // of the held load [m/s]
  double puck_us = 0, belt_us = 0, hold_us = 0;  // CPU time per simulated second
};

double kinetic(const Vector3& v) { return (v[0] * v[0] + v[1] * v[1] + J * v[2] * v[2]) / 2; }

// Of a puck: told by its last state that slides on for half a step, from where deceleration is constant.
class StopWatch {
 public:
  void see(double t, double x, const Vector3& v) {
    const double D = disc_.dissipation({v[0], v[1], v[2]});
    if (D > 0 && kinetic(v) > h / 4 * L * D) {
      const double rest = 2 * kinetic(v) / (L * D);
      time_ = t + rest;
      distance_ = x + v[0] * rest / 2;
    }
  }
  double time() const { return time_; }
  double distance() const { return distance_; }

 private:
  UniformDisc disc_ = UniformDisc::of_radius(R);
  double time_ = 0, distance_ = 0;
};

// --- ours

const auto no_load = [](double) { return Vector3(Vector3::Zero()); };
const auto limit = [](double, const Vector3&) { return L; };

Answer ours(double seconds) {
  Answer a;
  const BristleBody body(UniformDisc::of_radius(R), {1, J, {1e8, 1e8 * J}});
  PlanarState start;
  start.twist = {1, 0, 20};
  const auto puck = [&](StopWatch* watch) {
    PlanarState s = start;
    for (int i = 0; i < 200; ++i) {
      s = body.step(s, i * h, h, Method::sdirk2, no_load, limit).state;
      if (watch != nullptr) watch->see((i + 1) * h, s.place[0], s.twist);
    }
    return s;
  };
  StopWatch watch;
  puck(&watch);
  a.time = watch.time();
  a.distance = watch.distance();
  a.puck_us = least_cpu_time([&] { puck(nullptr); }, seconds) / 0.4;

  const auto belt = [] {
    const PointMotion motion({belt_mass, belt_spring, 0, belt_speed}, Law::coulomb(belt_mu));
    return motion({[](double) { return 0.; }, [](double) { return belt_force; }}, {0, belt_speed}, 0, belt_end,
                  {1e-10, 1e-2})
        .state.x;
  };
  a.place = belt();
  a.belt_us = least_cpu_time(belt, seconds) / belt_end;

  const auto hold = [&] {
    PlanarState s;
    s.anchor[0] = -0.95 * L / 1e8;
    for (int i = 0; i < 5000; ++i)
      s = body.step(
                  s, i * h, h, Method::sdirk2, [](double) { return Vector3(0.95 * L, 0, 0); }, limit)
              .state;
    return s.place[0];
  };
  a.creep = std::fabs(hold()) / 10;
  a.hold_us = least_cpu_time(hold, seconds) / 10;
  return a;
}

// --- MuJoCo

class Simulation {
 public:
  explicit Simulation(const std::string& xml) {
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(xml.size()));
    std::memcpy(files->filedata[mj_findFileVFS(files.get(), "scene.xml")], xml.data(), xml.size());
    char error[1000] = "";
    model_.reset(mj_loadXML("scene.xml", files.get(), error, sizeof error));
    mj_deleteVFS(files.get());
    if (!model_) throw std::runtime_error(error);
    data_.reset(mj_makeData(model_.get()));
    start_.reset(mj_makeData(model_.get()));
    for (int i = 0; i < 1000; ++i) step();  // until the contact carries the weight
    data_->time = 0;
    keep();
  }

  mjData& data() { return *data_; }
  void step() { mj_step(model_.get(), data_.get()); }
  void keep() { mj_copyData(start_.get(), model_.get(), data_.get()); }
  void restart() { mj_copyData(data_.get(), model_.get(), start_.get()); }

 private:
  struct Delete {
    void operator()(mjModel* m) const { mj_deleteModel(m); }
    void operator()(mjData* d) const { mj_deleteData(d); }
  };
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_, start_;
};

struct Setup {
  const char* name;
  bool cylinder, stiff;
};

std::string options_of(const Setup& setup, double g) {
  return fmt::format(
      R"(<option timestep="{}" gravity="0 0 {}" cone="elliptic" solver="Newton" impratio="{}"/>
<default><geom solref="{} 1"/><joint armature="0"/></default>)",
      h, -g, setup.stiff ? 100 : 1, setup.stiff ? 0.004 : 0.02);
}

std::string puck_scene(const Setup& setup) {
  const std::string friction = fmt::format(R"(friction="{} {} 0")", mu, mu * 2 * R / 3);
  const std::string geom =
      setup.cylinder ? fmt::format(R"(<geom type="cylinder" size="{} 0.01" mass="1" condim="3" {}/>)", R, friction)
                     : fmt::format(R"(<inertial pos="0 0 0" mass="1" diaginertia="{0} {0} {0}"/>
<geom type="sphere" size="0.01" condim="4" {1}/>)",
                                   J, friction);
  return fmt::format(R"(<mujoco>{}<worldbody><geom type="plane" size="5 5 0.1" {}/>
<body pos="0 0 0.01"><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/>
<joint type="slide" axis="0 0 1"/><joint type="hinge" axis="0 0 1"/>{}</body></worldbody></mujoco>)",
                     options_of(setup, gravity), friction, geom);
}

std::string belt_scene(const Setup& setup) {
  const std::string friction = fmt::format(R"(friction="{} 0 0" condim="3")", belt_mu);
  const std::string geom =
      setup.cylinder ? fmt::format(R"(<geom type="box" size="0.05 0.05 0.01" mass="{}" {}/>)", belt_mass, friction)
                     : fmt::format(R"(<geom type="sphere" size="0.01" mass="{}" {}/>)", belt_mass, friction);
  // The belt is so heavy that it keeps its speed.
  return fmt::format(R"(<mujoco>{}<worldbody>
<body pos="0 0 -0.1"><joint type="slide" axis="1 0 0"/><geom type="box" size="5 1 0.1" mass="1e9" {}/></body>
<body pos="0 0 0.01"><joint type="slide" axis="1 0 0" stiffness="{}"/><joint type="slide" axis="0 0 1"/>{}</body>
</worldbody></mujoco>)",
                     options_of(setup, belt_force / belt_mass), friction, belt_spring, geom);
}

Answer mujoco(const Setup& setup, double seconds) {
  Answer a;
  Simulation puck(puck_scene(setup));
  const auto slide = [&](StopWatch* watch) {
    puck.restart();
    mjData& d = puck.data();
    d.qpos[0] = 0;
    d.qvel[0] = 1;
    d.qvel[3] = 20;
    for (int i = 0; i < 200; ++i) {
      puck.step();
      if (watch != nullptr) watch->see(d.time, d.qpos[0], {d.qvel[0], d.qvel[1], d.qvel[3]});
    }
  };
  StopWatch watch;
  slide(&watch);
  a.time = watch.time();
  a.distance = watch.distance();
  a.puck_us = least_cpu_time([&] { slide(nullptr); }, seconds) / 0.4;

  double creep = 0;
  const auto hold = [&] {
    puck.restart();
    mjData& d = puck.data();
    d.qfrc_applied[0] = 0.95 * L;
    double half = 0;
    for (int i = 0; i < 5000; ++i) {
      if (i == 2500) half = d.qpos[0];
      puck.step();
    }
    creep = std::fabs(d.qpos[0] - half) / 5;
  };
  a.hold_us = least_cpu_time(hold, seconds) / 10;
  a.creep = creep;

  Simulation belt(belt_scene(setup));
  const auto ride = [&] {
    belt.restart();
    mjData& d = belt.data();
    d.qpos[1] = 0;
    d.qvel[0] = belt_speed;
    d.qvel[1] = belt_speed;
    for (int i = 0; i < static_cast<int>(belt_end / h); ++i) belt.step();
  };
  ride();
  a.place = belt.data().qpos[1];
  a.belt_us = least_cpu_time(ride, seconds) / belt_end;
  return a;
}

// Carried along until the spring pulls mu F_N, then about that place, touching the belt's speed once a cycle.
double belt_place() {
  const double away = belt_mu * belt_force / belt_spring, w = std::sqrt(belt_spring / belt_mass);
  return away + belt_speed / w * std::sin(w * (belt_end - away / belt_speed));
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("beside_mujoco", "A puck, a belt and a held load, ours and by MuJoCo at 2 ms.",
                                     "repeat each measurement fewer times");
  line.read(argc, argv);
  const double seconds = line.is_short ? 0.02 : 0.3;
  std::ostringstream csv;
  fmt::print(csv, "# patchgrip {} beside_mujoco\n", patchgrip::version);
  fmt::print(csv, "method,stop_error_s,distance_error_m,belt_error_m,creep_m_per_s,puck_us,belt_us,hold_us\n");
  fmt::print("{:<28} stop [s]  distance [m]  belt [m]  creep [m/s]   puck   belt   hold [us per simulated s]\n",
             "errors of");
  const auto row = [&](const std::string& name, Answer a) {
    a.time = std::fabs(a.time - stop_time);
    a.distance = std::fabs(a.distance - stop_distance);
    a.place = std::fabs(a.place - belt_place());
    fmt::print("{:<28} {:>8.1e} {:>13.1e} {:>9.1e} {:>12.1e} {:>6.0f} {:>6.0f} {:>6.0f}\n", name, a.time, a.distance,
               a.place, a.creep, a.puck_us, a.belt_us, a.hold_us);
    fmt::print(csv, "{},{:e},{:e},{:e},{:e},{:e},{:e},{:e}\n", name, a.time, a.distance, a.place, a.creep, a.puck_us,
               a.belt_us, a.hold_us);
    return a;
  };
  const Answer us = row("patchgrip", ours(seconds));
  std::vector<Answer> others;
  for (const Setup& s : {Setup{"cylinder", true, false}, Setup{"cylinder, stiff", true, true},
                         Setup{"torsional", false, false}, Setup{"torsional, stiff", false, true}})
    others.push_back(row(fmt::format("MuJoCo {}", s.name), mujoco(s, seconds)));
  const auto ratio = [&](const char* name, double Answer::*what, const char* target) {
    const auto best = std::ranges::min_element(others, {}, what);
    fmt::print("  {:<44} {:>9.2e}   target {}\n", name, us.*what / ((*best).*what), target);
  };
  fmt::print("\nours as a part of MuJoCo's best\n");
  ratio("CPU time of the puck", &Answer::puck_us, "<= 0.5");
  ratio("CPU time of the belt", &Answer::belt_us, "<= 0.5");
  ratio("CPU time of the hold", &Answer::hold_us, "<= 0.5");
  ratio("error of the stop time", &Answer::time, "<= 1e-4");
  ratio("error of the distance", &Answer::distance, "<= 1e-3");
  ratio("error of the belt", &Answer::place, "-");
  ratio("creep of what is held", &Answer::creep, "-");
  return line.write([&](std::ostream& file) { file << csv.str(); });
}
