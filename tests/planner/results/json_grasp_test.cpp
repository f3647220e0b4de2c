// Results of an earlier run as a grasp file has them.
#include "planner/results/json_grasp.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "planner/plan/path/grasp_motion.h"
#include "planner/results/grasps_file.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/json/wrapped_json.h"
#include "sim/base/output_file.h"
#include "tests/support/block_on_table.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

using nlohmann::json;

// A grasp that the arm holds in another posture than the nearest to its start.
class ArmResult : public testing::Test {
 protected:
  static const CompiledScene& scene() { return test::block_in_the_air(); }

  static const ScoredGrasp& scored() {
    static const ScoredGrasp kScored = [] {
      const test::Grasp grasp = test::grasp_in_the_farther_posture(scene());
      ScoredGrasp scored;
      scored.trial = grasp.trial;
      scored.candidate = grasp.candidate;
      scored.volume = 0.0;
      scored.rule = "given";
      return scored;
    }();
    return kScored;
  }

  // The file of that grasp.
  static json file() {
    PlanResult result;
    result.grasps = {scored()};
    return json::parse(grasps_json(scene(), result, {}));
  }

  static ScoredGrasp read_back(const json& content) {
    const JsonFile file(test::write_scene(content));
    return read_grasps(file, scene()).result.grasps.front();
  }

  static std::string complaint(const json& content) {
    try {
      (void)read_back(content);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  // The motion that is drawn ends in the posture that the file names.
  static void expect_drawn_in_that_posture(const ScoredGrasp& read) {
    const GraspMotion motion = grasp_motion(scene(), read.candidate, read.trial, nullptr);
    EXPECT_EQ(motion.frames.back().arm_joints,
              arm_joints(*scene().arm, scored().trial.arm_dofs, read.trial.joints));
    EXPECT_EQ(motion.frames.front().arm_joints.size(), scene().arm->robot().joints.size());
    EXPECT_GT(motion.segments.front().last, 5);
  }
};

TEST_F(ArmResult, TheArmsLineIsReadAsItWasWritten) {
  const ScoredGrasp read = read_back(file());
  EXPECT_EQ(read.trial.arm_line, scored().trial.arm_line);
  EXPECT_EQ(read.trial.arm_dofs, scored().trial.arm_dofs);
  expect_drawn_in_that_posture(read);
}

TEST_F(ArmResult, WithoutALineTheOneThatEndsAtArmDofsIsFound) {
  json content = file();
  content["grasps"][0].erase("arm_line");
  const ScoredGrasp read = read_back(content);
  ASSERT_EQ(read.trial.arm_line.size(), scored().trial.arm_line.size());
  for (std::size_t i = 0; i < read.trial.arm_line.size(); ++i) {
    for (const int d : scene().arm->dofs) {
      const auto k = static_cast<std::size_t>(d);
      EXPECT_NEAR(read.trial.arm_line[i][k], scored().trial.arm_line[i][k], 1e-5) << i;
    }
  }
  expect_drawn_in_that_posture(read);
}

TEST_F(ArmResult, ALineThatEndsElsewhereIsRefused) {
  json content = file();
  content["grasps"][0]["arm_line"].erase(content["grasps"][0]["arm_line"].size() - 1);
  EXPECT_NE(complaint(content).find("grasps[0].arm_line: must end at arm_dofs"), std::string::npos)
      << complaint(content);
  content["grasps"][0]["arm_line"] = json::array();
  EXPECT_NE(complaint(content).find("grasps[0].arm_line: must not be empty"), std::string::npos)
      << complaint(content);
}

// The objects of a value, and of those in it, have the fields that its schema requires and no
// others.
void expect_fields_of(const json& value, const json& schema, const std::string& name) {
  if (value.is_array() && schema.contains("items")) {
    for (const json& item : value) expect_fields_of(item, schema["items"], name + "[]");
  }
  if (!value.is_object() || !schema.contains("required")) return;
  for (const json& field : schema["required"]) {
    EXPECT_TRUE(value.contains(field)) << name << ": " << field;
  }
  for (const auto& [field, inner] : value.items()) {
    ASSERT_TRUE(schema["properties"].contains(field)) << name << ": " << field;
    expect_fields_of(inner, schema["properties"][field], name + "." + field);
  }
}

TEST_F(ArmResult, HasTheFieldsOfTheSchema) {
  ScoredGrasp grasp = scored();
  grasp.refinement = Refinement{0, 0.1, 5};
  grasp.robustness = Robustness{};
  grasp.robustness->samples = 16;
  grasp.holding = PayloadMargin{};
  grasp.holding->given.sum_of_normals = std::numeric_limits<double>::infinity();
  grasp.shake = ShakeReport{.procedure = "shake", .tests = {{.name = "up"}}, .effort = {}};
  const json written = grasp_to_json(grasp, scene(), {});
  expect_fields_of(written, grasp_schema(), "grasp");
  EXPECT_TRUE(written["weight"]["given"]["squeeze"].is_null());
}

// With PREHEND_WRITE_SCHEMA in the environment the document is written instead of compared.
TEST(GraspSchema, IsThatOfTheDocument) {
  const std::filesystem::path file =
      std::filesystem::path(PREHEND_SOURCE_DIR) / "docs" / "reference" / "grasps.schema.json";
  auto document = nlohmann::ordered_json::parse(read_file(file));
  document["$defs"]["outcome"] = {{"enum", enum_names(Outcome{})}};
  document["$defs"]["grasp"] = grasp_schema();
  if (std::getenv("PREHEND_WRITE_SCHEMA") != nullptr) write_file(file, wrapped_json(document));
  EXPECT_TRUE(read_file(file) == wrapped_json(document))
      << "PREHEND_WRITE_SCHEMA=1 files_tests writes it anew";
}

}  // namespace
}  // namespace prehend
