#include "benchmarks/report/hands_page.h"

#include <string>

#include <gtest/gtest.h>

namespace prehend::bench {
namespace {

bool says(const std::string& page, const std::string& line) {
  return page.find(line + "\n") != std::string::npos;
}

TEST(HandsPage, CountsTheObjectsOfAHandsSize) {
  const std::string page = hands_page({{"jaw", "can", true, 0.2, 1.0, 40, "cylinder end"},
                                       {"jaw", "pen", true, 0.0, 3.0, 0, ""},
                                       {"jaw", "ball", true, 0.1, 2.0, 7, "sphere"},
                                       {"jaw", "sofa", false, 0.0, 9.0, 0, ""},
                                       {"claw", "sofa", true, 0.5, 4.0, 1, "box faces"}});
  EXPECT_TRUE(says(page, "| jaw | 2 of 3 | 0.1 | 2 s | pen |")) << page;
  EXPECT_TRUE(says(page, "| claw | 1 of 1 | 0.5 | 4 s |  |")) << page;
  EXPECT_TRUE(says(page, "| jaw | can | 0.2 | 40 | 1 s | cylinder end |")) << page;
  EXPECT_TRUE(says(page, "| jaw | sofa (not of its size) | – | 0 | 9 s |  |")) << page;
}

TEST(HandsPage, AHandWithoutAnObjectOfItsSize) {
  const std::string page = hands_page({{"jaw", "sofa", false, 0.0, 9.0, 0, ""}});
  EXPECT_TRUE(says(page, "| jaw | 0 of 0 | – | – |  |")) << page;
}

}  // namespace
}  // namespace prehend::bench
