#include "sdf/text/xml_fault.hh"

#include <gtest/gtest.h>

namespace pongsim::sdf {
namespace {

/// @return "offset: message | hint"
std::string fault(std::string_view text) {
  const std::optional<XmlFault> found = findXmlFault(text);
  if (!found) return "none";
  return std::to_string(found->offset) + ": " + found->message + (found->hint.empty() ? "" : " | " + found->hint);
}

TEST(XmlFault, FindsNoneInWellFormedText) {
  EXPECT_EQ(fault("<?xml version='1.0'?><!-- <b> --><a x='>' y=\"'\"><![CDATA[<c>]]><b/></a >"), "none");
}

TEST(XmlFault, NamesTheTagLeftOpen) {
  EXPECT_EQ(fault("<a><b></b>"), "0: <a> is not closed | the file ends before its </a>");
  EXPECT_EQ(fault("<a><b></a>"),
            "6: </a> stands where </b> should be | <b> was opened in line 1, column 4, and is not closed");
  EXPECT_EQ(fault("<a></a></b>"), "7: </b> closes nothing | no <b> is open here");
  EXPECT_EQ(fault("<a x='1'"), "0: the tag <a is not closed with >");
  EXPECT_EQ(fault("<a></a"), "3: </a is not closed with >");
}

TEST(XmlFault, NamesTheMarkLeftOpen) {
  EXPECT_EQ(fault("<a><!-- </a>"), "3: <!-- is not closed with -->");
  EXPECT_EQ(fault("<a><!--></a>"), "3: <!-- is not closed with -->");
  EXPECT_EQ(fault("<a><![CDATA[</a>"), "3: <![CDATA[ is not closed with ]]>");
  EXPECT_EQ(fault("<?xml"), "0: <? is not closed with ?>");
}

TEST(XmlFault, NamesTheWrongAttribute) {
  EXPECT_EQ(fault("<a x=1>"), "3: the value of attribute 'x' in <a> has no quotes around it");
  EXPECT_EQ(fault("<a x>"), "3: attribute 'x' in <a> has no value");
  EXPECT_EQ(fault("<a x='1>"), "3: the value of attribute 'x' in <a> has no closing quote");
  EXPECT_EQ(fault("<a x='1' x='2'>"), "9: attribute 'x' in <a> is given twice");
  EXPECT_EQ(fault("<a ='1'>"), "3: '=' where an attribute was expected in <a>");
}

TEST(XmlFault, ExplainsStrayMarks) {
  EXPECT_EQ(fault("<a>1 < 2</a>"), "5: '<' does not begin a tag | in text, write &lt; for '<'");
  EXPECT_EQ(fault("<a><?xml?></a>"), "3: <?...?> must be at the beginning of the file | move it to the first line");
  EXPECT_EQ(fault(" hello"), "1: the file does not begin with a tag | is this an SDF file?");
}

}  // namespace
}  // namespace pongsim::sdf
