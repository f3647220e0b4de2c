#include "planner/show/validation/validation_page.h"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "planner/show/validation/unit_plot.h"
#include "planner/show/validation/validation_text.h"
#include "sim/base/json/json_field.h"
#include "tests/planner/show/validation/random_executions.h"
#include "tests/support/well_formed.h"

namespace prehend::test {
namespace {

// A report on made-up scores; `name` is that of the file, the object and the session.
ValidationReport made_up_report(const std::string& name) {
  const RandomExecutions random = random_executions({.executions = 60, .objects = 2}, 1);
  ExecutedGrasps truth;
  for (int i = 0; i < 2; ++i) truth.objects.push_back({name + std::to_string(i), {}});
  for (int i = 0; i < 4; ++i) truth.sessions.push_back(name + std::to_string(i));
  for (const Label& label : random.labels) truth.executions.push_back({{}, label});
  const std::vector<Score> chosen = scores(false);
  JudgedExecutions judged;
  for (const Score& score : chosen) {
    judged.scores.push_back(random.scores);
    if (!score.is_probability) continue;
    for (double& value : judged.scores.back()) value = 1.0 / (1.0 + std::exp(-value));
  }
  ValidationReport report = validation_report(truth, chosen, judged, {.resamples = 50});
  report.name = name;
  return report;
}

TEST(ValidationPage, IsOneFileWithoutScripts) {
  const std::string page = validation_page(made_up_report("mugs"));
  EXPECT_EQ(page.find("<!DOCTYPE html>"), 0U);
  for (const char* outside : {"<script", "http:", "https:", "<link", "<img", "@import", "url("}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }
  EXPECT_NE(page.find("prefers-color-scheme: dark"), std::string::npos);
  EXPECT_EQ(page, validation_page(made_up_report("mugs")));
}

TEST(ValidationPage, ShowsNamesAsTheyAre) {
  const std::string page = validation_page(made_up_report("<script>alert('&\"')</script>"));
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(&#39;&amp;&quot;&#39;)&lt;/script&gt;1"),
            std::string::npos);
}

TEST(ValidationPage, PlotsAreWellFormed) {
  UnitPlot plot("a < b", "x & y", "\"z\"");
  plot.diagonal();
  plot.line({{0.0, 0.0}, {0.5, 1.0}}, 1);
  plot.line({}, 2);
  plot.dot({0.2, 0.3}, {0.1, 0.5}, 3.0, 0);
  plot.bar({0.2, 0.4}, 0.1);
  EXPECT_TRUE(is_well_formed(plot.svg())) << plot.svg();
  EXPECT_TRUE(is_well_formed(interval_svg(0.5, {0.4, 0.6})));
}

TEST(TruthText, JsonHasTheFiguresOfTheReport) {
  const ValidationReport report = made_up_report("mugs");
  const nlohmann::json written = nlohmann::json::parse(validation_json(report));
  EXPECT_EQ(written.at("lifted").get<int>() + written.at("failed").get<int>(), 60);
  EXPECT_EQ(written.at("scores").size(), report.scores.size());
  EXPECT_EQ(written.at("scores").at(1).at("name"), "epsilon");
  EXPECT_EQ(written.at("scores").at(1).at("auc"), *report.scores[1].auc.value);
  EXPECT_EQ(written.at("scores").at(1).at("over_epsilon"), 0.0);
  int calibrated = 0;
  for (const auto& score : written.at("scores"))
    calibrated += score.contains("calibration") ? 1 : 0;
  EXPECT_EQ(calibrated, 2) << "the probability and the success";
  EXPECT_EQ(written.at("objects").size(), 2U);
  EXPECT_EQ(written.at("sessions").size(), 4U);
}

TEST(TruthText, APartOfOneOutcomeHasNoAuc) {
  ValidationReport report = made_up_report("mugs");
  report.objects[0].auc[0] = std::nullopt;
  EXPECT_TRUE(nlohmann::json::parse(validation_json(report))
                  .at("objects")
                  .at(0)
                  .at("auc")
                  .at("force_closure")
                  .is_null());
  EXPECT_NE(validation_table(report).find(" - "), std::string::npos);
}

TEST(JudgedExecutions, AreTheSameOnAnyNumberOfThreads) {
  nlohmann::json file = {{"format", "prehend truth 1"},
                         {"hand", "parallel_jaw"},
                         {"objects", {{{"name", "mug"}, {"scene", "mug"}}}},
                         {"executions", nlohmann::json::array()}};
  for (int i = 0; i < 6; ++i) {
    file["executions"].push_back(
        {{"object", "mug"},
         {"X_object_hand",
          {{"position", {0.0, 0.035, 0.13 + 0.01 * i}}, {"quaternion_wxyz", {0, 1, 0, 0}}}},
         {"lifted", i < 3}});
  }
  const ExecutedGrasps truth = read_executed_grasps(JsonFile("truth.json", file.dump()));
  const std::vector<Score> chosen = scores(true);
  const auto text = [&](int threads) {
    const RunContext context{.threads = threads};
    const JudgedExecutions judged = judge_executions(truth, chosen, {}, context);
    ValidationReport report = validation_report(truth, chosen, judged, {.resamples = 20}, context);
    report.frames = check_frames(truth, context);
    return validation_json(report);
  };
  EXPECT_EQ(text(1), text(2));
}

}  // namespace
}  // namespace prehend::test
