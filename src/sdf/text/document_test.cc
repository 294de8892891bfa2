#include "sdf/text/document.hh"

#include <gtest/gtest.h>

namespace pongsim::sdf {
namespace {

class Document : public ::testing::Test {
 protected:
  std::optional<Element> parse(std::string_view text) {
    return parseDocument(text, std::make_shared<const std::string>("d.sdf"), diagnostics_);
  }

  std::string message() const { return diagnostics_.all().size() == 1 ? format(diagnostics_.all()[0]) : ""; }

  Diagnostics diagnostics_;
};

std::pair<int, int> place(const SourcePosition& position) { return {position.line, position.column}; }

TEST_F(Document, KnowsLineAndColumnOfElementsAndAttributes) {
  const auto root =
      parse("<?xml version=\"1.0\"?>\n<!-- c -->\n<sdf\n   version=\"1.9\">\n  <a/> <b x=\"1\" y=\"2\"/></sdf>");
  ASSERT_TRUE(root);
  EXPECT_EQ(place(root->position), std::pair(3, 1));
  EXPECT_EQ(place(root->attributes.at(0).position), std::pair(4, 4));
  EXPECT_EQ(place(root->children.at(0).position), std::pair(5, 3));
  EXPECT_EQ(place(root->children.at(1).position), std::pair(5, 8));
  EXPECT_EQ(place(root->children.at(1).attributes.at(1).position), std::pair(5, 17));
  EXPECT_EQ(*root->position.file, "d.sdf");
}

TEST_F(Document, KnowsColumnsWhateverStandsFirst) {
  for (const char* start : {"<!-- c -->", "<!DOCTYPE sdf>", "\xEF\xBB\xBF", "  \t", "<?xml version=\"1.0\"?>"}) {
    const auto root = parse(std::string(start) + "\n<sdf>\r\n <a/></sdf>");
    ASSERT_TRUE(root) << start;
    EXPECT_EQ(place(root->position), std::pair(2, 1)) << start;
    EXPECT_EQ(place(root->children.at(0).position), std::pair(3, 2)) << start;
  }
}

TEST_F(Document, CountsCharactersNotBytes) {
  const auto root = parse("<sdf><!-- \xC3\xA4\xE2\x82\xAC --><a/></sdf>");
  ASSERT_TRUE(root);
  EXPECT_EQ(place(root->children.at(0).position), std::pair(1, 17));
}

TEST_F(Document, KeepsTextWithoutTheWhiteSpaceAroundIt) {
  const auto root = parse("<sdf>\n <a>  1 2\n </a><b>x &lt; y</b><c><![CDATA[<z>]]></c><d>1 <!-- and --> 2</d></sdf>");
  ASSERT_TRUE(root);
  EXPECT_EQ(root->children.at(0).text, "1 2");
  EXPECT_EQ(root->children.at(1).text, "x < y");
  EXPECT_EQ(root->children.at(2).text, "<z>");
  EXPECT_EQ(root->children.at(3).text, "1  2");
}

TEST_F(Document, TakesWhatFortressTakes) {
  const auto root = parse("<sdf><!-- a -- b --><a ignition:expressed_in=\"x\"/>\" stray <b/></sdf>");
  ASSERT_TRUE(root);
  EXPECT_EQ(root->children.size(), 2U);
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(Document, FindsSdfAmongSeveralRoots) {
  const auto root = parse("<other/><sdf/>");
  ASSERT_TRUE(root);
  EXPECT_EQ(root->name, "sdf");
  EXPECT_EQ(place(root->position), std::pair(1, 9));
}

TEST_F(Document, NamesTheTagThatIsNotClosed) {
  EXPECT_FALSE(parse("<sdf>\n  <world>\n    <model>\n  </world>\n</sdf>"));
  EXPECT_EQ(message(),
            "d.sdf:4:3: error: </world> stands where </model> should be\n"
            "  hint: <model> was opened in line 3, column 5, and is not closed");
}

TEST_F(Document, RefusesAZeroByte) {
  EXPECT_FALSE(parse(std::string_view("<sdf>\n\0</sdf>", 13)));
  EXPECT_EQ(message(), "d.sdf:2:1: error: the text contains a zero byte\n  hint: is this a text file, in UTF-8?");
}

TEST_F(Document, RefusesControlCharactersHoweverTheyAreWritten) {
  parse("<sdf>\n <a name=\"x\x1b[31m\"/></sdf>");
  EXPECT_EQ(message(), "d.sdf:2:5: error: it contains the control character U+001B\n  hint: XML does not allow it");
  diagnostics_ = Diagnostics();
  parse("<sdf><a>&#27;</a></sdf>");
  EXPECT_EQ(message(), "d.sdf:1:6: error: it contains the control character U+001B\n  hint: XML does not allow it");
  diagnostics_ = Diagnostics();
  EXPECT_TRUE(parse("<sdf><a b='\t'>x\ty\r\n\xC3\xA4</a></sdf>"));
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(Document, TakesAttributesToTheLimitAndNoMore) {
  const auto wide = [](int count, const std::string& before) {
    std::string text = "<sdf>\n" + before + "<a";
    for (int i = 0; i < count; ++i) text += " b" + std::to_string(i) + "=\"it's > 1\"";
    return text + "/></sdf>";
  };
  EXPECT_TRUE(parse(wide(1000, "")));
  EXPECT_FALSE(parse(wide(1001, "<!-- \" > -->")));
  EXPECT_EQ(message(), "d.sdf:2:13: error: an element has more than 1000 attributes, which is the limit");
  // in a time that grows with the text, not with its square
  EXPECT_FALSE(parse(wide(1'000'000, "<![CDATA[ < ' ]]>")));
}

TEST_F(Document, RefusesATextWithoutElements) {
  EXPECT_FALSE(parse(" \n "));
  EXPECT_EQ(message(), "d.sdf: error: this file contains no XML");
}

TEST_F(Document, TakesNestingToTheLimitAndNoDeeper) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "<a>";
    for (int i = 0; i < depth; ++i) text += "</a>";
    return text;
  };
  EXPECT_TRUE(parse(nested(98)));
  EXPECT_FALSE(parse(nested(99)));
  EXPECT_EQ(message(), "d.sdf:1:295: error: elements nest more than 98 deep");
}

TEST_F(Document, WarnsOfEntitiesThatItWillNotExpand) {
  const auto root = parse("<!DOCTYPE x [\n <!ENTITY e \"123\"> ]>\n<sdf><a>&e;&lt;</a></sdf>");
  ASSERT_TRUE(root);
  EXPECT_EQ(root->children.at(0).text, "&e;<");
  EXPECT_EQ(message(),
            "d.sdf:2:2: warning: entities are not expanded: '&NAME;' stays as it is\n"
            "  hint: as in Fortress; write its text instead");
}

}  // namespace
}  // namespace pongsim::sdf
