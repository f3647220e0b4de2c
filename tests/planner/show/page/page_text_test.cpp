#include "planner/show/page/page_text.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace prehend {
namespace {

TEST(PageText, DataStandWherePagesHaveAPlaceForThem) {
  EXPECT_EQ(page_with_data("a/*DATA*/b/*DATA*/", "{}"), "a{}b/*DATA*/");
  EXPECT_THROW(page_with_data("a", "{}"), std::logic_error);
}

TEST(PageText, DataEndNoScriptElement) {
  EXPECT_EQ(page_with_data("/*DATA*/", R"({"name":"</script><!--"})"),
            R"({"name":"\u003c/script>\u003c!--"})");
}

TEST(PageText, AValueStandsWhereverItsNameDoes) {
  EXPECT_EQ(page_with("{{a}} {{b}} {{a}}", "a", "{{a}}!"), "{{a}}! {{b}} {{a}}!");
  EXPECT_EQ(page_with("", "a", "b"), "");
}

}  // namespace
}  // namespace prehend
