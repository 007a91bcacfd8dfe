#include <patchgrip/verification/cases/calculix.h>

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include <patchgrip/verification/claims/creep.h>
#include <patchgrip/verification/claims/press.h>
#include <patchgrip/verification/claims/punch.h>
#include <patchgrip/verification/fe/calculix_press.h>
#include <patchgrip/verification/fe/half_space.h>

namespace patchgrip::verification {
namespace {

constexpr double hole = CalculixPress::hole;

CalculixPress spherical_press(const Setting& setting, std::function<double(double)> height) {
  // Faces that can touch go beyond the contact, the rigid body beyond them.
  constexpr double rigid_reach = 1.4, touched_reach = 1.35;
  return {QuadSection::half_space(hole, setting.extent, setting.elements),
          setting.extent,
          setting.elements,
          std::move(height),
          rigid_reach,
          touched_reach};
}

double modulus_of(const contact::Material& material) {
  return contact::contact_modulus(material, contact::Material::rigid());
}

std::string elastic(const std::string& name, double youngs_modulus, double poisson_ratio) {
  return fmt::format("*MATERIAL,NAME={}\n*ELASTIC\n{:.12g},{:.12g}\n", name, youngs_modulus, poisson_ratio);
}

std::string section_of(const std::string& elements, const std::string& material) {
  return fmt::format("*SOLID SECTION,ELSET={},MATERIAL={}\n", elements, material);
}

Solved pressed_to(const CalculixPress& press, const contact::Material& material, double force, double approach,
                  const std::vector<double>& radii, const std::function<double(double)>& library, double shown_reach) {
  const auto result = run_calculix(
      press.bodies({"BODY"}) + elastic("BODY", material.youngs_modulus, material.poisson_ratio) +
      section_of("BODY", "BODY") + section_of("RIGID", "BODY") + press.contact(modulus_of(material)) + "*BOUNDARY\n" +
      press.held() + fmt::format("*STEP,INC=1000\n*STATIC\n1.,1.\n*BOUNDARY\nRIGID,2,2,{:.12g}\n", -approach) +
      press.far_field(force, material) + "*NODE PRINT,NSET=RIGID,TOTALS=ONLY\nRF\n*EL FILE\nS\n*END STEP\n");
  const auto line = press.pressure(result);
  Solved solved;
  solved.values = {{-CalculixPress::sectors * result.total_force(1)}, values_at(line, radii, 3)};
  solved.unknowns = 2 * press.section.nodes.size();
  solved.curves.push_back(pressure_curve(line, library, shown_reach));
  return solved;
}

}  // namespace

Solved solve_press_by_calculix(const Setting& setting) {
  const PressedBody body = pressed_paraboloid();
  const CalculixPress press = spherical_press(setting, body.height_at);
  return pressed_to(press, body.material, body.force, body.approach, body.radii, body.pressure, press.touched_reach);
}

Solved solve_flat_punch_by_calculix(const Setting& setting) {
  constexpr double edge_refinement = 20;
  const Punch punch = flat_punch();
  const CalculixPress press{
      QuadSection::half_space_with_edge(hole, 1, setting.extent, setting.elements, edge_refinement),
      setting.extent,
      setting.elements,
      [](double) { return 0.; },
      1 + hole,  // as wide as the faces, which begin at the hole
      1};
  return pressed_to(
      press, punch.material, punch.library.force, punch.library.approach, punch.radii,
      [&](double r) { return punch.library.pressure(r); }, 0.98);
}

Solved solve_creep_by_calculix(const Setting& setting) {
  const CreepingPress claim = shear_held_by_calculix();
  const double R = claim.sphere_radius, E = claim.glassy.youngs_modulus, nu = claim.glassy.poisson_ratio;
  const CalculixPress press = spherical_press(setting, [=](double r) { return r * r / (2 * R); });
  const double fading = claim.fading_share * E;
  std::string input = press.bodies({"STAYS", "FADES"}) + press.rigid_as_one() + elastic("STAYS", E - fading, nu) +
                      elastic("FADES", fading, nu);
  // The equivalent creep rate of a dashpot of G_1 tau is q / (3 G_1 tau).
  const double fading_shear = fading / (2 * (1 + nu));
  input += fmt::format("*CREEP\n{:.12g},1.,0.\n", 1 / (3 * fading_shear * claim.fading_time));
  for (const char* set : {"STAYS", "FADES"}) input += section_of(set, set);
  input += section_of("RIGID", "STAYS") + press.contact(modulus_of(claim.glassy)) + "*BOUNDARY\n" + press.held();
  const auto step = [&](const std::string& procedure, double t) {
    const FarField far = far_field(claim, t);
    input += "*STEP,INC=10000\n" + procedure + "*BOUNDARY\n" + press.far_field(far.force, far.material) +
             fmt::format("*CLOAD\nREFERENCE,2,{:.12g}\n", -claim.force(t)) +
             "*NODE PRINT,NSET=REFERENCE,FREQUENCY=100000\nU\n*END STEP\n";
  };
  step("*STATIC\n.25,1.,1e-5,.5\n", 0);
  double at = 0;
  for (const double t : claim.times) {
    // Steps are of first order: n^2 of them make their error fall as that of the mesh.
    const double most = 4 * (t - at) / (setting.elements * setting.elements);
    step(fmt::format("*VISCO,CETOL=1e-3\n{0:.12g},{1:.12g},{2:.12g},{0:.12g}\n", most, t - at, 1e-6 * most), t);
    at = t;
  }
  std::vector<double> approaches;
  for (const auto& row : run_calculix(input).printed("displacements")) approaches.push_back(-row.at(2));
  approaches.erase(approaches.begin());  // that before the creep
  Solved solved;
  solved.values = {approaches, approaches};
  solved.unknowns = 2 * press.section.nodes.size();
  solved.curves.push_back({"approach",
                           "t [s]",
                           "approach [m]",
                           {{"FE", claim.times, approaches},
                            {"library", claim.times, claim.quantities[0].library, true},
                            {"seed 4.72", claim.times, claim.quantities[1].library, true}}});
  return solved;
}

}  // namespace patchgrip::verification
