#include <patchgrip/verification/fe/mesh.h>

#include <gmsh.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace patchgrip::verification {
namespace {

namespace geo = gmsh::model::geo;
namespace occ = gmsh::model::occ;

// Removed with all that is in it at the end of the program.
class WorkFolder {
 public:
  WorkFolder() : path_(std::filesystem::temp_directory_path() / ("patchgrip-verify-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~WorkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  std::filesystem::path next_file() { return path_ / ("mesh" + std::to_string(++count_) + ".msh"); }

 private:
  std::filesystem::path path_;
  int count_ = 0;
};

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
  static WorkFolder folder;
  gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double z) { return size(x, y, z); });
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dimension);
  std::vector<int> tags;
  for (const auto& entity : entities) tags.push_back(entity.second);
  gmsh::model::addPhysicalGroup(dimension, tags, 1000);  // out of the way of regions of the boundary
  gmsh::model::mesh::generate(dimension);
  if (order > 1) gmsh::model::mesh::setOrder(order);
  const auto file = folder.next_file();
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

}  // namespace patchgrip::verification
