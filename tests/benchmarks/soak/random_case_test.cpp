#include "benchmarks/soak/random_case.h"

#include <set>

#include <gtest/gtest.h>

#include "benchmarks/soak/random_object.h"
#include "benchmarks/soak/tally.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/mesh_checks.h"

namespace prehend::soak {
namespace {

TEST(RandomObject, IsASolidWhereItSaysSoAndOfASizeThatIsAccepted) {
  Random random(3);
  int solids = 0;
  for (int i = 0; i < 300; ++i) {
    const RandomObject object = random_object(random);
    const double size = bounds(object.mesh).size().maxCoeff();
    EXPECT_GT(size, kSmallestObject) << object.words;
    EXPECT_LT(size, 1.0 + 1e-9) << object.words;
    EXPECT_LT(object.mesh.triangles.size(), 6000U) << object.words;
    if (!object.solid) continue;
    ++solids;
    const MeshChecks checks = check_mesh(object.mesh);
    EXPECT_TRUE(checks.solid() && !checks.inward) << object.words;
  }
  EXPECT_GT(solids, 100);
  EXPECT_LT(solids, 250);
}

TEST(RandomCase, DependsOnSeedAndNumberAlone) {
  std::set<std::string> words;
  for (const std::uint64_t seed : {1U, 2U}) {
    for (std::uint64_t number = 0; number < 20; ++number) {
      const RandomCase once = random_case(seed, number);
      const RandomCase again = random_case(seed, number);
      EXPECT_EQ(once.words, again.words);
      EXPECT_EQ(once.known.scene.object.mesh.vertices, again.known.scene.object.mesh.vertices);
      EXPECT_EQ(once.options.seed, again.options.seed);
      words.insert(once.words);
    }
  }
  EXPECT_GT(words.size(), 35U);
}

TEST(Tally, CountsFaultsByKindAndRefusalsByMessage) {
  Tally tally;
  CaseFindings good;
  good.grasps = 3;
  good.seconds = 2.0;
  CaseFindings bad = good;
  bad.faults = {{"epsilon", "1 of 2"}, {"epsilon", "2 of 2"}, {"path", "blocked"}};
  CaseFindings refused;
  refused.refused = "start: hand/distal_1 collides at 0.25 m";
  tally.add(7, good);
  tally.add(8, bad);
  tally.add(9, refused);
  refused.refused = "start: hand/distal_3 collides at 12.5 m";
  tally.add(10, refused);
  EXPECT_EQ(tally.cases(), 4);
  EXPECT_EQ(tally.failed(), 1);
  const std::string table = tally.table();
  EXPECT_NE(table.find("faults: epsilon"), std::string::npos) << table;
  EXPECT_NE(table.find("refused 2 times: start: hand/distal_# collides at #.# m"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("2 s, case 7"), std::string::npos) << table;
}

}  // namespace
}  // namespace prehend::soak
