#include <patchgrip/contact/triangle_mesh.h>

#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/ellipsoid_mesh.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::ellipsoid_mesh;
using patchgrip::testing::uniform;
using ::testing::AllOf;
using ::testing::HasSubstr;

auto refused(const auto& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

class MeshFile : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& content) {
    std::filesystem::create_directories(folder_);
    const auto path = folder_ / name;
    std::ofstream(path, std::ios::binary) << content;
    return path.string();
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("patchgrip_mesh_" + std::to_string(::getpid()) + "_" +
                                                ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

const auto ball = ellipsoid_mesh(2, 1, 1, 1);

std::string off() {
  std::ostringstream out;
  out.precision(17);
  out << "OFF\n" << ball.vertices.size() << " " << ball.triangles.size() << " 0\n";
  for (const auto& v : ball.vertices) out << v[0] << " " << v[1] << " " << v[2] << "\n";
  for (const auto& t : ball.triangles) out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  return out.str();
}

std::string ply() {
  std::ostringstream out;
  out.precision(17);
  out << "ply\nformat ascii 1.0\nelement vertex " << ball.vertices.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << ball.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& v : ball.vertices) out << v[0] << " " << v[1] << " " << v[2] << "\n";
  for (const auto& t : ball.triangles) out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  return out.str();
}

std::string binary_stl() {
  std::string out(80, ' ');
  const auto put = [&](const auto& value) {
    std::array<char, sizeof(value)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(value));
    out.append(bytes.data(), bytes.size());
  };
  put(static_cast<std::uint32_t>(ball.triangles.size()));
  for (const auto& t : ball.triangles) {
    for (int i = 0; i < 3; ++i) put(0.f);
    for (const std::size_t corner : t) {
      for (const double x : ball.vertices[corner]) put(static_cast<float>(x));
    }
    put(std::uint16_t{0});
  }
  return out;
}

TEST_F(MeshFile, KnownKindsGiveTheSameMesh) {
  for (const auto& [name, content] :
       {std::pair{"ball.off", off()}, std::pair{"ball.ply", ply()}, std::pair{"ball.STL", binary_stl()}}) {
    const auto mesh = TriangleMesh::read(write(name, content));
    EXPECT_EQ(mesh.vertices().size(), ball.vertices.size()) << name;
    EXPECT_EQ(mesh.triangles().size(), ball.triangles.size()) << name;
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
      const Vector n = mesh.normal(i), v = mesh.vertices()[mesh.triangles()[i][0]];
      EXPECT_GT(n[0] * v[0] + n[1] * v[1] + n[2] * v[2], 0.9) << name;
    }
  }
}

TEST_F(MeshFile, BadFilesAreNamedWithWhatIsWrong) {
  EXPECT_THAT([] { TriangleMesh::read("/nowhere/ball.off"); }, refused("mesh file /nowhere/ball.off cannot be opened"));
  const auto reading = [&](const std::string& name, const std::string& content) {
    const std::string file = write(name, content);
    return [file] { TriangleMesh::read(file); };
  };
  EXPECT_THAT(reading("a.off", ""), refused(HasSubstr("a.off is empty")));
  EXPECT_THAT(reading("a.obj", off()), refused(HasSubstr("unknown kind")));
  EXPECT_THAT(reading("a.off", "hello"), refused(HasSubstr("mesh file")));
  EXPECT_THAT(reading("b.off", off().substr(0, 3000)), refused(HasSubstr("cut off or not a mesh")));
  EXPECT_THAT(reading("a.ply", ply().substr(0, 3000)), refused(HasSubstr("mesh file")));
  EXPECT_THAT(reading("a.stl", binary_stl().substr(0, 2000)), refused(HasSubstr("mesh file")));
  EXPECT_THAT(reading("c.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"),
              refused(HasSubstr("a face with 4 corners: triangles only")));
  EXPECT_THAT(reading("d.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"),
              refused(AllOf(HasSubstr("d.off does not hold a surface"), HasSubstr("triangle 0 has no area"))));
  EXPECT_THAT(reading("e.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n2 0 0\n"), refused(HasSubstr("has no triangles")));
}

