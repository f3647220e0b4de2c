// Batches that are run in parts, interrupted, continued and merged.
#include "planner/bulk/run_batch.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "planner/bulk/merge_batch.h"
#include "planner/results/datasets/acronym_file.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"
#include "tests/support/file_tree.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

using test::bytes_of;
using test::files_below;
using test::kBoxObj;

const char* const kBatch = R"({
  "objects": ["meshes/", {"generate": ["ball", "box"], "triangles": 200}],
  "hands": ["franka_hand", "robotiq_2f85"], "frictions": [0.5, 1.0],
  "settings": [{"accuracy": "draft", "trials": 12}]})";

class RunBatch : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    home_ = fs::path(testing::TempDir()) / (std::string("batch_") + test->name());
    fs::remove_all(home_);
    make_folder(home_ / "meshes");
    write_file(home_ / "meshes/cube.obj", kBoxObj);
  }

  Batch batch(const std::string& text = kBatch) const {
    return read_batch(JsonFile(home_ / "small.json", text));
  }

  BatchCount run(const Batch& batch, const std::string& out, const BatchRunOptions& options = {},
                 int threads = 2, const BatchListener& listener = {}) const {
    RunContext context;
    context.threads = threads;
    return run_batch(batch, BatchInputs(batch), BatchFolder(home_ / out, batch), options, context,
                     listener);
  }

  std::map<std::string, std::string> merged(const Batch& batch, const std::string& out,
                                            int threads = 2) const {
    RunContext context;
    context.threads = threads;
    MergeOptions options;
    options.pictures = 4;
    const BatchCount count =
        merge_batch(batch, BatchInputs(batch), BatchFolder(home_ / out, batch), options, context);
    EXPECT_EQ(count.open(), 0U);
    return files_below(home_ / out / "merged");
  }

  fs::path home_;
};

TEST_F(RunBatch, MergedBytesDoNotDependOnShardsAndThreads) {
  const Batch all = batch();
  const BatchCount count = run(all, "whole", {}, 1);
  EXPECT_EQ(count.parts, 12U);
  EXPECT_EQ(count.finished, 12U);
  const auto expected = merged(all, "whole", 1);
  EXPECT_GE(expected.size(), 12U * 2 + 4);
  EXPECT_TRUE(expected.contains("acronym/cube/franka_hand_friction0.5.h5"));
  for (const int of : {2, 7}) {
    const std::string out = "shards" + std::to_string(of);
    // The last shard first: no shard needs what another one left.
    for (int number = of; number >= 1; --number) run(all, out, {{number, of}});
    EXPECT_EQ(merged(all, out), expected) << of;
  }
}

TEST_F(RunBatch, GoesOnWhereItWasCancelled) {
  const Batch all = batch();
  run(all, "whole");
  RunContext context;
  context.threads = 1;
  const BatchListener stop{[&](const BatchCount& count) {
    if (count.finished >= 5) context.cancellation.request();
  }};
  const BatchFolder folder(home_ / "cut", all);
  const BatchCount first = run_batch(all, BatchInputs(all), folder, {}, context, stop);
  EXPECT_EQ(first.finished, 5U);
  EXPECT_EQ(first.open(), 7U);
  const BatchCount second = run(all, "cut");
  EXPECT_EQ(second.finished, 12U);
  EXPECT_EQ(second.made, 7U);
  EXPECT_EQ(run(all, "cut").made, 0U);
  EXPECT_EQ(merged(all, "cut"), merged(all, "whole"));
}

TEST_F(RunBatch, ChangedInputIsDoneAnew) {
  const Batch all = batch();
  run(all, "out");
  write_file(home_ / "meshes/cube.obj", std::string(kBoxObj) + "# changed\n");
  EXPECT_EQ(run(all, "out").made, 4U);
}

