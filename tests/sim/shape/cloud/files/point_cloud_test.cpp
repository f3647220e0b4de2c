// PLY and PCD clouds in every encoding give the numbers that were written.
#include "sim/shape/cloud/files/point_cloud.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/cloud/files/lzf.h"
#include "tests/sim/shape/cloud/files/written_cloud.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

using test::Column;
using test::refusal_of;

constexpr std::size_t kCount = 300;

// Whole numbers, which every type holds, and others where the type is a real one.
std::vector<double> some_values(char type, int size, Random& random) {
  std::vector<double> values;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double whole = std::floor(random.uniform(0.0, 100.0));
    values.push_back(type == 'F' ? static_cast<double>(static_cast<float>(random.uniform()))
                                 : whole);
    if (i % 7 == 0) values.back() = 1.0;  // repeats, which are compressed
  }
  (void)size;
  return values;
}

// Columns in an order that is no rule, with colours between.
std::vector<Column> mixed_columns(bool eight_byte_integers) {
  Random random(7);
  std::vector<Column> columns = {{"intensity", 'U', 1, {}}, {"z", 'F', 8, {}},
                                 {"normal_y", 'F', 4, {}},  {"x", 'I', 2, {}},
                                 {"rgb", 'U', 4, {}},       {"normal_x", 'F', 8, {}},
                                 {"y", 'F', 4, {}},         {"ring", 'U', 2, {}},
                                 {"normal_z", 'F', 4, {}},  {"label", 'I', 1, {}}};
  if (eight_byte_integers) {
    columns.push_back({"time", 'U', 8, {}});
    columns.push_back({"_", 'U', 1, {}});
    columns.push_back({"frame", 'I', 8, {}});
  }
  for (Column& column : columns) column.values = some_values(column.type, column.size, random);
  return columns;
}

const Column& named(const std::vector<Column>& columns, const std::string& name) {
  for (const Column& column : columns) {
    if (column.name == name) return column;
  }
  throw std::logic_error(name);
}

void expect_same(const PointCloud& cloud, const std::vector<Column>& columns) {
  ASSERT_EQ(cloud.points.size(), kCount);
  ASSERT_EQ(cloud.normals.size(), kCount);
  const char* const points[3] = {"x", "y", "z"};
  const char* const normals[3] = {"normal_x", "normal_y", "normal_z"};
  for (int k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < kCount; ++i) {
      // Nine digits of text give the same float.
      EXPECT_EQ(cloud.points[i][k], static_cast<float>(named(columns, points[k]).values[i]));
      EXPECT_EQ(cloud.normals[i][k], static_cast<float>(named(columns, normals[k]).values[i]));
    }
  }
}

TEST(PointClouds, PcdInEveryEncoding) {
  const std::vector<Column> columns = mixed_columns(true);
  for (const char* data : {"ascii", "binary", "binary_compressed"}) {
    SCOPED_TRACE(data);
    const PointCloud cloud = read_pcd(test::pcd_file(columns, data, 20, "1 2 3 0 1 0 0"));
    expect_same(cloud, columns);
    EXPECT_EQ(cloud.width, 20U);
    EXPECT_EQ(cloud.height, kCount / 20);
    ASSERT_TRUE(cloud.X_FV);
    EXPECT_EQ(cloud.X_FV->translation(), Vector3(1.0, 2.0, 3.0));
    EXPECT_TRUE(
        cloud.X_FV->linear().isApprox(Vector3(1.0, -1.0, -1.0).asDiagonal().toDenseMatrix()));
  }
}

TEST(PointClouds, PlyInEveryEncoding) {
  std::vector<Column> columns = mixed_columns(false);
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    SCOPED_TRACE(format);
    std::vector<Column> in_ply = columns;
    for (Column& column : in_ply) {
      if (column.name.starts_with("normal_")) column.name = "n" + column.name.substr(7);
    }
    const PointCloud cloud = read_ply_cloud(test::ply_file(in_ply, format));
    expect_same(cloud, columns);
    EXPECT_FALSE(cloud.X_FV);
    EXPECT_EQ(cloud.height, 1U);
  }
}

TEST(PointClouds, WhatIsNotANumberStays) {
  std::vector<Column> columns = test::columns_of({{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}});
  columns[1].values[0] = std::numeric_limits<double>::quiet_NaN();
  columns[2].values[1] = std::numeric_limits<double>::infinity();
  for (const char* data : {"ascii", "binary", "binary_compressed"}) {
    const PointCloud cloud = read_pcd(test::pcd_file(columns, data));
    EXPECT_TRUE(std::isnan(cloud.points[0].y())) << data;
    EXPECT_TRUE(std::isinf(cloud.points[1].z())) << data;
  }
  const PointCloud cloud = read_ply_cloud(test::ply_file(columns, "ascii"));
  EXPECT_TRUE(std::isnan(cloud.points[0].y()));
}

