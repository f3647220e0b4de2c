#include "planner/results/datasets/graspgen_file.h"

#include <gtest/gtest.h>

#include "sim/base/json/json_field.h"
#include "tests/planner/results/datasets/sample_sets.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

const std::string kMatrix = "[[1,0,0,0.1],[0,1,0,0.2],[0,0,1,0.3],[0,0,0,1]]";

// A file with these words for its two labels.
std::string two_grasps(const std::string& labels, const std::string& matrix = kMatrix) {
  return R"({"object": {"file": "a.obj", "scale": 2}, "grasps": {"transforms": [)" + kMatrix +
         ", " + matrix + R"(], "object_in_gripper": )" + labels + "}}";
}

GraspSet read(const std::string& text) { return read_graspgen(JsonFile("grasps.json", text)); }

TEST(GraspgenFile, ReadsBackTheSame) {
  Random random(1);
  for (const std::size_t count : {0U, 1U, 50U}) {
    const GraspSet set = test::random_set(random, count);
    const std::string text = graspgen_text(set);
    const JsonFile file("grasps.json", text);
    EXPECT_TRUE(is_graspgen(file));
    const GraspSet back = read_graspgen(file);
    EXPECT_EQ(back.object.file, set.object.file);
    EXPECT_EQ(back.object.scale, set.object.scale);
    ASSERT_EQ(back.grasps.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_TRUE(test::same_bits(back.grasps[i].X_OH.matrix(), set.grasps[i].X_OH.matrix()));
      EXPECT_EQ(back.grasps[i].outcome == Outcome::stable,
                set.grasps[i].outcome == Outcome::stable);
    }
    EXPECT_EQ(graspgen_text(back), text);
  }
}

TEST(GraspgenFile, TakesLabelsAsOthersWriteThem) {
  for (const std::string labels : {"[true, false]", "[1, 0]", "[1.0, 0.0]", "[[true], [false]]"}) {
    const GraspSet set = read(two_grasps(labels));
    EXPECT_EQ(set.grasps[0].outcome, Outcome::stable) << labels;
    EXPECT_EQ(set.grasps[1].outcome, Outcome::not_force_closure) << labels;
    EXPECT_EQ(set.grasps[1].X_OH.translation(), Vector3(0.1, 0.2, 0.3));
  }
}

TEST(GraspgenFile, NamesTheFieldThatCannotBeUsed) {
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {two_grasps("[true]"), "grasps.object_in_gripper"},
      {two_grasps("[true, 2]"), "grasps.object_in_gripper[1]"},
      {two_grasps("[true, [[true]]]"), "grasps.object_in_gripper[1]"},
      {two_grasps("[true, false]", "[[1,0,0,0]]"), "grasps.transforms[1]"},
      {two_grasps("[true, false]", "[[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"),
       "grasps.transforms[1]"},
      {R"({"object": {"scale": 0}, "grasps": {"transforms": []}})", "object.scale"},
      {R"({"object": {"file": "a.obj"}, "grasps": {"transforms": []}})", "object.scale"},
      {R"({"grasps": {"transforms": []}})", "object"},
  };
  for (const auto& [text, field] : mistakes) {
    const InputError error = test::refusal_of([&, &json = text] { (void)read(json); });
    EXPECT_EQ(error.field(), field) << error.what();
    EXPECT_EQ(error.file(), "grasps.json");
  }
}

TEST(GraspgenFile, IsToldFromGraspsOfPrehend) {
  const auto told = [](const std::string& text) { return is_graspgen(JsonFile("a.json", text)); };
  EXPECT_TRUE(told(two_grasps("[true, false]")));
  EXPECT_FALSE(told(R"({"grasps": []})"));
  EXPECT_FALSE(told(R"({"scene": "mug"})"));
  EXPECT_FALSE(told("[]"));
}

}  // namespace
}  // namespace prehend
