// The limit surface as the program writes it: mesh, VTK, CSV and picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <patchgrip/cli/limit/limit.h>
#include <patchgrip/cli/limit/limit_mesh.h>
#include <patchgrip/cli/limit/surface_files.h>
#include <patchgrip/cli/limit/surface_picture.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>

#include "limit_scenes.h"
#include "vtk_file.h"

namespace patchgrip::cli {
namespace {

using friction::AnyPatch;
using friction::Twist;
using friction::Wrench;
using test::VtkFile;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string l_shape = R"([contact]
patch = "polygon"
vertices = [[0, 0], [0.03, 0], [0.03, 0.01], [0.01, 0.01], [0.01, 0.02], [0, 0.02]]
normal_force = 4
[friction]
mu = 0.5
)";

struct Meshed {
  AnyPatch patch;
  LimitMesh mesh;
};

Meshed meshed(const std::string& text, double resistance = 2) {
  const Contact contact = test::limit_scene(text).contact;
  return {any_patch(contact), mesh_of(contact, {resistance, 0}, 0.008, 24, 16)};
}

TEST(LimitMesh, PointsLieOnTheLimitSurface) {
  const auto [patch, mesh] = meshed(l_shape);
  const friction::LimitSurface surface{patch};
  ASSERT_EQ(mesh.points.size(), 15U * 24 + 2);
  for (const LimitPoint& p : mesh.points) {
    const friction::Gauge gauge = surface.gauge(p.wrench.value);
    EXPECT_NEAR(gauge.value, 2, 4e-12);
    // Their slip is the one that the gauge finds.
    EXPECT_NEAR(friction::power(p.wrench.value, p.slip), 2 * patch.dissipation(p.slip), 1e-14);
  }
}

// The slip is a normal that points outwards: no point of the surface lies beyond its plane.
TEST(LimitMesh, SlipsAreOutwardNormalsOfAConvexBody) {
  const LimitMesh mesh = meshed(l_shape).mesh;
  for (std::size_t i = 0; i < mesh.points.size(); i += 7) {
    const Twist& v = mesh.points[i].slip;
    const double height = friction::power(mesh.points[i].wrench.value, v);
    for (const LimitPoint& p : mesh.points) EXPECT_LE(friction::power(p.wrench.value, v), height + 1e-14);
  }
}

// Every edge belongs to two cells, once in each direction.
TEST(LimitMesh, IsClosedAndOriented) {
  const LimitMesh mesh = meshed(l_shape).mesh;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (int i = 0; i < mesh.parallels; ++i) {
    for (int j = 0; j < mesh.meridians; ++j) {
      const LimitMesh::Cell cell = mesh.cell(i, j);
      const std::size_t corners = cell[3] == cell[0] ? 3 : 4;
      for (std::size_t k = 0; k < corners; ++k) ++edges[{cell[k], cell[(k + 1) % corners]}];
    }
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
  // Euler: faces + points - edges = 2
  EXPECT_EQ(mesh.points.size() + static_cast<std::size_t>(mesh.parallels * mesh.meridians) - edges.size() / 2, 2U);
}

TEST(LimitMesh, CellsRunCounterClockwiseSeenFromOutside) {
  const LimitMesh mesh = meshed(l_shape).mesh;
  const auto at = [&](std::size_t i) {
    const Wrench& t = mesh.points[i].wrench.value;
    return std::array{t.fx, t.fy, t.m / mesh.length};
  };
  for (int i = 0; i < mesh.parallels; ++i) {
    for (int j = 0; j < mesh.meridians; ++j) {
      const LimitMesh::Cell cell = mesh.cell(i, j);
      const auto a = at(cell[0]), b = at(cell[1]), c = at(cell[2]);
      // The body holds the origin: the volume of the tetrahedron with it is positive.
      const double volume =
          a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
      EXPECT_GT(volume, 0) << i << ' ' << j;
    }
  }
}

// The largest |given - off| / error of forces and of moments, over the points and their slips.
std::pair<double, double> shares_of_error(const LimitMesh& given, const AnyPatch& off, double resistance) {
  double force = 0, moment = 0;
  for (const auto& [t, v] : given.points) {
    const Wrench g = off.gradient(v);
    force = std::max(force, std::hypot(t.value.fx - resistance * g.fx, t.value.fy - resistance * g.fy) / t.force_error);
    moment = std::max(moment, std::fabs(t.value.m - resistance * g.m) / t.moment_error);
  }
  return {force, moment};
}

// On half as many cells every point lies within its error, and not far within.
TEST(LimitMesh, ErrorsHoldThatOfTheGrid) {
  const LimitScene scene = read_limit_scene(TomlDocument::read(test::limit_folder / "wavy_cap.toml"),
                                            MaterialLibrary({test::data_folder / "materials"}));
  ASSERT_TRUE(scene.contact.coarse);
  const LimitMesh mesh = mesh_of(scene.contact, {0.8, 0}, 1e-3, 24, 16);
  const auto [force, moment] = shares_of_error(mesh, placed(*scene.contact.coarse, scene.contact.frame), 0.8);
  EXPECT_TRUE(force > 0.99 && force <= 1 + 1e-10) << force;
  EXPECT_TRUE(moment > 0.99 && moment <= 1 + 1e-10) << moment;
  // Pure rotation bears the greatest moment alone, whose error is told beside the loads.
  const auto results = answer_limit(scene).contact;
  const auto told = std::ranges::find(results, "greatest_moment_alone", &Result::name);
  ASSERT_NE(told, results.end());
  const auto& top = mesh.points.front().wrench;
  EXPECT_NEAR(top.value.m, told->value, 1e-3 * told->value);
  EXPECT_NEAR(top.moment_error, told->error, 0.1 * told->error);
}

// Of bodies, with errors of the shape far above rounding: what is off by as much lies within them.
TEST(LimitMesh, ErrorsHoldThatOfTheShape) {
  constexpr double delta = 1e-6;
  Contact disc = test::limit_scene(test::with(test::good_bodies, "[poles]\nlist = [[0.001, 0.002]]\n", "")).contact;
  const double radius = std::get<friction::HertzDisc>(disc.patch).radius();
  disc.radius_error = disc.shape_error = delta;
  const LimitMesh round = mesh_of(disc, {2, 0}, radius, 24, 16);
  const auto wider = shares_of_error(round, AnyPatch(friction::HertzDisc::of_radius(radius * (1 + delta))), 2);
  EXPECT_TRUE(wider.first > 0.99 && wider.first <= 1.001) << wider.first;
  EXPECT_TRUE(wider.second > 0.99 && wider.second <= 1.001) << wider.second;
  for (const auto& [t, v] : round.points) {
    if (v.w == 0) {
      EXPECT_LE(t.force_error, 1e-14);
    }
  }

  const auto ellipse = [](double scale) {
    return AnyPatch(friction::HertzEllipse::of_semi_axes(3e-3 * scale, 1e-3 * scale));
  };
  Contact oval{ellipse(1), {}, 1};
  oval.shape_error = delta;
  oval.extent = 3e-3;
  const auto larger = shares_of_error(mesh_of(oval, {2, 0}, 1e-3, 24, 16), ellipse(1 + delta), 2);
  EXPECT_TRUE(larger.first > 0.05 && larger.first <= 1.001) << larger.first;
  EXPECT_TRUE(larger.second > 0.05 && larger.second <= 1.001) << larger.second;
}

TEST(LimitMesh, ErrorsHoldThatOfTheResistance) {
  const Contact contact = test::limit_scene(l_shape).contact;
  const LimitMesh exact = mesh_of(contact, {2, 0}, 0.008, 24, 16), near = mesh_of(contact, {2, 2e-6}, 0.008, 24, 16);
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    const auto &a = exact.points[i].wrench, &b = near.points[i].wrench;
    EXPECT_NEAR(b.force_error - a.force_error, 1e-6 * std::hypot(a.value.fx, a.value.fy), 1e-14);
    EXPECT_NEAR(b.moment_error - a.moment_error, 1e-6 * std::fabs(a.value.m), 1e-14);
  }
}

TEST(SurfaceFiles, VtkHoldsTheMesh) {
  const LimitMesh mesh = meshed(l_shape).mesh;
  const VtkFile file = VtkFile::parse(to_vtk(mesh, "a title"));
  EXPECT_EQ(file.title, "a title");
  ASSERT_EQ(file.points.size(), mesh.points.size());
  ASSERT_EQ(file.polygons.size(), 16U * 24);
  for (const auto& polygon : file.polygons) {
    for (const std::size_t corner : polygon) EXPECT_LT(corner, file.points.size());
  }
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    EXPECT_EQ(file.points[i][0], mesh.points[i].wrench.value.fx + 0.0);
    EXPECT_EQ(file.points[i][2], mesh.points[i].wrench.value.m / mesh.length + 0.0);
    const auto& n = file.normals[i];
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-15);
    EXPECT_EQ(file.slips[i][2], mesh.points[i].slip.w + 0.0);
    EXPECT_GE(file.shares[i], 0);
    EXPECT_LE(file.shares[i], 1);
  }
  // The ends turn about the centroid, the equator slides.
  EXPECT_EQ(file.shares.front(), 0);
  EXPECT_EQ(file.shares[mesh.at(8, 3)], 1);
}

