#include "sim/base/xml/xml_text.h"

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

TEST(Markup, WhatIsNotUtf8BecomesTheReplacementCharacter) {
  EXPECT_EQ(markup_text("B\xFC"
                        "gel \xC3"),
            "B\uFFFDgel \uFFFD");
}

TEST(XmlText, NestsElementsAndEscapesTheirAttributes) {
  XmlText xml;
  xml.open("a", {{"name", "x<\xE9"}});
  xml.comment("1 & 2");
  xml.element("b", {{"value", "1"}, {"unit", "m"}});
  xml.close();
  EXPECT_EQ(xml.text(),
            "<a name=\"x&lt;\uFFFD\">\n  <!-- 1 & 2 -->\n  <b value=\"1\" unit=\"m\"/>\n</a>\n");
}

}  // namespace
}  // namespace prehend
