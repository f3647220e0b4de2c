// Giving batches to clusters, as far as that needs none; tests/cluster has the rest.
#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

const char* const kBatch = R"({"objects": [{"generate": "box"}], "hands": ["franka_hand"]})";

struct BatchSubmit : testing::Test {
  std::filesystem::path folder = fresh_folder("batch_submit");
  std::string words =
      "'" + (folder / "b.json").string() + "' -o '" + (folder / "out").string() + "' --shards 8 ";

  BatchSubmit() { std::ofstream(folder / "b.json") << kBatch; }
  ProgramRun submit(const std::string& more) const {
    return run_program("batch submit " + words + more);
  }
};

TEST_F(BatchSubmit, PrintsTheScriptsAndDoesNothing) {
  const ProgramRun run = submit("--dry-run --cores 2 --memory 8G --time 4:00:00");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("#!/bin/bash\n#SBATCH ")) << run.out;
  for (const char* part : {"--array=1-8\n", "--mem=8192M\n", "--time=0-04:00:00\n",
                           "/8\" --threads 2 ", " batch merge '"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(submit("--dry-run --no-merge").out.find("batch merge"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_F(BatchSubmit, RefusesInOneLine) {
  expect_refused(submit("--dry-run --time 4h"), "--time: ");
  expect_refused(submit("--dry-run --memory lots"), "--memory: ");
  expect_refused(submit("--dry-run --engine parallel --time 60"), "slurm only");
  expect_refused(submit("--dry-run --engine other"), "--engine");
  expect_refused(submit("--dry-run --partition 'a b'"), "partition: ");
  expect_refused(run_program("batch submit /no-such-file -o " + folder.string() + " --shards 1"),
                 "/no-such-file: cannot be read: no such file");
}

// Where a program of the engine is looked for, but is not.
TEST_F(BatchSubmit, SaysWhichProgramIsNotThere) {
  const std::string program = std::string("PATH=/nowhere ") + PREHEND_PROGRAM;
  expect_refused(run_program("batch submit " + words, program), "sbatch: is not installed here");
  expect_refused(run_program("batch submit --engine parallel " + words, program),
                 "parallel: is not installed here");
}

TEST_F(BatchSubmit, WithoutAJobThereIsNothingToSayOrToCancel) {
  const ProgramRun queue = run_program("batch queue -o '" + folder.string() + "'");
  EXPECT_EQ(queue.status, 0);
  EXPECT_EQ(queue.out, "no job was submitted from this folder\n");
  expect_refused(run_program("batch cancel -o '" + folder.string() + "'"), "no job was submitted");
}

}  // namespace
}  // namespace prehend::test
