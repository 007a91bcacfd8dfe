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
  constexpr double fine_reach = 1.5, wanted_growth = 1.2;
  const double fine = 1 / elements, rest = extent - fine_reach;
  const int fine_count = static_cast<int>(std::lround(fine_reach * elements));
  const int count =
      static_cast<int>(std::ceil(std::log1p(rest * (wanted_growth - 1) / fine) / std::log(wanted_growth)));
  // The ratio q of neighbours with which `count` elements from `fine` on fill the rest.
  double low = 1 + 1e-6, high = 2;
  while (high - low > 1e-12) {
    const double q = (low + high) / 2;
    (fine * (std::pow(q, count) - 1) / (q - 1) < rest ? low : high) = q;
  }
  const GmshSession session;
  const std::array<double, 3> xs{inner, fine_reach, extent}, ys{0, -fine_reach, -extent};
  std::array<std::array<int, 3>, 3> points{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) points[i][j] = geo::addPoint(xs[i], ys[j], 0);
  }
  const auto curve = [&](int from, int to, std::size_t block) {
    const int line = geo::addLine(from, to);
    geo::mesh::setTransfiniteCurve(line, (block == 0 ? fine_count : count) + 1, "Progression", block == 0 ? 1 : low);
    return line;
  };
  std::array<std::array<int, 3>, 3> across{}, down{};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      across[i][j] = curve(points[i][j], points[i + 1][j], i);
      down[j][i] = curve(points[j][i], points[j][i + 1], i);
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const int loop = geo::addCurveLoop({down[i][j], across[i][j + 1], -down[i + 1][j], -across[i][j]});
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

}  // namespace patchgrip::verification
