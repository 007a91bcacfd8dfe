// A reader of legacy VTK files, as strict as the format: keyword, count, that many numbers.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace patchgrip::cli::test {

struct VtkFile {
  static VtkFile parse(const std::string& text) {
    std::istringstream in(text);
    VtkFile file;
    std::string line, word;
    std::getline(in, line);
    EXPECT_EQ(line, "# vtk DataFile Version 3.0");
    std::getline(in, file.title);
    std::getline(in, line);
    EXPECT_EQ(line, "ASCII");
    std::getline(in, line);
    EXPECT_EQ(line, "DATASET POLYDATA");
    std::size_t count = 0, size = 0;
    in >> word >> count >> line;
    EXPECT_EQ(word, "POINTS");
    file.points.resize(count);
    for (auto& p : file.points) in >> p[0] >> p[1] >> p[2];
    in >> word >> count >> size;
    EXPECT_EQ(word, "POLYGONS");
    std::size_t read = 0;
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t corners = 0;
      in >> corners;
      std::vector<std::size_t> polygon(corners);
      for (auto& corner : polygon) in >> corner;
      read += corners + 1;
      file.polygons.push_back(polygon);
    }
    EXPECT_EQ(read, size);
    in >> word >> count;
    EXPECT_EQ(word, "POINT_DATA");
    EXPECT_EQ(count, file.points.size());
    for (auto* const vectors : {&file.normals, &file.slips}) {
      std::string name, type;
      in >> word >> name >> type;
      vectors->resize(count);
      for (auto& v : *vectors) in >> v[0] >> v[1] >> v[2];
    }
    std::string rest;
    std::getline(in >> std::ws, rest);
    EXPECT_EQ(rest, "SCALARS pole_share double 1");
    std::getline(in, rest);
    EXPECT_EQ(rest, "LOOKUP_TABLE default");
    file.shares.resize(count);
    for (double& share : file.shares) in >> share;
    EXPECT_TRUE(in);
    EXPECT_TRUE((in >> std::ws).eof());
    return file;
  }

  std::string title;
  std::vector<std::array<double, 3>> points, normals, slips;
  std::vector<std::vector<std::size_t>> polygons;
  std::vector<double> shares;
};

}  // namespace patchgrip::cli::test
