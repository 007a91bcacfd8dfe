#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

Grid Grid::of_cells(int nx, int ny, double dx, double dy) {
  require_in("nx", nx, least_cells, most_cells);
  require_in("ny", ny, least_cells, most_cells);
  require_in("dx", dx, 1e-50, 1e50);
  require_in("dy", dy, 1e-50, 1e50);
  require_in("dx / dy", dx / dy, 0.125, 8);
  const Grid grid{nx, ny, dx, dy};
  require_in("nx ny", static_cast<double>(grid.size()), 1, static_cast<double>(most_cells_in_all));
  return grid;
}

Grid Grid::square(int cells, double width) {
  require_in("cells", cells, least_cells, most_cells);
  require_positive("width", width);
  return of_cells(cells, cells, width / cells, width / cells);
}

}  // namespace patchgrip::contact
