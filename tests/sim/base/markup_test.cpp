#include "sim/base/markup.h"

#include <gtest/gtest.h>

namespace prehend {
namespace {

TEST(Markup, ReservedCharactersAreReplaced) {
  EXPECT_EQ(markup_text("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(markup_text("<script>"), "&lt;script&gt;");
}

TEST(Markup, ControlCharactersBecomeSpacesAndOthersStay) {
  EXPECT_EQ(markup_text("a\tb\nc\x7f"), "a b c ");
  EXPECT_EQ(markup_text("\u03b5 \u2264 1"), "\u03b5 \u2264 1");
}

}  // namespace
}  // namespace prehend
