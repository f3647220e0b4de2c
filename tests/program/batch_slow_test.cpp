// `prehend batch` as a whole: killed, continued, out of room, refused.
#include <algorithm>
#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "tests/program/program.h"
#include "tests/program/running_program.h"
#include "tests/support/file_tree.h"

namespace prehend::test {
namespace {

namespace fs = std::filesystem;

// 20 objects, 3 hands, 2 coefficients of friction.
const char* const kLargeBatch = R"({
  "objects": ["meshes/", {"generate": ["mug", "wine_glass", "phone", "flask", "bottle", "bowl",
                                       "box", "ball", "cylinder"], "triangles": [100, 200]}],
  "hands": ["franka_hand", "robotiq_2f85", "barrett"], "frictions": [0.5, 1.0],
  "settings": [{"accuracy": "draft", "trials": 40}]})";

const char* const kSmallBatch = R"({
  "objects": ["meshes/", {"generate": "box", "triangles": 100}], "hands": ["franka_hand"],
  "settings": [{"accuracy": "draft", "trials": 6}], "seeds": [1, 2, 3]})";

class BatchProgram : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    home_ = fresh_folder(std::string("batch_program_") + test->name());
    fs::create_directories(home_ / "meshes");
    std::ofstream(home_ / "meshes/cube.obj") << kBoxObj;
    std::ofstream(home_ / "meshes/tall.obj") << kBoxObj;
    write(kSmallBatch);
  }

  void write(const std::string& batch) const { std::ofstream(file()) << batch; }
  std::string file() const { return (home_ / "batch.json").string(); }
  std::string words(const std::string& out) const {
    return " '" + file() + "' -o '" + (home_ / out).string() + "'";
  }

  fs::path home_;
};

