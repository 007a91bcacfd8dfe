#include <patchgrip/verification/fe/model.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace patchgrip::verification {
namespace {

using ::testing::HasSubstr;

Model section() {
  Model model(Mesh::half_space_section(1, 0.5, graded(0.2, 1, 0)));
  model.mark(region::contact, [](const Point& p) { return std::fabs(p[1]) < 1e-9; });
  return model;
}

std::string failure_from(double start) {
  Model model = section();
  model.unknown("x", start);
  model.nonlinear("(sqr(x)+1)*Test_x", region::contact);  // no root
  try {
    model.solve(1e-8, "a parabola above the axis");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "solved";
}

TEST(Model, UnsolvedOneGivesNoNumberButItsPlace) {
  EXPECT_THAT(failure_from(0.7), HasSubstr("a parabola above the axis: Newton's method did not converge"));
}

TEST(Model, SingularOneGivesNoNumberButItsPlace) {
  EXPECT_THAT(failure_from(0), HasSubstr("a parabola above the axis: "));
}

TEST(Model, SolvesAndIntegrates) {
  Model model = section();
  model.unknown("x", 1);
  model.nonlinear("(sqr(x)-4)*Test_x", region::contact);
  EXPECT_GT(model.solve(1e-10, "a parabola"), 1);
  EXPECT_NEAR(model.number("x"), 2, 1e-9);
  EXPECT_NEAR(model.integral("X(1)", region::contact), 0.5, 1e-12);
  EXPECT_NEAR(model.integral("1"), std::numbers::pi / 4, 0.02);  // straight edges along the arc
}

TEST(Model, RegionsWithoutFacesAreRefused) {
  Model model = section();
  EXPECT_THROW(model.mark(region::side, [](const Point&) { return false; }), std::runtime_error);
}

}  // namespace
}  // namespace patchgrip::verification
