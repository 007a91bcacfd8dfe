#include <patchgrip/verification/cases/press.h>

#include <cmath>
#include <memory>

#include <patchgrip/verification/fe/half_space.h>

namespace patchgrip::verification {

Solved solve_press(const PressedBody& body, const Setting& setting) {
  constexpr double contact_reach = 1.15;  // over a: short of the equator of the deepest sphere
  auto model = std::make_shared<Model>(half_space_of_revolution(setting, contact_reach, body.material, body.force));
  press_without_friction(*model, body.height, body.force, 0.9 * body.approach, body.slope);
  Solved solved;
  solved.iterations = model->solve(1e-8 * body.force, "press");
  solved.unknowns = model->unknowns();

  const auto line = model->along("lam", region::contact);
  const double force = model->integral("2*pi*X(1)*lam", region::contact);
  const double second_moment = model->integral("2*pi*X(1)*sqr(X(1))*lam", region::contact);
  solved.values = {{model->number("delta")},
                   {std::sqrt(second_moment / force)},
                   {line.front().second},
                   values_at(line, body.radii),
                   {pressure_distance_of(line, body.pressure)}};

  solved.curves.push_back(pressure_curve(line, body.pressure, contact_reach));
  solved.stress = model->plane_field(von_mises_of_revolution());
  solved.vtk = [model](const std::string& file) {
    model->write_vtk(file, {"u"}, {{"von_mises", von_mises_of_revolution()}});
  };
  return solved;
}

}  // namespace patchgrip::verification
