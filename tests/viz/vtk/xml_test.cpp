#include "viz/vtk/xml.h"

#include <gtest/gtest.h>

#include <string>

namespace gnomon::viz {
namespace {

const std::string replacement = "\xef\xbf\xbd";

TEST(XmlEscaped, LeavesPlainTextAndCharactersOfAnyLanguageAsTheyAre) {
  for (const std::string text : {"lamp", "", "Lampe Küche", "灯", "\xf0\x9f\x92\xa1", "a b", "\xef\xbf\xbd"}) {
    EXPECT_EQ(xml_escaped(text), text);
  }
}

TEST(XmlEscaped, WritesMarkupByItsNumber) {
  EXPECT_EQ(xml_escaped("<a href=\"x\">&'"), "&#60;a href=&#34;x&#34;&#62;&#38;&#39;");
  EXPECT_EQ(xml_escaped("a\tb\nc\r"), "a&#9;b&#10;c&#13;");
}

TEST(XmlEscaped, ReplacesWhatXmlCannotHold) {
  EXPECT_EQ(xml_escaped("a\x01z"), "a" + replacement + "z");
  EXPECT_EQ(xml_escaped(std::string("\0", 1)), replacement);
  EXPECT_EQ(xml_escaped("\x1b[31m"), replacement + "[31m");
  EXPECT_EQ(xml_escaped("\xef\xbf\xbe"), replacement + replacement + replacement) << "U+FFFE";
  EXPECT_EQ(xml_escaped("\xef\xbf\xbf"), replacement + replacement + replacement) << "U+FFFF";
}

TEST(XmlEscaped, ReplacesBytesThatAreNotUtf8) {
  EXPECT_EQ(xml_escaped("caf\xe9"), "caf" + replacement) << "Latin-1, at the end";
  EXPECT_EQ(xml_escaped("\xe9t\xe9."), replacement + "t" + replacement + ".");
  EXPECT_EQ(xml_escaped("\xc0\x80"), replacement + replacement) << "a zero in two bytes";
  EXPECT_EQ(xml_escaped("\xed\xa0\x80"), replacement + replacement + replacement) << "half of a surrogate pair";
  EXPECT_EQ(xml_escaped("\xf5\x80\x80\x80"), replacement + replacement + replacement + replacement)
      << "beyond U+10FFFF";
  EXPECT_EQ(xml_escaped("\x80"), replacement);
}

}  // namespace
}  // namespace gnomon::viz
