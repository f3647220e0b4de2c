#include "planner/bulk/cluster/slurm_queue.h"

#include <gtest/gtest.h>

namespace prehend::test {
namespace {

TEST(ParseQueue, ReadsTasksAndOtherJobs) {
  const std::vector<QueuedTask> tasks = parse_queue(
      "17                      3                       RUNNING                 2           \n"
      "18                      N/A                     PENDING                 0           \n");
  ASSERT_EQ(tasks.size(), 2U);
  EXPECT_EQ(tasks[0].job, "17");
  EXPECT_EQ(tasks[0].task, "3");
  EXPECT_EQ(tasks[0].state, "RUNNING");
  EXPECT_EQ(tasks[0].restarts, 2);
  EXPECT_EQ(tasks[1].task, "N/A");
}

TEST(ParseAccounting, CountsWhatEnded) {
  const std::map<std::string, int> counts =
      parse_accounting("COMPLETED\nCOMPLETED\nRUNNING\nPENDING\nCANCELLED by 1000\nFAILED\n");
  const std::map<std::string, int> expected{{"COMPLETED", 2}, {"CANCELLED", 1}, {"FAILED", 1}};
  EXPECT_EQ(counts, expected);
}

TEST(IsQueuedState, KnowsWhatEnds) {
  for (const char* state : {"PENDING", "RUNNING", "COMPLETING", "REQUEUED", "SUSPENDED"}) {
    EXPECT_TRUE(is_queued_state(state)) << state;
  }
  for (const char* state : {"COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL", "PREEMPTED",
                            "OUT_OF_MEMORY", "DEADLINE", "BOOT_FAIL"}) {
    EXPECT_FALSE(is_queued_state(state)) << state;
  }
}

}  // namespace
}  // namespace prehend::test
