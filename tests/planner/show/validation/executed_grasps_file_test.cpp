#include "planner/show/validation/executed_grasps_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"

namespace prehend::test {
namespace {

using nlohmann::json;

json execution(bool lifted) {
  return {{"object", "mug"},
          {"X_object_hand", {{"position", {0.0, 0.0, 0.2}}, {"quaternion_wxyz", {0, 1, 0, 0}}}},
          {"lifted", lifted}};
}

json sample() {
  return {{"format", "prehend truth 1"},
          {"hand", "parallel_jaw"},
          {"objects", {{{"name", "mug"}, {"scene", "mug"}}}},
          {"executions", {execution(true), execution(false)}}};
}

ExecutedGrasps read(const json& file) {
  return read_executed_grasps(JsonFile("truth.json", file.dump()));
}

TEST(TruthFile, ReadsWhatIsThereAndAssumesTheRest) {
  json file = sample();
  file["objects"][0]["mass"] = 0.5;
  file["executions"][0]["session"] = "monday";
  file["executions"][0]["dofs"] = {0.02, 0.02};
  file["executions"][0]["approach"] = {{"direction", {0, 0, -2}}, {"distance", 0.1}};
  file["executions"][1]["times"] = 4;
  const ExecutedGrasps truth = read(file);
  ASSERT_EQ(truth.objects.size(), 1U);
  const Scene& scene = truth.objects[0].scene.scene;
  EXPECT_EQ(scene.hand.name, "parallel_jaw");
  EXPECT_EQ(scene.object.mass, 0.5);
  EXPECT_EQ(truth.sessions, (std::vector<std::string>{"monday", "-"}));
  ASSERT_EQ(truth.executions.size(), 2U);
  const Execution& first = truth.executions[0];
  EXPECT_TRUE(first.label.lifted);
  EXPECT_EQ(first.label.times, 1);
  EXPECT_EQ(first.grasp.dofs, (std::vector<double>{0.02, 0.02}));
  EXPECT_FALSE(first.grasp.preshape);
  EXPECT_TRUE(first.grasp.approach_O.isApprox(Vector3(0, 0, -1)));
  EXPECT_EQ(first.grasp.approach_distance, 0.1);
  const Execution& second = truth.executions[1];
  EXPECT_EQ(second.label.times, 4);
  EXPECT_EQ(second.label.session, 1);
  EXPECT_EQ(second.grasp.preshape, 0);
  EXPECT_TRUE(
      second.grasp.approach_O.isApprox(second.grasp.X_OH.linear() * scene.hand.hand->approach));
}

TEST(TruthFile, TheMassScalesTheInertia) {
  json file = sample();
  const Matrix3 before = read(file).objects[0].scene.scene.object.inertia;
  const double mass = read(file).objects[0].scene.scene.object.mass;
  file["objects"][0]["mass"] = 3.0 * mass;
  const Matrix3 after = read(file).objects[0].scene.scene.object.inertia;
  EXPECT_TRUE(after.isApprox(3.0 * before, 1e-12));
}

TEST(TruthFile, APoseInTheWorldIsThatOfTheObjectsFrame) {
  json file = sample();
  file["objects"][0]["scene"] = "mug_on_table";
  file["executions"][0]["X_world_hand"] = file["executions"][0]["X_object_hand"];
  file["executions"][0].erase("X_object_hand");
  const ExecutedGrasps truth = read(file);
  const Pose X_WH = truth.objects[0].scene.scene.object.X_WO * truth.executions[0].grasp.X_OH;
  EXPECT_TRUE(X_WH.translation().isApprox(Vector3(0.0, 0.0, 0.2), 1e-12));
}

struct ExecutedGraspsMistake {
  const char* name;
  const char* pointer;  // what is replaced
  const char* value;    // empty: it is removed
  const char* complaint;
};

void PrintTo(const ExecutedGraspsMistake& mistake, std::ostream* stream) {
  *stream << mistake.name;
}

class RefusedTruth : public testing::TestWithParam<ExecutedGraspsMistake> {};

TEST_P(RefusedTruth, NamesFileFieldAndValue) {
  json file = sample();
  const json::json_pointer pointer(GetParam().pointer);
  const std::string value = GetParam().value;
  if (value.empty()) {
    file.at(pointer.parent_pointer()).erase(pointer.back());
  } else {
    file[pointer] = json::parse(value);
  }
  try {
    (void)read(file);
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("truth.json: "), 0U) << message;
    EXPECT_NE(message.find(GetParam().complaint), std::string::npos) << message;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, RefusedTruth,
    testing::Values(
        ExecutedGraspsMistake{"NoFormat", "/format", "", "format: must be given"},
        ExecutedGraspsMistake{"OtherFormat", "/format", R"("prehend truth 2")", "prehend truth 2"},
        ExecutedGraspsMistake{"UnknownField", "/objets", "[]", "objets"},
        ExecutedGraspsMistake{"NoObjects", "/objects", "", "objects"},
        ExecutedGraspsMistake{"MissingScene", "/objects/0/scene", R"("teacup")",
                              "objects[0].scene"},
        ExecutedGraspsMistake{"UnknownHand", "/hand", R"("tentacle")", "tentacle"},
        ExecutedGraspsMistake{"NoMass", "/objects/0/mass", "0", "objects[0].mass: must be above 0"},
        ExecutedGraspsMistake{"TwiceTheName", "/objects/1", R"({"name": "mug", "scene": "mug"})",
                              "objects[1].name: is there twice"},
        ExecutedGraspsMistake{"UnknownObject", "/executions/1/object", R"("cup")",
                              R"(executions[1].object: is none of the file's objects ("cup"))"},
        ExecutedGraspsMistake{"NoPose", "/executions/0/X_object_hand", "", "executions[0]"},
        ExecutedGraspsMistake{"PoseOfNull", "/executions/0/X_object_hand/position/1", "null",
                              "executions[0].X_object_hand.position"},
        ExecutedGraspsMistake{"NoRotation", "/executions/0/X_object_hand/quaternion_wxyz",
                              "[0, 0, 0, 0]", "executions[0].X_object_hand.quaternion_wxyz"},
        ExecutedGraspsMistake{"DofsTooFew", "/executions/0/dofs", "[0.02]", "executions[0].dofs"},
        ExecutedGraspsMistake{"DofsOutside", "/executions/0/dofs", "[0.02, 9]", "limits"},
        ExecutedGraspsMistake{"UnknownPreshape", "/executions/0/preshape", R"("fist")",
                              "executions[0].preshape"},
        ExecutedGraspsMistake{"WordForLifted", "/executions/0/lifted", R"("yes")",
                              "executions[0].lifted"},
        ExecutedGraspsMistake{"NeverTried", "/executions/0/times", "0", "executions[0].times"},
        ExecutedGraspsMistake{"BackwardApproach", "/executions/0/approach", R"({"distance": -1})",
                              "executions[0].approach.distance"},
        ExecutedGraspsMistake{"NoneLifted", "/executions/0/lifted", "false",
                              "executions: none of them lifted"},
        ExecutedGraspsMistake{"NoneFailed", "/executions/1/lifted", "true",
                              "executions: none of them failed"},
        ExecutedGraspsMistake{"Empty", "/executions", "[]", "executions: must not be empty"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

}  // namespace
}  // namespace prehend::test
