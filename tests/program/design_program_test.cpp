// `prehend design`: a measure of a hand varied.
#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

TEST(DesignProgram, WritesATableAndAPage) {
  const std::filesystem::path folder = fresh_folder("design");
  const std::string words = "design parallel_jaw mug --vary hand.friction=0.3:0.9:3 --out ";
  const ProgramRun run = run_program(words + (folder / "one").string());
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string csv = content(folder / "one/design.csv");
  EXPECT_EQ(csv.find("hand.friction,object,epsilon,stable,trials,opening_m,problem\n0.3,mug,"), 0U)
      << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  EXPECT_EQ(content(folder / "one/design.html").find("<!DOCTYPE html>"), 0U);
  const ProgramRun plain = run_program(words + (folder / "two").string() + " --no-report");
  EXPECT_EQ(plain.status, 0) << plain.err;
  EXPECT_EQ(content(folder / "two/design.csv"), csv);
  EXPECT_FALSE(std::filesystem::exists(folder / "two/design.html"));
}

TEST(DesignProgram, RefusesWhatCannotBeVaried) {
  const std::string out = " --out " + fresh_folder("design_refused").string();
  expect_refused(run_program("design barrett mug --vary finger.weight=1:2" + out), "--vary");
  expect_refused(run_program("design barrett mug --vary ring.length=1:2" + out), "proximal_1");
  expect_refused(run_program("design barrett shelf --vary hand.size=1:2" + out), "arm");
  expect_refused(run_program("design barrett mug" + out), "--vary");
}

}  // namespace
}  // namespace prehend::test
