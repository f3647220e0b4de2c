// Worlds made up at random, each step of which is judged by code that shares nothing with what made
// it.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/robot/files/robot_file.h"
#include "tests/support/examine_world.h"
#include "tests/support/random_world.h"

namespace prehend {
namespace {

void examine(World world, double seconds) {
  require_world(world);
  EXPECT_EQ(test::examine(world, seconds).fault, "");
}

struct Kind {
  test::WorldKind kind;
  const char* name;
  std::vector<std::uint64_t> seeds;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest asks for this name
void PrintTo(const Kind& examined, std::ostream* stream) { *stream << examined.name; }

class ExaminedWorlds : public ::testing::TestWithParam<Kind> {};

TEST_P(ExaminedWorlds, NothingPenetratesNorGainsEnergy) {
  for (const std::uint64_t seed : GetParam().seeds) {
    SCOPED_TRACE(std::to_string(seed));
    examine(std::move(test::RandomWorld(GetParam().kind, seed).world()), 0.6);
  }
}

// The first of each kind; then those that once failed: features went through each other for which
// no contact stood, restitution at several places made energy, and so did thin bodies that turned
// fast.
INSTANTIATE_TEST_SUITE_P(
    All, ExaminedWorlds,
    testing::Values(Kind{test::WorldKind::pile, "pile", {1, 2, 120, 134, 116, 148}},
                    Kind{test::WorldKind::thrown, "thrown", {1001, 1002, 1101, 1102, 1109}},
                    Kind{test::WorldKind::plates, "plates", {2001, 2002, 2003, 2138, 2159}},
                    Kind{test::WorldKind::bowl, "bowl", {3001, 3002, 3003, 3107, 3151}}),
    [](const auto& examined) { return std::string(examined.param.name); });

// Masses of up to 1e9 kg and a friction of 1e6, with which bodies once went 29 mm deep.
TEST(ExaminedExtremes, HeavyAndRoughBodiesDoNotPenetrate) {
  for (const std::uint64_t seed : {7U, 10U}) {
    SCOPED_TRACE(std::to_string(seed));
    World world = std::move(test::RandomWorld(test::WorldKind::pile, seed).world());
    Random random(seed);
    for (WorldBody& body : world.bodies) {
      const double factor = seed < 9 ? 1e9 : std::pow(1e9, random.uniform(0.0, 1.0));
      body.inertial.mass *= factor;
      body.inertial.inertia *= factor;
    }
    for (const Material a : kAll<Material>) {
      for (const Material b : kAll<Material>) world.laws.friction.set(a, b, 1e6);
    }
    world.laws.kinetic.reset();
    examine(std::move(world), 0.3);
  }
}

// Hands that close on a body which flies at them. The seeds above 4 once failed: edges that slid
// fast along the hand used up their gap, and then no contact was found between them.
TEST(ExaminedHands, ClosingHandsDoNotPenetrate) {
  const std::vector<std::pair<std::string, std::vector<std::uint64_t>>> hands = {
      {"barrett", {1, 2, 3, 4}},
      {"parallel_jaw", {1, 2, 3, 4}},
      {"franka_hand", {1, 2, 3, 4, 50, 61, 94}},
      {"robotiq_3f", {1, 2, 3, 4}},
      {"allegro", {1, 2, 3, 4}}};
  for (const auto& [name, seeds] : hands) {
    const auto model = std::make_shared<const RobotModel>(make_robot_model(find_robot(name)));
    for (const std::uint64_t seed : seeds) {
      SCOPED_TRACE(name + " " + std::to_string(seed));
      test::RandomWorld made(test::WorldKind::hand, seed);
      if (!made.put_in_hand(model)) continue;
      examine(std::move(made.world()), 0.5);
    }
  }
}

}  // namespace
}  // namespace prehend