TEST(SurfaceFiles, VtkTitlesAreCutToWhatTheFormatAllows) {
  const std::string text = to_vtk(meshed(l_shape).mesh, std::string(400, 'x'));
  EXPECT_EQ(VtkFile::parse(text).title.size(), 255U);
}

TEST(SurfaceFiles, RowsSayPolesAndErrors) {
  const LimitMesh mesh = meshed(l_shape).mesh;
  const Table table = surface_rows(mesh, false);
  ASSERT_EQ(table.rows.size(), mesh.points.size());
  EXPECT_EQ(table.columns.front(), "force_x_N");
  // Pure rotation about the centroid of the L, (0.0125, 0.0075) m.
  EXPECT_NEAR(table.rows.front()[5], 0.0125, 1e-16);
  EXPECT_NEAR(table.rows.front()[6], 0.0075, 1e-16);
  const auto& translation = table.rows[mesh.at(8, 3)];
  EXPECT_TRUE(std::isinf(translation[5]));
  EXPECT_EQ(translation[9], 0);
  for (const auto& row : table.rows) {
    EXPECT_LE(row[3], 1e-12);
    EXPECT_GT(row[3], 0);
  }
  EXPECT_EQ(surface_rows(mesh, true).columns.front(), "force_x");
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

PictureRequest request_of(const LimitScene& scene) {
  return {scene.title, scene.surface.azimuth, scene.surface.elevation, capacity_of(scene).value,
          answer_limit(scene).loads};
}

TEST(SurfacePicture, ShowsTheHalfThatFacesTheViewer) {
  const LimitScene scene = test::limit_scene(l_shape);
  const LimitMesh mesh = meshed(l_shape).mesh;
  const std::string svg = picture_of(mesh, request_of(scene));
  EXPECT_TRUE(svg.starts_with("<svg xmlns="));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  const std::size_t cells = 24 * 16, legend = 80, faces = 3;
  const std::size_t drawn = count_of(svg, "<polygon") - legend - faces;
  EXPECT_NEAR(static_cast<double>(drawn), cells / 2., cells / 8.);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("a load that")));
}

