// Grasps against data/reference/grasp.json: optima, forces and twists to 20 digits and more.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <patchgrip/tests/grasp/grasp_table.h>

namespace patchgrip::grasp {
namespace {

void show(const json& c, const GripAnswer& a, double value) {
  std::printf("%s %-20s nt %3d newton %2d rep %d route %d verdict %d err %.1e width %.1e charged %.1e value %.16g\n",
              c["id"].get<std::string>().c_str(), c["grasp"].get<std::string>().c_str(), a.effort.iterations,
              a.effort.newton_steps, a.effort.repairs, (int)a.effort.route, (int)a.verdict,
              std::fabs(a.value / value - 1), (a.upper - a.lower) / a.upper, a.charged, a.value);
}

TEST(GraspTable, LeastGrip) {
  for (const json& c : cases_of("min_max_normal")) {
    Grasp grasp(contacts(c["grasp"]));
    show(c, grasp.least_grip(vector6(c["load"])), number(c["result"]["value"]));
  }
  for (const json& c : cases_of("min_sum_normal")) {
    Grasp grasp(contacts(c["grasp"]));
    show(c, grasp.least_total_grip(vector6(c["load"])), number(c["result"]["value"]));
  }
  for (const json& c : cases_of("load_factor")) {
    Grasp grasp(contacts(c["grasp"]));
    std::vector<double> caps;
    for (const json& x : c["caps"]) caps.push_back(number(x));
    show(c, grasp.load_factor(vector6(c["load"]), vector6(c["load_step"]), caps), number(c["result"]["value"]));
  }
}

}  // namespace
}  // namespace patchgrip::grasp
