#include "ros2/command/rows.hh"

#include <gtest/gtest.h>

namespace pongsim::ros2 {
namespace {

TEST(Rows, StandBelowEachOther) {
  EXPECT_EQ(alignedRows({{"a", "bb", "c"}, {"aaa", "b", ""}, {"a"}}), "a    bb  c\naaa  b\na\n");
  EXPECT_EQ(alignedRows({}), "");
}

}  // namespace
}  // namespace pongsim::ros2
