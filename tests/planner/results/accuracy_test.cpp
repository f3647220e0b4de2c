// The accuracies by name and as files of settings.
#include "planner/plan/accuracy.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/results/json_settings.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

nlohmann::ordered_json settings_json(const PlanOptions& options) {
  RunRecord record;
  record.options = options;
  return settings_to_json(record);
}

// A file of settings, of this test alone.
std::string settings_file(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = testing::TempDir() + "/accuracy_" + test->name() + ".json";
  write_file(path, text);
  return path;
}

std::string complaint_of(const std::string& text) {
  const std::string file = settings_file(text);
  try {
    (void)read_accuracy(file);
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.rfind(file + ": ", 0), 0U) << what;
    return what.substr(file.size() + 2);
  }
  return "";
}

TEST(Accuracy, StandardAreTheDefaults) {
  EXPECT_EQ(settings_json(plan_options(Accuracy::standard)), settings_json({}));
}

TEST(Accuracy, TheirNamesAreRead) {
  for (const Accuracy accuracy : kAll<Accuracy>) {
    const std::string name(name_of(accuracy));
    EXPECT_EQ(value_named<Accuracy>(name), accuracy);
    EXPECT_EQ(settings_json(read_accuracy(name)), settings_json(plan_options(accuracy)));
  }
  EXPECT_FALSE(value_named<Accuracy>("coarse").has_value());
  EXPECT_THROW((void)read_accuracy("no such file"), InputError);
}

// None of them gives up what makes a grasp sound.
TEST(Accuracy, AllHaveContactsAtTheSameGap) {
  for (const Accuracy accuracy : kAll<Accuracy>) {
    EXPECT_EQ(plan_options(accuracy).trial.contact_gap, TrialOptions{}.contact_gap);
    EXPECT_EQ(plan_options(accuracy).trial.contact.threshold, ContactOptions{}.threshold);
  }
}

TEST(Accuracy, AFileChangesTheOneThatItNames) {
  const PlanOptions options = read_accuracy(
      settings_file(R"({"accuracy": "draft", "trials": 7, "refine_objective": "robust",
                        "paths": {"alternatives": 5, "planner": "roadmap"}})"));
  EXPECT_EQ(options.search.trials, 7);
  EXPECT_EQ(options.refine.objective, RefineObjective::robust);
  ASSERT_TRUE(options.paths.has_value());
  EXPECT_EQ(options.paths->alternatives, 5);
  EXPECT_EQ(options.paths->transfer.planner, PathPlanner::roadmap);
  EXPECT_EQ(options.trial.back_off_tries, plan_options(Accuracy::draft).trial.back_off_tries);
}

TEST(Accuracy, MistakesInAFileAreNamed) {
  EXPECT_EQ(complaint_of(R"({"trails": 7})").rfind("trails: ", 0), 0U);
  EXPECT_EQ(complaint_of(R"({"seed": 7})").rfind("seed: is no matter of accuracy", 0), 0U);
  EXPECT_EQ(complaint_of(R"({"top": 7})").rfind("top: is no matter of accuracy", 0), 0U);
  EXPECT_EQ(complaint_of(R"({"trials": 0})").rfind("trials: must be at least 1", 0), 0U);
  EXPECT_EQ(complaint_of(R"({"cone_edges": 2})").rfind("cone_edges: must be at least 3", 0), 0U);
  EXPECT_EQ(complaint_of(R"({"accuracy": "best"})").rfind("accuracy: must be one of draft", 0), 0U);
  EXPECT_EQ(complaint_of(R"({"follow": 1.5})").rfind("follow: must be at least 0 and at most 1", 0),
            0U);
  EXPECT_EQ(complaint_of(R"({"contact_gap": 1e-4})").rfind("contact_gap: must be at most", 0), 0U);
  EXPECT_EQ(complaint_of(R"({"contact_threshold": 5e-5})").rfind("contact_gap: must be at most", 0),
            0U);
  EXPECT_EQ(complaint_of(R"({"paths": {"sample_time": 0}})")
                .rfind("paths.sample_time: must be above 0", 0),
            0U);
}

// Such a file goes on to work, and its user hears what has become of it.
TEST(Accuracy, SettingsOfEarlierVersionsAreNoted) {
  const std::string file =
      settings_file(R"({"trials": 7, "refine_reach": 2.0, "paths": {"longest_edge": 0.5}})");
  std::vector<std::string> notes;
  EXPECT_EQ(read_accuracy(file, &notes).search.trials, 7);
  EXPECT_EQ(notes,
            (std::vector<std::string>{file + ": refine_reach has no effect any more",
                                      file + ": paths.longest_edge has no effect any more"}));
  (void)read_accuracy(settings_file(R"({"trials": 7})"), &notes);
  EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace prehend
