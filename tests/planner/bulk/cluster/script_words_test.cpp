// Words that have all that shells, GNU parallel and Slurm could take for something else.
#include "planner/bulk/cluster/script_words.h"

#include <gtest/gtest.h>

#include "planner/bulk/cluster/run_words.h"
#include "tests/planner/bulk/cluster/awkward_words.h"

namespace prehend::test {
namespace {

TEST(ShellWord, IsTheTextInAShell) {
  for (const std::string& text : awkward_words()) {
    for (const std::string shell : {"sh", "bash"}) {
      EXPECT_EQ(printed_by({shell, "-c", "printf %s. " + shell_word(text)}), text + ".") << shell;
    }
  }
}

TEST(ParallelWord, IsTheTextInACommandOfParallel) {
  if (!has_program("parallel")) GTEST_SKIP() << "there is no GNU parallel";
  std::string command = "printf %s. ";
  std::string expected;
  for (const std::string& text : awkward_words()) {
    command += parallel_word(text) + " ";
    expected += text + ".";
  }
  command += "{}";
  EXPECT_EQ(printed_by({"parallel", "--plain", "--will-cite", command, ":::", "7"}),
            expected + "7.");
}

TEST(ParallelWord, IsTheTextInAShell) {
  for (const std::string& text : awkward_words()) {
    EXPECT_EQ(printed_by({"bash", "-c", "printf %s. " + parallel_word(text)}), text + ".");
  }
}

// What Slurm makes of it is tried in tests/cluster; here, the rule that it is made by.
TEST(SbatchWord, HasABackslashBeforeWhatEndsIt) {
  EXPECT_EQ(sbatch_word("a b"), "\"a b\"");
  EXPECT_EQ(sbatch_word(R"(a"b'c\d)"), R"("a\"b\'c\\d")");
}

}  // namespace
}  // namespace prehend::test