TEST(SurfacePicture, MarksLoadsThatHoldAndLoadsThatSlip) {
  const LimitScene scene = test::limit_scene(l_shape +
                                             "[[loads]]\nforce = [0.1, 0.1]\n[[loads]]\nforce = [2.5, 0]\nat = "
                                             "[0.0125, 0.0075]\n[[loads]]\nforce = [50, 0]\n");
  const std::string svg = picture_of(meshed(l_shape).mesh, request_of(scene));
  // One circle for the load that holds, one for that which slips, none for that which is far outside, two in the key.
  EXPECT_EQ(count_of(svg, "<circle"), 4U);
  EXPECT_THAT(svg, HasSubstr("a load that slips"));
}

// In one direction all that hold leave at one point; the load of nothing has no mark, but keeps its number.
TEST(SurfacePicture, NumbersOfOneMarkStandTogether) {
  const std::string loads =
      "[[loads]]\nforce = { size = [0.1, 0.2], angle = 2.5 }\n[[loads]]\nmoment = 0\n"
      "[[loads]]\nforce = { size = [0.3, 0.4, 0.5], angle = 2.5 }\n[[loads]]\nmoment = 1\n";
  const LimitScene scene = test::limit_scene(l_shape + loads);
  const std::string svg = picture_of(meshed(l_shape).mesh, request_of(scene));
  EXPECT_THAT(svg, HasSubstr(">1, 2, 4-6</text>"));
  EXPECT_THAT(svg, HasSubstr(">7</text>"));
}

