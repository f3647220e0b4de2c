#include "sim/shape/object_generator.h"

#include <string>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/shape/mass_properties.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

using test::expect_outward_solid;

class GeneratedObject : public testing::TestWithParam<std::string> {};

TEST_P(GeneratedObject, IsAnOutwardSolidAtAnyDensity) {
  for (const int wanted : {1, 30, 200, 1000, 5000, 20000}) {
    SCOPED_TRACE(wanted);
    const TriangleMesh mesh = generate_object(GetParam(), wanted);
    expect_outward_solid(mesh);
    EXPECT_EQ(test::euler_characteristic(mesh), GetParam() == "mug" ? 0 : 2);
  }
}

TEST_P(GeneratedObject, HasRoughlyTheTrianglesAskedFor) {
  for (const int wanted : {1000, 5000, 20000, 60000}) {
    const int made = static_cast<int>(generate_object(GetParam(), wanted).triangles.size());
    EXPECT_NEAR(made, wanted, 0.25 * wanted);
  }
}

TEST_P(GeneratedObject, StandsOnThePlaneWithItsBodyOnTheAxis) {
  const Bounds box = bounds(generate_object(GetParam()));
  EXPECT_NEAR(box.lower.z(), 0.0, 1e-12);
  // A ring need not have a vertex on each axis.
  EXPECT_NEAR(box.lower.y(), -box.upper.y(), 0.001);
  if (GetParam() != "mug") {
    EXPECT_NEAR(box.lower.x(), -box.upper.x(), 0.001);
  }
}

TEST_P(GeneratedObject, HasNoSlivers) {
  EXPECT_LT(test::worst_aspect(generate_object(GetParam(), 5000)), 10.0);
  EXPECT_LT(test::worst_aspect(generate_object(GetParam(), 20000)), 10.0);
}

TEST_P(GeneratedObject, IsTheSameEveryTime) {
  const TriangleMesh first = generate_object(GetParam(), 3000);
  const TriangleMesh second = generate_object(GetParam(), 3000);
  EXPECT_EQ(first.triangles, second.triangles);
  EXPECT_EQ(first.vertices, second.vertices);
}

TEST_P(GeneratedObject, KeepsItsVolumeWithDensity) {
  const double coarse = signed_volume(generate_object(GetParam(), 5000));
  const double fine = signed_volume(generate_object(GetParam(), 50000));
  EXPECT_NEAR(coarse, fine, 0.02 * fine);
}

INSTANTIATE_TEST_SUITE_P(All, GeneratedObject, testing::ValuesIn(generated_object_names()),
                         [](const auto& object) { return object.param; });

TEST(Mug, IsAsWideAndHighAsStated) {
  const Bounds box = bounds(generate_object("mug", 20000));
  EXPECT_NEAR(box.size().y(), 0.104, 1e-4);
  EXPECT_NEAR(box.lower.x(), -0.052, 1e-4);
  EXPECT_NEAR(box.upper.x(), 0.085, 1e-4);
  EXPECT_NEAR(box.size().z(), 0.105, 1e-12);
}

TEST(Mug, HoldsCoffee) {
  // Mostly air: a solid body would have four times the volume.
  const TriangleMesh mug = generate_object("mug", 20000);
  const MassProperties mass = mass_properties(mug);
  const double body = 3.14159265 * 0.052 * 0.052 * 0.105;
  EXPECT_LT(mass.volume, 0.25 * body);
  // The handle pulls the centre of mass to +x, and only there.
  EXPECT_GT(mass.center_of_mass.x(), 0.002);
  EXPECT_NEAR(mass.center_of_mass.y(), 0.0, 1e-5);
}

TEST(Cylinder, IsTheSoupCan) {
  const MassProperties mass = mass_properties(generate_object("cylinder", 50000));
  EXPECT_NEAR(mass.volume, 3.14159265 * 0.034 * 0.034 * 0.102, 1e-6);
}

TEST(Generator, RefusesUnknownNamesAndListsTheKnown) {
  try {
    generate_object("teapot");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("teapot"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("wine_glass"), std::string::npos);
  }
  EXPECT_THROW(generate_object("mug", 0), InputError);
  EXPECT_THROW(generate_object("mug", 2'000'001), InputError);
}

}  // namespace
}  // namespace prehend