// Whatever is cut off or overwritten, the answer is a mesh or a refusal.
TEST_F(MeshFile, DamagedFilesNeverPassAsSomethingElse) {
  std::mt19937_64 engine(20060310);
  for (const auto& [name, content] :
       {std::pair{"ball.off", off()}, std::pair{"ball.ply", ply()}, std::pair{"ball.stl", binary_stl()}}) {
    for (int i = 0; i < cases(30); ++i) {
      std::string damaged = content;
      const auto at = [&] { return static_cast<std::size_t>(uniform(engine, 0, static_cast<double>(content.size()))); };
      if (i % 2 == 0) {
        damaged.resize(at());
      } else {
        damaged[std::max<std::size_t>(at(), 200)] = static_cast<char>(uniform(engine, 32, 127));
      }
      const std::string file = write(name, damaged);
      try {
        const auto mesh = TriangleMesh::read(file);
        for (const auto& v : mesh.vertices()) EXPECT_TRUE(std::isfinite(v[0] + v[1] + v[2]));
      } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), HasSubstr(name));
      }
    }
  }
}

TEST(TriangleMesh, WhatIsNotASurfaceIsRefused) {
  const std::vector<Vector> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_NO_THROW(TriangleMesh::of(square, {{0, 1, 2}, {0, 2, 3}}));
  EXPECT_THAT([&] { TriangleMesh::of(square, {}); }, refused(HasSubstr("mesh has no triangles")));
  EXPECT_THAT([&] { TriangleMesh::of(square, {{0, 1, 4}}); }, refused(HasSubstr("has corner 4")));
  EXPECT_THAT([&] { TriangleMesh::of(square, {{0, 1, 1}}); }, refused(HasSubstr("no area")));
  EXPECT_THAT(
      [&] {
        TriangleMesh::of(square, {{0, 1, 2}, {0, 3, 2}});
      },
      refused(HasSubstr("triangles 0 and 1 see their edge in the same direction")));
  EXPECT_THAT(
      [&] {
        TriangleMesh::of({{0, 0, 0}, {1, 0, 0}, {NAN, 1, 0}}, {{0, 1, 2}});
      },
      refused("vertex 2 is not finite"));
}

TEST(TriangleMesh, InsideOutIsTurnedBack) {
  auto turned = ball.triangles;
  for (auto& t : turned) std::swap(t[1], t[2]);
  const auto mesh = TriangleMesh::of(ball.vertices, turned);
  EXPECT_EQ(mesh.triangles(), TriangleMesh::of(ball.vertices, ball.triangles).triangles());
}

TEST(TriangleMesh, KnowsItsBorder) {
  const auto mesh = TriangleMesh::of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                                     {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
  EXPECT_FALSE(mesh.on_border(0));
  EXPECT_EQ(mesh.neighbours(0).size(), 4U);
  for (const std::size_t i : {1U, 2U, 3U, 4U}) {
    EXPECT_TRUE(mesh.on_border(i));
    EXPECT_EQ(mesh.neighbours(i).size(), 3U);
  }
}

TEST(TriangleMesh, ClosestPointIsNoFartherThanAnyOther) {
  std::mt19937_64 engine(20060311);
  const auto mesh = TriangleMesh::of(ball.vertices, ball.triangles);
  const auto distance = [](const Vector& p, const Vector& q) {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  for (int i = 0; i < cases(200); ++i) {
    const Vector from{uniform(engine, -2, 2), uniform(engine, -2, 2), uniform(engine, -2, 2)};
    const auto closest = mesh.closest_to(from);
    EXPECT_NEAR(distance(closest.point, from), closest.distance, 1e-15);
    for (int k = 0; k < 50; ++k) {
      const auto& t = mesh.triangles()[static_cast<std::size_t>(uniform(engine, 0, 320))];
      double r = uniform(engine, 0, 1), s = uniform(engine, 0, 1);
      if (r + s > 1) r = 1 - r, s = 1 - s;
      Vector other{};
      for (std::size_t x = 0; x < 3; ++x) {
        other[x] = (1 - r - s) * mesh.vertices()[t[0]][x] + r * mesh.vertices()[t[1]][x] + s * mesh.vertices()[t[2]][x];
      }
      EXPECT_LE(closest.distance, distance(other, from) + 1e-15);
    }
  }
}

}  // namespace
}  // namespace patchgrip::contact
