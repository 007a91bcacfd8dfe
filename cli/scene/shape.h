// Shapes of bodies as a scene describes them, before anything is computed from them.
//
// The frame is that of the contact: z along the normal, origin where the bodies touch first.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/contact/half_space/height_map.h>
#include <patchgrip/contact/point_profile.h>

namespace patchgrip::cli {

struct Ball {
  double radius;  // [m]; negative for a hollow
};

struct Plane {};

// A surface by its principal radii; the first one is measured in the direction of the x-axis turned by `direction`.
struct CurvedSurface {
  std::array<double, 2> radii;  // [m]; negative for a hollow, infinite where it is straight
  double direction;             // [rad]
};

// A body of revolution about the normal, by its height f(r) above the lowest point.
struct SphereStamp {
  double radius;  // [m]
  int terms;      // of the series in r^2; 0 for the sphere itself
};
struct ConeStamp {
  double slope;  // f = slope r
};
struct PowerStamp {
  double coefficient;  // f = coefficient r^exponent [m^(1 - exponent)]
  double exponent;
};
struct FlatPunchStamp {
  double radius;  // [m]
};
struct FlatEndParaboloidStamp {
  double end_radius;  // b [m]: f = (r^2 - b^2) / (2 radius) beyond
  double radius;      // [m]
};
struct FlatEndConeStamp {
  double end_radius;  // b [m]: f = slope (r - b) beyond
  double slope;
};
struct PointStamp {
  std::vector<contact::ProfilePoint> points;  // straight between them
};

// The surface of a mesh near a point of it.
struct MeshSurface {
  std::filesystem::path file;
  std::array<double, 3> point;  // in the frame and the unit of the file
  double unit;                  // of its coordinates [m]
  Place place;                  // the key 'mesh'
};

// Heights on a grid, its middle at the origin.
struct HeightMapFile {
  std::shared_ptr<const contact::HeightMap> map;
  std::array<double, 2> cell;  // size of a cell along x and y [m]
  bool periodic;               // the map repeats without end
  Place place;                 // the key 'height_map'
};

using Shape = std::variant<Ball, Plane, CurvedSurface, SphereStamp, ConeStamp, PowerStamp, FlatPunchStamp,
                           FlatEndParaboloidStamp, FlatEndConeStamp, PointStamp, MeshSurface, HeightMapFile>;

struct DescribedShape {
  Shape shape;
  std::string words;
};

// Keys of a body that describe its shape.
inline constexpr std::array<std::string_view, 19> shape_keys{
    "radius", "plane",      "concave", "radii", "cylinder", "direction",  "stamp", "slope", "coefficient", "exponent",
    "terms",  "end_radius", "points",  "mesh",  "point",    "height_map", "unit",  "cell",  "periodic"};

// Throws SceneError. Files are looked for beside the scene.
DescribedShape read_shape(const TomlReader& body);

}  // namespace patchgrip::cli
