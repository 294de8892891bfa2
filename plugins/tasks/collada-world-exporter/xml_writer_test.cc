#include "xml_writer.hh"

#include <gtest/gtest.h>

#include <sstream>

namespace pongsim::xml_writer_test {
namespace {

TEST(XmlWriter, WritesAnElementALine) {
  std::ostringstream out;
  XmlWriter xml(out);
  xml.begin("a", {{"key", "1 < 2"}});
  xml.add("b");
  xml.begin("c");
  xml.add("d", {{"x", "1"}, {"y", "\"2\""}}, "3 & 4");
  xml.end();
  xml.end();
  EXPECT_EQ(out.str(),
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
            "<a key=\"1 &lt; 2\">\n  <b/>\n  <c>\n    <d x=\"1\" y=\"&quot;2&quot;\">3 &amp; 4</d>\n  </c>\n</a>\n");
}

TEST(XmlWriter, ReplacesWhatXmlCantHold) { EXPECT_EQ(escaped("a\x01\tb>"), "a?\tb&gt;"); }

}  // namespace
}  // namespace pongsim::xml_writer_test
