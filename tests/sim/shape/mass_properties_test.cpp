#include "sim/shape/mass_properties.h"

#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/shape/object_generator.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

using test::moved;
using test::turned_over;

TEST(MassProperties, OfABoxAreItsClosedForm) {
  const MassProperties mass = mass_properties(moved(make_box({0.1, 0.2, 0.3}, 3), {1, 2, 3}));
  EXPECT_EQ(mass.source, MassSource::signed_volume);
  EXPECT_NEAR(mass.volume, 0.006, 1e-15);
  EXPECT_TRUE(mass.center_of_mass.isApprox(Vector3(1, 2, 3), 1e-14));
  const Vector3 inertia(0.04 + 0.09, 0.01 + 0.09, 0.01 + 0.04);
  EXPECT_TRUE(mass.unit_inertia.isApprox(Matrix3((inertia / 12.0).asDiagonal()), 1e-12));
}

TEST(MassProperties, OfAFineBallAreThoseOfTheBall) {
  const MassProperties mass = mass_properties(make_sphere(0.1, 6));
  EXPECT_NEAR(mass.volume, 4.0 / 3.0 * std::numbers::pi * 1e-3, 1e-6);
  EXPECT_TRUE(mass.unit_inertia.isApprox(Matrix3(0.4 * 0.01 * Matrix3::Identity()), 1e-3));
}

TEST(MassProperties, OfATetrahedronHaveItsMeanForCentre) {
  const TriangleMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}},
                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  const MassProperties mass = mass_properties(tetrahedron);
  EXPECT_NEAR(mass.volume, 1.0, 1e-14);
  EXPECT_TRUE(mass.center_of_mass.isApprox(Vector3(0.25, 0.5, 0.75), 1e-14));
  // Spread (x - mean)(y - mean) of a corner tetrahedron: 3/80 a^2 and -1/80 a b.
  EXPECT_NEAR(mass.unit_inertia(0, 0), 3.0 / 80.0 * (4.0 + 9.0), 1e-13);
  EXPECT_NEAR(mass.unit_inertia(0, 1), 1.0 / 80.0 * 1.0 * 2.0, 1e-13);
}

class MassOfObject : public testing::TestWithParam<std::string> {};

TEST_P(MassOfObject, MovesAndTurnsWithTheObject) {
  const TriangleMesh mesh = generate_object(GetParam(), 2000);
  const MassProperties mass = mass_properties(mesh);
  EXPECT_EQ(mass.source, MassSource::signed_volume);
  EXPECT_TRUE(mass.unit_inertia.isApprox(mass.unit_inertia.transpose(), 1e-14));
  for (const double far : {0.0, 1.0, 1000.0}) {
    const Matrix3 R = Eigen::AngleAxisd(0.3 + far, Vector3(1, 2, -3).normalized()).matrix();
    const Pose X = pose_from(R, far * Vector3(1, -2, 3));
    const MassProperties other = mass_properties(transformed(mesh, X));
    // Coordinates lose far / size of their digits.
    const double digits = 1e-12 * (1.0 + far / 0.01);
    EXPECT_NEAR(other.volume, mass.volume, mass.volume * digits);
    EXPECT_NEAR((other.center_of_mass - X * mass.center_of_mass).norm(), 0.0, digits);
    EXPECT_TRUE(other.unit_inertia.isApprox(R * mass.unit_inertia * R.transpose(), digits));
  }
}

TEST_P(MassOfObject, GrowsWithThePowersOfScale) {
  const TriangleMesh mesh = generate_object(GetParam(), 2000);
  const MassProperties mass = mass_properties(mesh);
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
    const MassProperties other = mass_properties(test::scaled(mesh, scale));
    EXPECT_EQ(other.source, mass.source);
    EXPECT_NEAR(other.volume / std::pow(scale, 3), mass.volume, 1e-12 * mass.volume);
    EXPECT_TRUE(other.center_of_mass.isApprox(scale * mass.center_of_mass, 1e-9));
    EXPECT_TRUE(other.unit_inertia.isApprox(scale * scale * mass.unit_inertia, 1e-10));
  }
}

TEST_P(MassOfObject, DoesNotDependOnTheWinding) {
  const TriangleMesh mesh = generate_object(GetParam(), 2000);
  TriangleMesh shuffled = mesh;
  for (std::size_t t = 0; t < shuffled.triangles.size(); t += 3) {
    std::swap(shuffled.triangles[t][0], shuffled.triangles[t][1]);
  }
  const MassProperties mass = mass_properties(mesh);
  for (const TriangleMesh& other : {turned_over(mesh), shuffled}) {
    const MassProperties same = mass_properties(other);
    EXPECT_EQ(same.source, MassSource::signed_volume);
    EXPECT_NEAR(same.volume, mass.volume, 1e-12 * mass.volume);
  }
}

