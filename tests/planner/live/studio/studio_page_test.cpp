#include "planner/live/studio/studio_page.h"

#include <string>

#include <gtest/gtest.h>

namespace prehend {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

// What a policy with a nonce lets run is what shows it: nothing of the page may be without.
TEST(StudioPage, EveryScriptAndStyleShowsTheNonce) {
  const StudioPage page = studio_page("Some-nonce_1");
  const std::size_t elements = count(page.html, "<script") + count(page.html, "<style");
  EXPECT_EQ(elements, 4U);
  EXPECT_EQ(count(page.html, " nonce=\"Some-nonce_1\""), elements);
  EXPECT_EQ(count(page.html, "{{"), 0U);
  EXPECT_NE(page.content_security_policy.find("script-src 'nonce-Some-nonce_1';"),
            std::string::npos);
  EXPECT_EQ(page.content_security_policy.find("unsafe"), std::string::npos);
}

TEST(StudioPage, NothingIsLoadedFromElsewhere) {
  const std::string html = studio_page("n").html;
  for (const char* loads : {" src=", "<link rel=\"stylesheet\"", "@import", "url("}) {
    EXPECT_EQ(count(html, loads), 0U) << loads;
  }
  // Handlers in attributes and style attributes would be refused by the policy, silently.
  for (const char* refused : {" onclick=\"", " style=\""}) EXPECT_EQ(count(html, refused), 0U);
}

}  // namespace
}  // namespace prehend
