// Two programs that submit the same batch, and disks that fail while one does.
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/faulty_runs.h"
#include "tests/program/program.h"
#include "tests/program/running_program.h"

namespace prehend::test {
namespace {

// A queue of Slurm that is three scripts: what is submitted waits until it is cancelled.
struct FakeSlurm : testing::Test {
  std::filesystem::path folder = fresh_folder("fake_slurm");
  std::filesystem::path bin = folder / "bin";
  std::filesystem::path queue = folder / "queue";

  FakeSlurm() {
    write_fault_inputs(folder);
    std::filesystem::create_directories(queue);
    const std::string home = "cd '" + queue.string() + "'\n";
    script("sbatch", home + "sleep 0.2\nid=$$\n: > $id\necho $id\n");
    script("scancel", home + "rm -f \"$@\"\n");
    script("squeue", home + "for id in *; do echo \"$id 1 PENDING 0\"; done\n");
    script("sacct", "exit 1\n");
    ::setenv("PATH", (bin.string() + ":" + path_).c_str(), 1);
  }
  ~FakeSlurm() override { ::setenv("PATH", path_.c_str(), 1); }
  void script(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(bin);
    std::ofstream(bin / name) << "#!/bin/bash\n" << text;
    std::filesystem::permissions(bin / name, std::filesystem::perms::owner_all);
  }
  std::vector<std::string> words() const {
    return {"batch",
            "submit",
            (folder / "batch.json").string(),
            "-o",
            (folder / "out").string(),
            "--shards",
            "2",
            "--no-merge"};
  }
  ProgramRun submit_to_queue(const std::string& before = "") const {
    std::string text;
    for (const std::string& word : words()) text += "'" + word + "' ";
    return run_program(text, before + "'" PREHEND_PROGRAM "'");
  }
  std::size_t queued() const {
    const std::filesystem::directory_iterator files(queue);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

 private:
  std::string path_ = ::getenv("PATH");
};

TEST_F(FakeSlurm, OfThreeAtOnceOneSubmits) {
  std::vector<std::unique_ptr<RunningProgram>> programs;
  for (int i = 0; i < 3; ++i) {
    const std::filesystem::path own = folder / ("process" + std::to_string(i));
    std::filesystem::create_directories(own);
    programs.push_back(std::make_unique<RunningProgram>(words(), own));
  }
  int submitted = 0;
  for (const auto& program : programs) {
    std::string said;
    if (program->wait(said) == 0) {
      ++submitted;
    } else {
      EXPECT_NE(said.find("a job of this folder"), std::string::npos) << said;
    }
  }
  EXPECT_EQ(submitted, 1);
  EXPECT_EQ(queued(), 1U);
  // It is known, so that a later one is refused as well.
  expect_refused(submit_to_queue(), "a job of this folder still waits or runs");
}

TEST_F(FakeSlurm, NoJobThatNobodyKnowsWaitsAfterAFaultOfTheDisk) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer wants to be loaded before all other libraries";
#endif
  int failed = 0;
  for (int call = 1; call < 60; ++call) {
    std::filesystem::remove_all(folder / "out");
    std::filesystem::remove_all(queue);
    std::filesystem::create_directories(queue);
    const ProgramRun run = submit_to_queue("FAIL_CALL=" + std::to_string(call) +
                                           " FAIL_HOW=full LD_PRELOAD='" PREHEND_FAIL_CALLS "' ");
    SCOPED_TRACE("call " + std::to_string(call) + ": " + run.err);
    if (run.status == 0) {
      EXPECT_EQ(queued(), 1U);
      break;
    }
    ++failed;
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(queued(), 0U);
    EXPECT_NE(run.err.find("No space left on device"), std::string::npos);
  }
  EXPECT_GT(failed, 5);
}

}  // namespace
}  // namespace prehend::test
