#include <patchgrip/verification/fe/mesh.h>

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <patchgrip/verification/fe/work_folder.h>

namespace patchgrip::verification {
namespace {

namespace geo = gmsh::model::geo;
namespace occ = gmsh::model::occ;

struct GmshSession {
  GmshSession() {
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    for (const char* from : {"FromPoints", "ExtendFromBoundary", "FromCurvature"}) {
      gmsh::option::setNumber(std::string("Mesh.MeshSize") + from, 0);
    }
    gmsh::option::setNumber("Mesh.MshFileVersion", 2.2);
    gmsh::option::setNumber("Mesh.Algorithm", 6);    // frontal Delaunay
    gmsh::option::setNumber("Mesh.Algorithm3D", 1);  // Delaunay
    gmsh::model::add("body");
  }
  ~GmshSession() { gmsh::finalize(); }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
};

// The one surface or volume that there is, with elements of the given order.
Mesh meshed(int dimension, const SizeAt& size, int order) {
  gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double z) { return size(x, y, z); });
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dimension);
  std::vector<int> tags;
  for (const auto& entity : entities) tags.push_back(entity.second);
  gmsh::model::addPhysicalGroup(dimension, tags, 1000);  // out of the way of regions of the boundary
  gmsh::model::mesh::generate(dimension);
  if (order > 1) gmsh::model::mesh::setOrder(order);
  const auto file = new_work_file(".msh");
  gmsh::write(file.string());
  return {file, dimension};
}

template <class Build>
Mesh built(int dimension, const SizeAt& size, int order, const Build& build) {
  const GmshSession session;
  build();
  return meshed(dimension, size, order);
}

struct Division {
  double end;     // where it ends
  int count;      // of elements
  double growth;  // ratio of neighbours
};

// From elements of the size `fine` on, as many as fill the length with about the wanted growth.
Division growing(double from, double to, double fine, double wanted_growth) {
  const double length = to - from;
  const int count =
      static_cast<int>(std::ceil(std::log1p(length * (wanted_growth - 1) / fine) / std::log(wanted_growth)));
  double low = 1 + 1e-6, high = 2;
  while (high - low > 1e-12) {
    const double q = (low + high) / 2;
    (fine * (std::pow(q, count) - 1) / (q - 1) < length ? low : high) = q;
  }
  return {to, count, low};
}

QuadSection tensor_section(double inner, const std::vector<Division>& across, const std::vector<Division>& down) {
  const GmshSession session;
  const std::size_t columns = across.size(), rows = down.size();
  std::vector<std::vector<int>> points(columns + 1);
  for (std::size_t i = 0; i <= columns; ++i) {
    for (std::size_t j = 0; j <= rows; ++j) {
      points[i].push_back(geo::addPoint(i == 0 ? inner : across[i - 1].end, j == 0 ? 0 : -down[j - 1].end, 0));
    }
  }
  const auto curve = [&](int from, int to, const Division& division) {
    const int line = geo::addLine(from, to);
    geo::mesh::setTransfiniteCurve(line, division.count + 1, "Progression", division.growth);
    return line;
  };
  std::vector<std::vector<int>> rightwards(columns), downwards(columns + 1);
  for (std::size_t i = 0; i <= columns; ++i) {
    for (std::size_t j = 0; j <= rows; ++j) {
      if (i < columns) rightwards[i].push_back(curve(points[i][j], points[i + 1][j], across[i]));
      if (j < rows) downwards[i].push_back(curve(points[i][j], points[i][j + 1], down[j]));
    }
  }
  for (std::size_t i = 0; i < columns; ++i) {
    for (std::size_t j = 0; j < rows; ++j) {
      const int loop =
          geo::addCurveLoop({downwards[i][j], rightwards[i][j + 1], -downwards[i + 1][j], -rightwards[i][j]});
      const int surface = geo::addPlaneSurface({loop});
      geo::mesh::setTransfiniteSurface(surface);
      geo::mesh::setRecombine(2, surface);
    }
  }
  geo::synchronize();
  gmsh::model::mesh::generate(2);
  gmsh::option::setNumber("Mesh.SecondOrderIncomplete", 1);
  gmsh::model::mesh::setOrder(2);

  std::vector<std::size_t> tags, element_tags, element_nodes;
  std::vector<double> places, unused;
  gmsh::model::mesh::getNodes(tags, places, unused);
  std::map<std::size_t, std::size_t> number;
  QuadSection section;
  for (std::size_t k = 0; k < tags.size(); ++k) {
    number[tags[k]] = k;
    section.nodes.push_back({places[3 * k], places[3 * k + 1]});
  }
  constexpr int eight_node_quad = 16;
  gmsh::model::mesh::getElementsByType(eight_node_quad, element_tags, element_nodes);
  for (std::size_t k = 0; k < element_nodes.size(); k += 8) {
    auto& element = section.elements.emplace_back();
    for (std::size_t i = 0; i < 8; ++i) element[i] = number.at(element_nodes[k + i]);
  }
  return section;
}

}  // namespace

