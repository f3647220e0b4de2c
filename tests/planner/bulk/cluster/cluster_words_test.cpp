#include "planner/bulk/cluster/cluster_words.h"

#include <gtest/gtest.h>

#include "sim/base/input_error.h"

namespace prehend::test {
namespace {

TEST(SlurmSeconds, ReadsAllForms) {
  EXPECT_EQ(slurm_seconds("90"), 5400);
  EXPECT_EQ(slurm_seconds("90:30"), 5430);
  EXPECT_EQ(slurm_seconds("4:00:00"), 14400);
  EXPECT_EQ(slurm_seconds("2-12"), 2 * 86400 + 12 * 3600);
  EXPECT_EQ(slurm_seconds("2-12:30"), 2 * 86400 + 12 * 3600 + 1800);
  EXPECT_EQ(slurm_seconds("2-12:30:05"), 2 * 86400 + 12 * 3600 + 1805);
}

TEST(SlurmSeconds, RefusesOtherWords) {
  for (const char* words : {"", "0", "0:00", "4h", "-5", "1:2:3:4", "1-2:3:4:5", "1-", ":5",
                            "5:", "1.5", " 5", "99999999999999999999", "400-0", "1--2"}) {
    EXPECT_THROW(slurm_seconds(words), InputError) << words;
  }
}

TEST(SlurmMegabytes, ReadsUnits) {
  EXPECT_EQ(slurm_megabytes("4000"), 4000);
  EXPECT_EQ(slurm_megabytes("4000M"), 4000);
  EXPECT_EQ(slurm_megabytes("4G"), 4096);
  EXPECT_EQ(slurm_megabytes("1T"), 1048576);
  EXPECT_EQ(slurm_megabytes("1K"), 1);
  EXPECT_EQ(slurm_megabytes("1025K"), 2);
}

TEST(SlurmMegabytes, RefusesOtherWords) {
  for (const char* words :
       {"", "G", "0", "0G", "-1G", "4GB", "4 G", "1.5G", "1001T", "999999999T"}) {
    EXPECT_THROW(slurm_megabytes(words), InputError) << words;
  }
}

}  // namespace
}  // namespace prehend::test