TEST(PointClouds, LzfOfManyTexts) {
  Random random(3);
  for (int n = 0; n < 200; ++n) {
    std::string text;
    const double letters = random.uniform(1.0, 5.0);
    for (int i = 0; i < 10 * n; ++i) {
      text.push_back(static_cast<char>('a' + static_cast<int>(random.uniform(0.0, letters))));
    }
    EXPECT_EQ(decompressed_lzf(test::compressed_lzf(text), text.size()), text);
  }
}

TEST(PointClouds, DamagedLzfIsRefused) {
  const std::string text(1000, 'x');
  const std::string packed = test::compressed_lzf(text);
  for (const std::size_t size :
       {std::size_t{0}, text.size() - 1, text.size() + 1, std::size_t{1} << 40U}) {
    EXPECT_STREQ(refusal_of([&] { decompressed_lzf(packed, size); }).what(),
                 "the compressed points are damaged");
  }
  for (std::size_t length = 0; length < packed.size(); ++length) {
    EXPECT_THROW(decompressed_lzf(packed.substr(0, length), text.size()), InputError);
  }
  // Further back than the beginning.
  EXPECT_THROW(decompressed_lzf(std::string("\x20\x05", 2), 3), InputError);
}

std::string pcd_refusal(const std::string& bytes) {
  return refusal_of([&] { read_pcd(bytes); }).what();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  text.replace(text.find(what), what.size(), by);
  return text;
}

TEST(PointClouds, BadPcdIsRefused) {
  const std::string good = test::pcd_file(test::columns_of({{1, 2, 3}, {4, 5, 6}}), "ascii");
  EXPECT_EQ(read_pcd(good).points.size(), 2U);
  EXPECT_EQ(pcd_refusal("solid"), "no PCD file: no line DATA ends its header");
  EXPECT_EQ(pcd_refusal(replaced(good, "x y z", "x y w")),
            "FIELDS must have one x, one y and one z, and a normal at most");
  EXPECT_EQ(pcd_refusal(replaced(good, "DATA ascii", "DATA lzma")),
            "line 11: DATA must be ascii, binary or binary_compressed ('lzma')");
  EXPECT_EQ(pcd_refusal(replaced(good, "POINTS 2", "POINTS 3")),
            "WIDTH x HEIGHT are 2 x 1, POINTS 3");
  EXPECT_EQ(pcd_refusal(replaced(good, "4 5", "4 five")), "line 13: not a number ('five')");
  EXPECT_EQ(pcd_refusal(replaced(good, "4 5 6", "")), "the file ends after 1 of 2 points");
  EXPECT_EQ(pcd_refusal(replaced(good, "0 0 0 1 0 0 0", "0 0 0 0 0 0 0")),
            "line 9: the quaternion of VIEWPOINT is not unit");
  EXPECT_EQ(pcd_refusal(replaced(good, "SIZE 4", "SIZE 3")), "line 4: a SIZE must be 1, 2, 4 or 8");
  const std::string many =
      replaced(replaced(good, "WIDTH 2", "WIDTH 20000000"), "POINTS 2", "POINTS 20000000");
  EXPECT_EQ(pcd_refusal(many), "more points than the 10,000,000 that are read together (20000000)");
  for (const char* data : {"binary", "binary_compressed"}) {
    const std::string whole =
        test::pcd_file(test::columns_of({{1, 2, 3}, {4, 5, 6}, {1, 2, 3}}), data);
    for (std::size_t cut = 1; cut <= 20; ++cut) {
      EXPECT_THROW(read_pcd(whole.substr(0, whole.size() - cut)), InputError) << data << cut;
    }
  }
}

TEST(PointClouds, BadPlyIsRefused) {
  const std::string good = test::ply_file(test::columns_of({{1, 2, 3}, {4, 5, 6}}), "ascii");
  EXPECT_EQ(read_ply_cloud(good).points.size(), 2U);
  const auto why = [](const std::string& bytes) {
    return std::string(refusal_of([&] { read_ply_cloud(bytes); }).what());
  };
  EXPECT_EQ(why(replaced(good, "property float x", "property float w")),
            "element vertex must have one x, one y and one z, and a normal at most");
  EXPECT_EQ(why(replaced(good, "element vertex", "element corner")),
            "no points: there is no element vertex");
  EXPECT_EQ(why(replaced(good, "vertex 2", "vertex 20000")),
            "line 4: promises 20000 of element 'vertex', more than the file can hold");
  EXPECT_EQ(why(replaced(good, "4 5 6", "4 5")),
            "line 12: the file ends inside element 'vertex' (2 promised)");
}

}  // namespace
}  // namespace prehend
