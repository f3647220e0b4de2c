// The table of friction coefficients.
#include "sim/scene/friction_table.h"

#include <limits>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

TEST(FrictionTable, HasThePublishedStaticCoefficients) {
  // Static friction between GraspIt!'s five default materials, in the order of kAll<Material>.
  constexpr double kPublished[5][5] = {{0.2, 0.2, 0.2, 0.3, 1.0},
                                       {0.2, 0.2, 0.2, 0.3, 1.0},
                                       {0.2, 0.2, 0.3, 0.4, 1.0},
                                       {0.3, 0.3, 0.4, 0.4, 1.0},
                                       {1.0, 1.0, 1.0, 1.0, 2.0}};
  const FrictionTable table;
  for (std::size_t a = 0; a < kAll<Material>.size(); ++a) {
    for (std::size_t b = 0; b < kAll<Material>.size(); ++b) {
      EXPECT_EQ(table.between(kAll<Material>[a], kAll<Material>[b]), kPublished[a][b])
          << name_of(kAll<Material>[a]) << " " << name_of(kAll<Material>[b]);
    }
  }
}

TEST(FrictionTable, IsSymmetricAlsoWhenChanged) {
  FrictionTable table;
  table.set(Material::glass, Material::rubber, 0.75);
  table.set(Material::wood, Material::wood, 0.0);
  EXPECT_EQ(table.between(Material::glass, Material::rubber), 0.75);
  EXPECT_EQ(table.between(Material::rubber, Material::glass), 0.75);
  EXPECT_EQ(table.between(Material::wood, Material::wood), 0.0);
  EXPECT_EQ(table.between(Material::glass, Material::glass), 0.2);
  for (const Material a : kAll<Material>) {
    for (const Material b : kAll<Material>) EXPECT_EQ(table.between(a, b), table.between(b, a));
  }
}

std::string refusal(double friction) {
  FrictionTable table;
  try {
    table.set(Material::rubber, Material::metal, friction);
  } catch (const InputError& error) {
    EXPECT_EQ(table.between(Material::metal, Material::rubber), 1.0) << "changed all the same";
    return error.what();
  }
  return "";
}

TEST(FrictionTable, RefusesWhatIsNoFriction) {
  EXPECT_EQ(refusal(-0.25), "friction: must be from 0 to 1e6 between rubber and metal (-0.250000)");
  EXPECT_EQ(refusal(std::numeric_limits<double>::infinity()),
            "friction: must be from 0 to 1e6 between rubber and metal (inf)");
  EXPECT_NE(refusal(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(refusal(0.0), "");
}

TEST(FrictionDeviations, AreOfThePairInBothOrders) {
  FrictionDeviations deviations;
  EXPECT_EQ(deviations.between(Material::wood, Material::glass), std::nullopt);
  deviations.set(Material::wood, Material::glass, 0.3);
  EXPECT_EQ(deviations.between(Material::glass, Material::wood), 0.3);
  deviations.set(Material::glass, Material::wood, std::nullopt);
  EXPECT_EQ(deviations.between(Material::wood, Material::glass), std::nullopt);
  for (const double bad : {-0.1, 11.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(deviations.set(Material::wood, Material::glass, bad), InputError);
  }
}

TEST(Material, NamesGoBothWays) {
  for (const Material material : kAll<Material>) {
    EXPECT_EQ(material_named(name_of(material)), material);
  }
  try {
    material_named("stone");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "unknown material, known are glass, metal, plastic, wood and rubber (stone)");
    EXPECT_EQ(error.value(), "stone");
  }
}

}  // namespace
}  // namespace prehend
