#include "sim/base/xml/xml_maker.h"

#include <gtest/gtest.h>

#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

TEST(XmlMaker, ElementsKnowWhereTheyWereWritten) {
  const XmlFile whole("whole.xml", "<a>\n<b x=\"1\"/>\n</a>");
  const XmlFile part("folder/part.xml", "<p>\n\n<c y=\"two &amp; 3\">\n<d> text </d></c></p>");
  XmlMaker maker("whole.xml");
  maker.open(whole.root());
  maker.attribute("name", "made");
  maker.copy(whole.root()["b"]);
  maker.copy(part.root()["c"]);
  maker.close();
  const XmlFile made = maker.finished();
  EXPECT_EQ(made.root().text("name"), "made");
  EXPECT_EQ(made.root()["b"].number("x"), 1.0);
  EXPECT_EQ(made.root()["c"].text("y"), "two & 3");
  EXPECT_EQ(made.root()["c"]["d"].content(), "text");
  EXPECT_EQ(made.root()["b"].place(), "line 2, <b>");
  EXPECT_EQ(made.root()["c"]["d"].place(), "part.xml line 4, <d>");
  // Made of made: the place stays.
  XmlMaker again("other.xml");
  again.copy(made.root());
  const XmlFile twice = again.finished();
  EXPECT_EQ(twice.root()["c"].place(), "part.xml line 3, <c>");
  EXPECT_EQ(twice.root()["b"].place(), "whole.xml line 2, <b>");
}

TEST(XmlMaker, GrowsToABound) {
  const XmlFile file("a.xml", "<a/>");
  const auto complaint = [](const auto& call) {
    return std::string(test::refusal_of(call).what());
  };
  EXPECT_NE(complaint([&] {
              XmlMaker maker("a.xml");
              for (int k = 0; k < 200; ++k) maker.open(file.root());
            }).find("a.xml: line 1, <a>: elements are nested too deeply"),
            std::string::npos);
  EXPECT_NE(complaint([&] {
              XmlMaker maker("a.xml");
              maker.open(file.root());
              for (int k = 0; k < 300000; ++k) maker.copy(file.root());
            }).find("50000 elements"),
            std::string::npos);
}

}  // namespace
}  // namespace prehend
