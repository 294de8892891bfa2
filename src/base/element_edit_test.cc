#include "base/element_edit.hh"

#include <gtest/gtest.h>

namespace pongsim::base {
namespace {

TEST(ElementEdit, FindsOrMakesChildren) {
  Element parent;
  EXPECT_EQ(childOf(parent, "a"), nullptr);
  EXPECT_EQ(&childOrNew(parent, "a", {}), &childOrNew(parent, "a", {}));
  EXPECT_EQ(parent.children.size(), 1U);
  setChild(parent, "a", {nullptr, 7, 1}, "text");
  setChild(parent, "b", {}, "more");
  ASSERT_EQ(parent.children.size(), 2U);
  EXPECT_EQ(parent.children[0].text, "text");
  EXPECT_EQ(parent.children[0].position.line, 7);
}

TEST(ElementEdit, ReplacesAnAttributeInItsPlace) {
  Element element;
  setAttribute(element, "a", "1", {});
  setAttribute(element, "b", "2", {});
  setAttribute(element, "a", "3", {nullptr, 7, 1});
  ASSERT_EQ(element.attributes.size(), 2U);
  EXPECT_EQ(element.attributes[0].value, "3");
  EXPECT_EQ(element.attributes[0].position.line, 7);
}

TEST(ElementEdit, WritesNumbersThatReadAsTheSame) {
  EXPECT_EQ(shortestText(0.1), "0.1");
  EXPECT_EQ(std::stod(shortestText(1.0 / 3)), 1.0 / 3);
}

}  // namespace
}  // namespace pongsim::base
