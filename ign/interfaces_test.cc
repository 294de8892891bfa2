#include "ign/interfaces.hh"

#include <gtest/gtest.h>

#include <algorithm>

namespace pongsim::ign {
namespace {

TEST(Interfaces, HaveThisMachinesLoopbackAmongThem) {
  const std::vector<Interface> all = interfaces();
  const auto found = std::ranges::find(all, "127.0.0.1", &Interface::address);
  ASSERT_NE(found, all.end());
  EXPECT_EQ(found->name, "lo");
}

}  // namespace
}  // namespace pongsim::ign
