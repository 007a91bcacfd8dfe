#include <patchgrip/contact/triangle_mesh.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

namespace patchgrip::contact {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw std::invalid_argument("mesh file " + file + " " + why);
}

std::string suffix(const std::string& file) {
  std::string end = std::filesystem::path(file).extension().string();
  std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
  return end;
}

}  // namespace

TriangleMesh TriangleMesh::read(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) refuse(file, "cannot be opened");
  if (in.peek() == std::ifstream::traits_type::eof()) refuse(file, "is empty");
  const std::string kind = suffix(file);

  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  bool read = false;
  try {
    if (kind == ".off") {
      read = CGAL::IO::read_OFF(in, points, polygons);
    } else if (kind == ".ply") {
      read = CGAL::IO::read_PLY(in, points, polygons);
    } else if (kind == ".stl") {
      read = CGAL::IO::read_STL(in, points, polygons);
    } else {
      refuse(file, "is of unknown kind: .off, .ply and .stl can be read");
    }
  } catch (const std::bad_alloc&) {
    refuse(file, "announces more than fits into memory");
  } catch (const std::length_error&) {
    refuse(file, "announces more than fits into memory");
  }
  if (!read) refuse(file, "is cut off or not a mesh");
  if (polygons.empty()) refuse(file, "has no triangles");

  // STL repeats a vertex in each of its triangles.
  std::map<Vector, std::size_t> index;
  std::vector<Vector> vertices;
  std::vector<Triangle> triangles;
  for (const auto& polygon : polygons) {
    if (polygon.size() != 3)
      refuse(file, "has a face with " + std::to_string(polygon.size()) + " corners: triangles only");
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (polygon[k] >= points.size()) refuse(file, "names a vertex that it does not have");
      const Point& p = points[polygon[k]];
      if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) {
        refuse(file, "has a vertex that is not finite");
      }
      const auto [place, added] = index.try_emplace(Vector{p.x(), p.y(), p.z()}, vertices.size());
      if (added) vertices.push_back(place->first);
      triangle[k] = place->second;
    }
    triangles.push_back(triangle);
  }
  try {
    return of(std::move(vertices), std::move(triangles));
  } catch (const std::invalid_argument& error) {
    refuse(file, std::string("does not hold a surface: ") + error.what());
  }
}

}  // namespace patchgrip::contact