TEST_F(RunBatch, BrokenMeshFailsAlone) {
  write_file(home_ / "meshes/broken.stl", "solid of nothing");
  const Batch all = batch();
  std::vector<FailedPart> failed;
  BatchListener listener;
  listener.failed = [&](const FailedPart& part) { failed.push_back(part); };
  const BatchCount count = run(all, "out", {}, 2, listener);
  EXPECT_EQ(count.finished, 12U);
  EXPECT_EQ(count.failed, 4U);
  ASSERT_EQ(failed.size(), 4U);
  EXPECT_NE(failed[0].reason.find("broken.stl"), std::string::npos) << failed[0].reason;
  EXPECT_EQ(failed[0].reason.find('\n'), std::string::npos);
  const BatchCount again = run(all, "out");
  EXPECT_EQ(again.made, 0U);
  EXPECT_EQ(again.failed, 4U);
  BatchRunOptions retry;
  retry.retry = true;
  EXPECT_EQ(run(all, "out", retry).made, 4U);
  const auto files = merged(all, "out");
  EXPECT_NE(files.at("failures.csv").find("broken/franka_hand"), std::string::npos);
  EXPECT_NE(files.at("index.html").find("4 of 16 parts failed"), std::string::npos);
  // Once it is repaired, its parts have results.
  write_file(home_ / "meshes/broken.stl", bytes_of(home_ / "meshes/cube.obj"));
  fs::rename(home_ / "meshes/broken.stl", home_ / "meshes/broken.obj");
  EXPECT_EQ(run(batch(), "out").failed, 0U);
}

TEST_F(RunBatch, IsNotMergedWhilePartsAreOpen) {
  const Batch all = batch();
  run(all, "out", {{1, 2}});
  const BatchInputs inputs(all);
  const BatchFolder folder(home_ / "out", all);
  EXPECT_EQ(merge_batch(all, inputs, folder).open(), 6U);
  EXPECT_FALSE(fs::exists(home_ / "out/merged"));
  MergeOptions partial;
  partial.partial = true;
  partial.pictures = 0;
  EXPECT_EQ(merge_batch(all, inputs, folder, partial).finished, 6U);
  EXPECT_NE(bytes_of(home_ / "out/merged/CARD.md").find("Not complete"), std::string::npos);
}

TEST_F(RunBatch, FolderOfAnotherBatchIsRefused) {
  const Batch all = batch();
  run(all, "out", {{1, 12}});
  Batch other = all;
  other.name = "other";
  EXPECT_NE(test::refusal_of([&] { BatchFolder(home_ / "out", other); })
                .problem()
                .find("belongs to another batch, small"),
            std::string::npos);
  EXPECT_EQ(test::refusal_of([&] { BatchFolder(home_ / "meshes", all); }).problem(),
            "has files, but not of a batch");
  EXPECT_NO_THROW(BatchFolder(home_ / "new", all));
  EXPECT_FALSE(fs::exists(home_ / "new"));
}

TEST_F(RunBatch, ResultsSayWhatWasTried) {
  const Batch all = batch();
  run(all, "out");
  const auto files = merged(all, "out");
  const GraspSet set = read_acronym(home_ / "out/merged/acronym/cube/franka_hand_friction0.5.h5");
  EXPECT_EQ(set.object.file, "meshes/cube.obj");
  EXPECT_EQ(set.object.friction, 0.5);
  EXPECT_NEAR(set.object.volume, 0.04 * 0.04 * 0.05, 1e-11);
  EXPECT_GE(set.grasps.size(), 12U);
  std::size_t stable = 0;
  for (const GraspSetEntry& grasp : set.grasps) {
    const bool holds = grasp.outcome == Outcome::stable;
    stable += holds ? 1U : 0U;
    EXPECT_EQ(grasp.epsilon.upper > 0.0, holds);
    EXPECT_LE(grasp.epsilon.lower, grasp.epsilon.upper);
  }
  EXPECT_GT(stable, 0U);
  // A row for each grasp of each set, and the names of the columns.
  const std::string& table = files.at("grasps.csv");
  std::size_t grasps = 0;
  for (const auto& [name, bytes] : files) {
    if (name.starts_with("acronym/")) {
      grasps += read_acronym(home_ / "out/merged" / name).grasps.size();
    }
  }
  EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')), grasps + 1);
}

}  // namespace
}  // namespace prehend
