#include <patchgrip/contact/half_space/stiffness.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace patchgrip::contact {
namespace {

// Cells of twice the side, in contact where half of the four cells in them are.
std::vector<double> coarser_contact(const Grid& fine, const Grid& coarse, std::span<const double> pressure) {
  std::vector<double> contact(coarse.size());
  for (int j = 0; j < fine.ny; ++j) {
    for (int i = 0; i < fine.nx; ++i) contact[coarse.index(i / 2, j / 2)] += pressure[fine.index(i, j)] > 0 ? 1 : 0;
  }
  for (double& cell : contact) cell = cell >= 2 ? 1 : 0;
  return contact;
}

// Of E*, [m].
double stiffness(const Grid& grid, std::span<const double> contact, const PressSettings& settings) {
  const std::vector<double> flat(grid.size());
  Workers workers(settings.threads_on(grid));
  PageMemory memory(ContactSolver::bytes_per_cell * grid.size());
  ContactSolver solver(grid, Surface::free, flat, {workers, memory});
  return solver.stiffness(contact, settings.tolerance, settings.max_iterations, settings.observer) * grid.cell_area();
}

}  // namespace

Estimate contact_stiffness(const PressedHalfSpace& pressed, const PressSettings& settings) {
  settings.check();
  if (pressed.surface == Surface::periodic) {
    throw std::invalid_argument("a periodic surface has no stiffness: its mean displacement is infinite");
  }
  const Grid& grid = pressed.grid;
  const Grid coarse{(grid.nx + 1) / 2, (grid.ny + 1) / 2, 2 * grid.dx, 2 * grid.dy};
  const double value = stiffness(grid, pressed.pressure, settings);
  const auto coarse_contact = coarser_contact(grid, coarse, pressed.pressure);
  const bool is_seen = std::ranges::any_of(coarse_contact, [](double cell) { return cell > 0; });
  const double error = is_seen ? std::abs(value - stiffness(coarse, coarse_contact, settings)) / 2 : value;
  return {pressed.contact_modulus * value, pressed.contact_modulus * (error + settings.tolerance * value)};
}

}  // namespace patchgrip::contact