INSTANTIATE_TEST_SUITE_P(All, MassOfObject, testing::ValuesIn(generated_object_names()),
                         [](const auto& object) { return object.param; });

TEST(MassProperties, SubtractACavity) {
  TriangleMesh hollow = make_box({1, 1, 1});
  append(hollow, turned_over(make_box({0.8, 0.8, 0.8})));
  EXPECT_NEAR(mass_properties(hollow).volume, 1.0 - 0.512, 1e-12);
}

TEST(MassProperties, CloseASmallHoleAndSaySo) {
  TriangleMesh box = make_box({1, 1, 1}, 4);
  box.triangles.erase(box.triangles.begin() + 17);
  const MassProperties mass = mass_properties(box);
  EXPECT_EQ(mass.source, MassSource::closed_holes);
  EXPECT_NEAR(mass.volume, 1.0, 1e-12);
  EXPECT_TRUE(mass.center_of_mass.isZero(1e-12));
}

TEST(MassProperties, OfABoxWithoutALidAreThoseOfTheBox) {
  TriangleMesh box = make_box({1, 1, 1});
  box.triangles.resize(10);
  const MassProperties mass = mass_properties(box);
  EXPECT_EQ(mass.source, MassSource::closed_holes);
  EXPECT_NEAR(mass.volume, 1.0, 1e-12);
}

TEST(MassProperties, OfScrapsAreThoseOfTheHull) {
  // Three faces of a box reach around all of it.
  TriangleMesh scraps = make_box({1, 2, 3});
  scraps.triangles = {scraps.triangles[0], scraps.triangles[3], scraps.triangles[6],
                      scraps.triangles[9]};
  const MassProperties mass = mass_properties(scraps);
  EXPECT_EQ(mass.source, MassSource::convex_hull);
  EXPECT_GT(mass.volume, 0.9);
  EXPECT_LE(mass.volume, 6.0);
}

TEST(MassProperties, OfASheetAreThoseOfThePlate) {
  const TriangleMesh sheet{{{0, 0, 5}, {2, 0, 5}, {2, 1, 5}, {0, 1, 5}}, {{0, 1, 2}, {0, 2, 3}}};
  const MassProperties mass = mass_properties(sheet);
  EXPECT_EQ(mass.source, MassSource::surface);
  EXPECT_EQ(mass.volume, 0.0);
  EXPECT_TRUE(mass.center_of_mass.isApprox(Vector3(1, 0.5, 5), 1e-14));
  const Vector3 inertia(1.0 / 12.0, 4.0 / 12.0, 5.0 / 12.0);
  EXPECT_TRUE(mass.unit_inertia.isApprox(Matrix3(inertia.asDiagonal()), 1e-13));
}

TEST(MassProperties, IgnoreVerticesOfNoTriangle) {
  TriangleMesh scraps = make_box({1, 2, 3});
  scraps.triangles.resize(4);
  const MassProperties mass = mass_properties(scraps);
  scraps.vertices.push_back({100, 100, 100});
  EXPECT_EQ(mass_properties(scraps).volume, mass.volume);
}

TEST(MassProperties, RefuseAMeshOfNoArea) {
  EXPECT_THROW(mass_properties({}), InputError);
  EXPECT_THROW(mass_properties({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}), InputError);
}

// Areas are compared with the size of the whole: what is too small beside it has none.
TEST(MassProperties, OfThinThingsFarApartAreFiniteOrRefused) {
  for (const double thin : {1e-3, 1e-30, 1e-100, 1e-160, 1e-300}) {
    for (const double far : {1.0, 1e6, 1e13, 1e100}) {
      SCOPED_TRACE(testing::Message() << thin << " m thin, " << far << " m apart");
      TriangleMesh mesh = make_box({0.08, 0.04, thin});
      append(mesh, transformed(mesh, translation({far, 0.0, 0.0})));
      try {
        const MassProperties mass = mass_properties(mesh);
        EXPECT_TRUE(std::isfinite(mass.volume) && mass.center_of_mass.allFinite() &&
                    mass.unit_inertia.allFinite());
      } catch (const InputError& error) {
        EXPECT_GT(far, 1e6) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace prehend
