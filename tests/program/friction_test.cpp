// The friction of the object as the command line states it.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

nlohmann::json grasps_of(const std::filesystem::path& folder) {
  return nlohmann::json::parse(content(folder / "grasps.json"));
}

TEST(Friction, IsThatOfAllContactsAndIsKeptForWhatIsMadeOfTheFile) {
  const std::filesystem::path folder = fresh_folder("friction");
  const std::string out = (folder / "out").string();
  const ProgramRun run =
      run_program("plan mug --trials 40 --no-report --still --friction 0.6 --out " + out);
  ASSERT_EQ(run.status, 0) << run.err;
  const nlohmann::json planned = grasps_of(folder / "out");
  EXPECT_EQ(planned["scene"]["friction"], 0.6);
  ASSERT_FALSE(planned["grasps"].empty());
  for (const nlohmann::json& contact : planned["grasps"][0]["contacts"]) {
    EXPECT_EQ(contact["friction"], 0.6);
  }
  const std::string evaluate = "evaluate " + out + "/grasps.json --no-report --out ";
  ASSERT_EQ(run_program(evaluate + (folder / "same").string()).status, 0);
  const nlohmann::json same = grasps_of(folder / "same");
  // Closed again, the fingers stop at other points within the gap that counts as touching.
  EXPECT_NEAR(same["grasps"][0]["epsilon"], planned["grasps"][0]["epsilon"].get<double>(), 1e-5);
  ASSERT_EQ(run_program(evaluate + (folder / "slippery").string() + " --friction 0.2").status, 0);
  const nlohmann::json slippery = grasps_of(folder / "slippery");
  EXPECT_EQ(slippery["scene"]["friction"], 0.2);
  EXPECT_LT(slippery["grasps"][0]["epsilon"], same["grasps"][0]["epsilon"]);
}

TEST(Friction, IsACoefficient) {
  const std::filesystem::path folder = fresh_folder("friction_negative");
  expect_refused(run_program("plan mug --friction -1 --out " + (folder / "out").string()),
                 "--friction");
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace prehend::test