TEST_F(BatchProgram, KilledTwentyTimesEndsWithTheSameBytes) {
  write(kLargeBatch);
  ASSERT_EQ(run_program("batch" + words("whole")).status, 0);
  ASSERT_EQ(run_program("batch merge" + words("whole")).status, 0);
  Random random(16);
  int killed = 0;
  while (killed < 20) {
    RunningProgram program(
        {"batch", file(), "-o", (home_ / "killed").string(), "--threads", "1", "--progress"},
        home_);
    // Once it has begun, at any moment of a part or between two.
    EXPECT_TRUE(program.wait_for_line(""));
    ::usleep(static_cast<useconds_t>(random.integer(0, 150'000)));
    if (program.has_ended()) break;
    program.send(SIGKILL);
    std::string rest;
    program.wait(rest);
    ++killed;
  }
  EXPECT_EQ(killed, 20) << "the batch was done before it was killed often enough";
  ASSERT_EQ(run_program("batch" + words("killed")).status, 0);
  ASSERT_EQ(run_program("batch merge" + words("killed")).status, 0);
  const auto expected = files_below(home_ / "whole/merged");
  EXPECT_EQ(expected.size(), 2 * 120U + 4U + 16U);
  EXPECT_TRUE(files_below(home_ / "killed/merged") == expected);
}

TEST_F(BatchProgram, OutOfRoomItEndsInOneLineAndGoesOnLater) {
  ASSERT_EQ(run_program("batch" + words("whole")).status, 0);
  ASSERT_EQ(run_program("batch merge" + words("whole")).status, 0);
  fs::create_directories(home_ / "room");
  // A file system of 24 kB, which only this shell sees.
  const std::string in_small_room = "unshare -m sh -c 'mount -t tmpfs -o size=24k tmpfs \"" +
                                    (home_ / "room").string() + "\" && exec \"$@\"' -- ";
  if (std::system((in_small_room + "true 2>/dev/null").c_str()) != 0) {
    GTEST_SKIP() << "a file system cannot be mounted here";
  }
  const ProgramRun full =
      run_program("batch" + words("room/out"), in_small_room + "'" + PREHEND_PROGRAM + "'");
  expect_ended(full, 1, "No space left on device");
  const ProgramRun read_only =
      run_program("batch" + words("room/out"),
                  "unshare -m sh -c 'mount -t tmpfs -o ro tmpfs \"" + (home_ / "room").string() +
                      "\" && exec \"$@\"' -- '" + PREHEND_PROGRAM + "'");
  expect_refused(read_only, "Read-only file system");
  // What was done before the room was used up stays done: here with a limit on the size of files,
  // below that of a result.
  const ProgramRun limited = run_program("batch" + words("limited"),
                                         std::string("ulimit -f 1; '") + PREHEND_PROGRAM + "'");
  expect_ended(limited, 1, "File too large");
  ASSERT_EQ(run_program("batch" + words("limited")).status, 0);
  ASSERT_EQ(run_program("batch merge" + words("limited")).status, 0);
  EXPECT_TRUE(files_below(home_ / "limited/merged") == files_below(home_ / "whole/merged"));
}

TEST_F(BatchProgram, InterruptedItKeepsWhatIsDone) {
  write(kLargeBatch);
  RunningProgram program(
      {"batch", file(), "-o", (home_ / "kept").string(), "--threads", "1", "--progress"}, home_);
  // The first line says that nothing is done yet.
  ASSERT_TRUE(program.wait_for_line("0 of 120 parts"));
  ASSERT_TRUE(program.wait_for_line(""));
  program.send(SIGTERM);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 143);
  EXPECT_NE(rest.find("the same command goes on"), std::string::npos) << rest;
  const ProgramRun status = run_program("batch status" + words("kept"));
  EXPECT_EQ(status.status, 0);
  EXPECT_FALSE(status.out.starts_with("0 of 120 parts")) << status.out;
  const ProgramRun again = run_program("batch" + words("kept"));
  EXPECT_EQ(again.status, 0);
  EXPECT_EQ(again.out.find("120 in this run"), std::string::npos) << again.out;
  EXPECT_NE(again.out.find("120 of 120 parts have a result"), std::string::npos) << again.out;
}

TEST_F(BatchProgram, RefusesInOneLineAndWritesNothing) {
  const std::vector<std::pair<std::string, std::string>> batches = {
      {R"({"objects": ["meshes/"], "hands": ["franka_hand"], "wands": 1})", "wands"},
      {R"({"objects": ["none/*.obj"], "hands": ["franka_hand"]})", "objects[0]"},
      {R"({"objects": ["meshes/cube.obj", "meshes/"], "hands": ["franka_hand"]})", "cube"},
      {R"({"objects": ["meshes/"], "hands": ["tentacle"]})", "hands[0]"},
      {R"({"objects": ["meshes/"], "hands": ["franka_hand"])", "batch.json"}};
  for (const auto& [text, complaint] : batches) {
    write(text);
    expect_refused(run_program("batch" + words("out")), complaint);
  }
  write(kSmallBatch);
  for (const char* shard : {"0/2", "3/2", "1", "x/2"}) {
    expect_refused(run_program("batch" + words("out") + " --shard " + shard), "--shard");
  }
  EXPECT_FALSE(fs::exists(home_ / "out"));
  expect_refused(run_program("batch" + words("meshes")), "not of a batch");
  expect_refused(run_program("batch"), "batch file");
  expect_refused(run_program("batch '" + (home_ / "none.json").string() + "'"), "none.json");
  EXPECT_EQ(files_below(home_ / "meshes").size(), 2U);
}

TEST_F(BatchProgram, OfAnotherBatchIsRefused) {
  ASSERT_EQ(run_program("batch" + words("out") + " --shard 1/9").status, 0);
  const auto before = files_below(home_ / "out");
  fs::copy(file(), home_ / "other.json");
  expect_refused(run_program("batch '" + (home_ / "other.json").string() + "' -o '" +
                             (home_ / "out").string() + "'"),
                 "belongs to another batch");
  EXPECT_TRUE(files_below(home_ / "out") == before);
}

// From a batch to a model to a plan that uses it.
TEST_F(BatchProgram, IsLearntFrom) {
  write(R"({"objects": ["meshes/", {"generate": ["bottle", "box"], "triangles": 200}],
            "hands": ["franka_hand"], "settings": [{"accuracy": "draft", "trials": 60}]})");
  ASSERT_EQ(run_program("batch" + words("out")).status, 0);
  ASSERT_EQ(run_program("batch merge" + words("out") + " --formats acronym --pictures 0").status,
            0);
  const std::string model = (home_ / "model.json").string();
  const std::string learn =
      "learn '" + (home_ / "out/merged/acronym").string() + "' -o '" + model + "'";
  const ProgramRun learnt = run_program(learn);
  if (learnt.err.find("libxgboost-dev") != std::string::npos) {
    GTEST_SKIP() << "built without xgboost";
  }
  ASSERT_EQ(learnt.status, 0) << learnt.err;
  EXPECT_NE(learnt.out.find("4 objects and 1 hands"), std::string::npos) << learnt.out;
  const std::string first = content(model);
  ASSERT_EQ(run_program(learn).status, 0);
  EXPECT_EQ(content(model), first);

  const std::string plan = "plan mug --trials 40 --no-report --model '" + model + "' --out '" +
                           (home_ / "plan").string() + "' --hand ";
  ASSERT_EQ(run_program(plan + "franka_hand").status, 0);
  EXPECT_NE(content(home_ / "plan/grasps.json").find("\"learned\""), std::string::npos);
  std::filesystem::remove_all(home_ / "plan");
  expect_refused(run_program(plan + "barrett"), "model.json");
  EXPECT_FALSE(fs::exists(home_ / "plan"));
  // A batch with a hand that the model does not know writes nothing, either.
  write(R"({"objects": ["meshes/"], "hands": ["barrett"], "settings": [{"model": "model.json"}]})");
  expect_refused(run_program("batch" + words("other")), "settings \"standard\"");
  EXPECT_FALSE(fs::exists(home_ / "other"));
}

}  // namespace
}  // namespace prehend::test
