// What is counted over the grasps of a batch, and which of them are drawn.
#include "planner/bulk/batch_summary.h"

#include <algorithm>
#include <cctype>
#include <numeric>

#include <gtest/gtest.h>

#include "planner/bulk/batch_pictures.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"

namespace prehend {
namespace {

GraspSet set_of(Random& random, int grasps) {
  GraspSet set;
  set.hand = random.uniform() < 0.5 ? "one" : "two";
  for (int i = 0; i < grasps; ++i) {
    GraspSetEntry grasp;
    if (random.uniform() < 0.4) {
      grasp.outcome = Outcome::stable;
      grasp.epsilon = {random.uniform(), 1.0};
      grasp.contacts.resize(random.index(40));
    }
    set.grasps.push_back(grasp);
  }
  return set;
}

std::size_t sum(const Histogram& histogram) {
  return std::accumulate(histogram.bins.begin(), histogram.bins.end(), std::size_t{0});
}

TEST(BatchTally, CountsEveryGraspOnceInWhateverOrder) {
  Random random(3);
  std::vector<GraspSet> sets;
  std::size_t grasps = 0;
  for (int i = 0; i < 30; ++i) {
    sets.push_back(set_of(random, random.integer(0, 50)));
    grasps += sets.back().grasps.size();
  }
  BatchTally forwards;
  BatchTally backwards;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    forwards.add("object" + std::to_string(i % 7), sets[i]);
    const std::size_t j = sets.size() - 1 - i;
    BatchTally one;
    one.add("object" + std::to_string(j % 7), sets[j]);
    backwards.add(one);
  }
  EXPECT_EQ(forwards.sets, sets.size());
  EXPECT_EQ(forwards.outcomes.all(), grasps);
  EXPECT_EQ(sum(forwards.epsilon), forwards.outcomes.stable());
  forwards.count_shares();
  EXPECT_EQ(sum(forwards.objects_by_share), forwards.objects.size());
  EXPECT_EQ(forwards.outcomes.of, backwards.outcomes.of);
  EXPECT_EQ(forwards.epsilon.bins, backwards.epsilon.bins);
  EXPECT_EQ(forwards.contacts.bins, backwards.contacts.bins);
  for (const auto& [name, counts] : forwards.objects) {
    EXPECT_EQ(counts.of, backwards.objects.at(name).of);
  }
}

TEST(GraspLottery, ChoosesTheSameInWhateverOrder) {
  Random random(5);
  std::vector<GraspSet> sets;
  for (int i = 0; i < 50; ++i) sets.push_back(set_of(random, 10));
  GraspLottery forwards(6);
  GraspLottery backwards(6);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::size_t j = sets.size() - 1 - i;
    forwards.add(i, std::to_string(i), sets[i], true);
    GraspLottery one(1);
    one.add(j, std::to_string(j), sets[j], true);
    backwards.add(one);
  }
  ASSERT_EQ(forwards.chosen().size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(forwards.chosen()[i].lot, backwards.chosen()[i].lot);
    EXPECT_EQ(forwards.chosen()[i].part, backwards.chosen()[i].part);
    EXPECT_EQ(forwards.chosen()[i].grasp.outcome, Outcome::stable);
  }
}

TEST(DataCard, NothingOfANameBecomesMarkup) {
  BatchSummary summary;
  summary.name = "<script>alert(1)</script>";
  summary.failed = {{"<b>", "it & that"}};
  summary.tally.objects["<i>"].of[kAll<Outcome>.front()] = 1;
  const std::string page = batch_page(summary);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_EQ(page.find("<i>"), std::string::npos);
  EXPECT_NE(page.find("it &amp; that"), std::string::npos);
}

// Of Markdown as CommonMark and GitHub read it: the text as it stands, without its backslashes, and
// whether any character of it would be read as markup.
std::string read_as_text(const std::string& markdown, bool& has_markup) {
  std::string text;
  for (std::size_t i = 0; i < markdown.size(); ++i) {
    if (markdown[i] == '\\' && i + 1 < markdown.size()) {
      text += markdown[++i];
      continue;
    }
    const bool is_inside = i > 0 && i + 1 < markdown.size() &&
                           std::isalnum(static_cast<unsigned char>(markdown[i - 1])) != 0 &&
                           std::isalnum(static_cast<unsigned char>(markdown[i + 1])) != 0;
    if (std::string("\\`*~[]<>&|#$").find(markdown[i]) != std::string::npos ||
        (markdown[i] == '_' && !is_inside)) {
      has_markup = true;
    }
    text += markdown[i];
  }
  return text;
}

std::string line_after(const std::string& text, const std::string& start) {
  const std::size_t at = text.find(start);
  EXPECT_NE(at, std::string::npos) << start;
  const std::size_t begin = at + start.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(DataCard, ShowsHostileNamesAsTheyAre) {
  const std::vector<std::string> names = {"<script>alert(1)</script>",
                                          "<img src=x onerror=alert(1)>",
                                          "[a](javascript:alert(1))",
                                          "![](http://host/pixel.png)",
                                          "`code`",
                                          "**bold** __also__ _x_ ~~gone~~",
                                          "a | b |---|",
                                          "&lt;b&gt; &#60;",
                                          "name #",
                                          "\\",
                                          "\\<b>",
                                          "$x$",
                                          "_",
                                          "a\n# heading\n\n```\n<b>",
                                          "\r\n- x"};
  for (const std::string& name : names) {
    BatchSummary summary;
    summary.name = name;
    summary.licence = name;
    summary.axes = {name};
    summary.tally.hands[name] = {};
    const std::string card = data_card(summary);
    for (const std::string& line :
         {line_after(card, "# "), line_after(card, "part of the data set: "),
          line_after(card, "## What was planned\n\n- ")}) {
      bool has_markup = false;
      EXPECT_EQ(read_as_text(line, has_markup), on_one_line(name));
      EXPECT_FALSE(has_markup) << line;
    }
    bool has_markup = false;
    const std::string cell = line_after(card, "share |\n|---|---:|---:|---:|\n| ");
    EXPECT_EQ(read_as_text(cell.substr(0, cell.find(" | 0 | 0 |")), has_markup), on_one_line(name));
    EXPECT_FALSE(has_markup) << cell;
  }
}

TEST(DataCard, LeavesPlainNamesPlain) {
  BatchSummary summary;
  summary.axes = {"hands: 2 (franka_hand, parallel-jaw.v2)"};
  EXPECT_NE(data_card(summary).find("- hands: 2 (franka_hand, parallel-jaw.v2)\n"),
            std::string::npos);
}

TEST(DataCard, SaysWhatIsMissing) {
  BatchSummary summary;
  summary.parts = 10;
  summary.open = 4;
  EXPECT_NE(data_card(summary).find("4 of 10 parts were not planned yet"), std::string::npos);
  EXPECT_NE(data_card(summary).find("licence of the meshes was not stated"), std::string::npos);
  summary.open = 0;
  summary.licence = "CC0";
  EXPECT_EQ(data_card(summary).find("not planned yet"), std::string::npos);
  EXPECT_NE(data_card(summary).find("CC0"), std::string::npos);
}

}  // namespace
}  // namespace prehend
