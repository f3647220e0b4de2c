#include "benchmarks/suite/arguments.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "benchmarks/suite/patience.h"
#include "sim/base/input_error.h"

namespace prehend::bench {
namespace {

using Words = std::vector<std::string>;

TEST(Arguments, WithoutWordsAllIsMeasuredAndKept) {
  const Arguments arguments = read_arguments({});
  EXPECT_EQ(arguments.command, Command::run);
  EXPECT_EQ(arguments.parts, (Words{"kernels", "trials", "plans", "trade", "scaling"}));
  EXPECT_EQ(arguments.effort, Effort::full);
  EXPECT_EQ(arguments.folder, "benchmarks/results");
}

TEST(Arguments, WhatIsNotWholeIsNotKept) {
  EXPECT_EQ(read_arguments({"--quick"}).folder, "out/bench");
  const Arguments some = read_arguments({"scaling", "--smoke", "kernels", "--out", "here"});
  EXPECT_EQ(some.parts, (Words{"kernels", "scaling"}));
  EXPECT_EQ(some.effort, Effort::smoke);
  EXPECT_EQ(some.folder, "here");
  EXPECT_EQ(read_arguments({"trade"}).folder, "out/bench");
}

TEST(Arguments, OfComparisonsAndPages) {
  const Arguments compared = read_arguments({"compare", "a.json", "b.json", "--most", "1.25"});
  EXPECT_EQ(compared.command, Command::compare);
  EXPECT_EQ(compared.words, (Words{"a.json", "b.json"}));
  EXPECT_EQ(compared.most, 1.25);
  EXPECT_EQ(read_arguments({"compare", "a", "b"}).most, 1.1);
  EXPECT_EQ(read_arguments({"page", "/some/where/results.json"}).folder, "/some/where");
  EXPECT_EQ(read_arguments({"page", "x.json", "--out", "there"}).folder, "there");
  EXPECT_EQ(read_arguments({"kernels", "--help"}).command, Command::help);
}

TEST(Arguments, RefusesWhatItDoesNotKnow) {
  for (const Words& words : std::vector<Words>{{"--fast"},
                                               {"kernel"},
                                               {"--out"},
                                               {"compare", "a.json"},
                                               {"compare", "a", "b", "c"},
                                               {"compare", "a", "b", "--most", "much"},
                                               {"compare", "a", "b", "--most", "-1"},
                                               {"page"},
                                               {"memory", "triangles"}}) {
    EXPECT_THROW((void)read_arguments(words), InputError) << words.front();
  }
}

TEST(Patience, EndsWhereTheNextSizeWouldTakeTooLong) {
  Patience patience(10.0);
  EXPECT_TRUE(patience.allows(1e9));
  patience.took(100.0, 2.0);
  EXPECT_TRUE(patience.allows(500.0));
  EXPECT_FALSE(patience.allows(501.0));
  patience.took(0.0, 50.0);  // a size of nothing tells nothing
  EXPECT_TRUE(patience.allows(1.0));
}

TEST(Arguments, HandsTakeObjects) {
  const Arguments arguments = read_arguments({"hands", "meshes", "mug.obj", "--out", "there"});
  EXPECT_EQ(arguments.command, Command::hands);
  EXPECT_EQ(arguments.words, (std::vector<std::string>{"meshes", "mug.obj"}));
  EXPECT_EQ(arguments.folder, "there");
  EXPECT_EQ(read_arguments({"hands", "meshes"}).folder, "benchmarks/results");
  EXPECT_THROW(read_arguments({"hands"}), InputError);
}

}  // namespace
}  // namespace prehend::bench