SizeAt graded(double fine, double reach, double growth) {
  return [=](double x, double y, double z) { return fine + growth * std::max(std::hypot(x, y, z) - reach, 0.); };
}

Mesh Mesh::half_space_section(double extent, double split, const SizeAt& size) {
  return built(2, size, 1, [&] {
    const int centre = geo::addPoint(0, 0, 0), edge = geo::addPoint(split, 0, 0);
    const int right = geo::addPoint(extent, 0, 0), below = geo::addPoint(0, -extent, 0);
    geo::addPlaneSurface({geo::addCurveLoop({geo::addLine(centre, edge), geo::addLine(edge, right),
                                             geo::addCircleArc(right, centre, below), geo::addLine(below, centre)})});
    geo::synchronize();
  });
}

Mesh Mesh::half_space_quarter(double extent, const SizeAt& size) {
  return built(3, size, 1, [&] {
    const int ball = occ::addSphere(0, 0, 0, extent);
    const int corner = occ::addBox(0, 0, -2 * extent, 2 * extent, 2 * extent, 2 * extent);
    gmsh::vectorpair out;
    std::vector<gmsh::vectorpair> parents;
    occ::intersect({{3, ball}}, {{3, corner}}, out, parents);
    occ::synchronize();
  });
}

Mesh Mesh::hemisphere_section(double radius, const SizeAt& size) {
  return built(2, size, 2, [&] {
    const int centre = geo::addPoint(0, 0, 0);
    const int apex = geo::addPoint(0, -radius, 0), rim = geo::addPoint(radius, 0, 0);
    geo::addPlaneSurface({geo::addCurveLoop(
        {geo::addCircleArc(apex, centre, rim), geo::addLine(rim, centre), geo::addLine(centre, apex)})});
    geo::synchronize();
  });
}

Mesh Mesh::elliptic_pad(double a, double b, double height, double size) {
  return built(
      3, [=](double, double, double) { return size; }, 2,
      [&] {
        const int disc = occ::addDisk(0, 0, 0, std::max(a, b), std::min(a, b));
        if (b > a) occ::rotate({{2, disc}}, 0, 0, 0, 0, 0, 1, std::acos(0.));
        gmsh::vectorpair out;
        occ::extrude({{2, disc}}, 0, 0, height, out);
        occ::synchronize();
      });
}

Mesh Mesh::box_pad(double side_x, double side_y, double height, double size) {
  return built(
      3, [=](double, double, double) { return size; }, 1,
      [&] {
        occ::addBox(-side_x / 2, -side_y / 2, 0, side_x, side_y, height);
        occ::synchronize();
      });
}

QuadSection QuadSection::half_space(double inner, double extent, double elements) {
  constexpr double fine_reach = 1.5;
  const auto even = [&](double from, double to) {
    return Division{to, static_cast<int>(std::lround((to - from) * elements)), 1};
  };
  const Division rest = growing(fine_reach, extent, 1 / elements, 1.2);
  return tensor_section(inner, {even(inner, 1), even(1, fine_reach), rest}, {even(0, fine_reach), rest});
}

QuadSection QuadSection::half_space_with_edge(double inner, double edge, double extent, double elements,
                                              double edge_refinement) {
  const double fine = 1 / (elements * edge_refinement), growth = 1 + 2 / elements;
  Division within = growing(inner, edge, fine, growth);
  within.growth = 1 / within.growth;  // from the axis outwards they shrink
  return tensor_section(inner, {within, growing(edge, extent, fine, growth)}, {growing(0, extent, fine, growth)});
}

}  // namespace patchgrip::verification