TEST(SurfacePicture, TellsUndecidedLoadsApart) {
  const std::string disc =
      "[contact]\npatch = \"uniform_disc\"\nradius = 0.006\nnormal_force = 5\n[friction]\nmu = 0.6\n";
  const LimitScene scene = test::limit_scene(disc + "[[loads]]\nforce = [3, 0]\n[[loads]]\nforce = [1, 0]\n");
  const PictureRequest request = request_of(scene);
  ASSERT_EQ(request.loads.at(0).verdict, Verdict::undecided);
  const std::string svg = picture_of(meshed(disc).mesh, request);
  EXPECT_THAT(svg, HasSubstr("a load, undecided"));
  EXPECT_THAT(svg, HasSubstr("a load that holds"));
  EXPECT_THAT(svg, Not(HasSubstr("a load that slips")));
  EXPECT_THAT(picture_of(meshed(disc).mesh, request_of(test::limit_scene(disc + "[[loads]]\nforce = [1, 0]\n"))),
              Not(HasSubstr("undecided")));
}

// Of loads side by side, as many as there is room for; the axes keep theirs.
TEST(SurfacePicture, NumbersDoNotTouch) {
  const LimitScene scene = test::limit_scene(
      l_shape + "[[loads]]\nforce = { size = 1, angle = { from = -3, to = -2, count = 60 } }\nmoment = 0.004\n");
  const std::string svg = picture_of(meshed(l_shape).mesh, request_of(scene));
  const std::regex number(
      R"re(<text x="(-?[\d.]+)" y="(-?[\d.]+)" font-size="2.82" text-anchor="(\w+)">([-\d., ]+)</text>)re");
  struct Area {
    std::string digits;
    double left, right, top, bottom;
  };
  std::vector<Area> areas;
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), number); it != std::sregex_iterator(); ++it) {
    const double x = std::stod((*it)[1]), y = std::stod((*it)[2]);
    const double width = 1.8 * static_cast<double>((*it)[4].length());
    const double left = (*it)[3] == "start" ? x : (*it)[3] == "end" ? x - width : x - width / 2;
    if (y < 95) areas.push_back({(*it)[4], left, left + width, y - 2, y});  // above the scale of colours
  }
  EXPECT_GT(areas.size(), 15U);
  EXPECT_LT(areas.size(), 60U);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Area &a = areas[i], &b = areas[j];
      EXPECT_TRUE(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top)
          << a.digits << " on " << b.digits;
    }
  }
  EXPECT_THAT(svg, HasSubstr(">1</text>"));
  EXPECT_THAT(svg, HasSubstr("a load that holds"));
  EXPECT_THAT(svg, Not(HasSubstr("a load that slips")));
}

TEST(SurfacePicture, EverythingStaysOnThePage) {
  for (const char* view : {"azimuth = 0\nelevation = 0", "azimuth = 2.5\nelevation = 1.5707963267948966",
                           "azimuth = -2\nelevation = -0.7"}) {
    const LimitScene scene =
        test::limit_scene(l_shape + "[surface.view]\n" + view + "\n[[loads]]\nforce = [2.5, 0]\nmoment = 1\n");
    const std::string svg = picture_of(meshed(l_shape).mesh, request_of(scene));
    const std::regex pair(R"((-?[\d.]+),(-?[\d.]+) ?)");
    std::size_t spots = 0;
    for (auto it = std::sregex_iterator(svg.begin(), svg.end(), pair); it != std::sregex_iterator(); ++it, ++spots) {
      const double x = std::stod((*it)[1]), y = std::stod((*it)[2]);
      EXPECT_TRUE(x >= 0 && x <= 120 && y >= 0 && y <= 110) << view << ": " << it->str();
    }
    EXPECT_GT(spots, 1000U);
  }
}

TEST(SurfacePicture, TitlesAreText) {
  const LimitScene scene = test::limit_scene("title = \"a < b & *c_d*\"\n" + l_shape);
  EXPECT_THAT(picture_of(meshed(l_shape).mesh, request_of(scene)), HasSubstr("a &lt; b &amp; *c_d*"));
}

TEST(SurfacePicture, WithoutFrictionForcesArePerMuF) {
  LimitScene scene = test::limit_scene(test::with(l_shape, "[friction]\nmu = 0.5\n", ""));
  PictureRequest request = request_of(scene);
  request.capacity.reset();
  const std::string svg = picture_of(meshed(l_shape, 1).mesh, request);
  EXPECT_THAT(svg, HasSubstr("µ"));
}

}  // namespace
}  // namespace patchgrip::cli
