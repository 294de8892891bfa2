#include "base/text.hh"

#include <gtest/gtest.h>

#include <array>

namespace pongsim::base {
namespace {

TEST(Text, IsTrimmedAtItsEndsOnly) {
  EXPECT_EQ(trimmed(" \t one two\r\n\f\v"), "one two");
  EXPECT_EQ(trimmed("one"), "one");
  EXPECT_EQ(trimmed(" \n"), "");
  EXPECT_EQ(trimmed(""), "");
  EXPECT_EQ(trimmed("\n one ", " "), "\n one");
}

TEST(Text, ListsWords) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed(std::array<std::string_view, 1>{"one"}), "one");
  EXPECT_EQ(listed(std::array<std::string_view, 3>{"one", "two", "three"}), "one, two, three");
}

}  // namespace
}  // namespace pongsim::base
