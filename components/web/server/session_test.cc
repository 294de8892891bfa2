#include "web/server/session.hh"

#include <gtest/gtest.h>

#include <cstddef>
#include <span>

namespace pongsim::web {
namespace {

TEST(Payload, HasTheTextAndACopyTheSameBytes) {
  const Payload payload("abc");
  const Payload copy = payload;
  EXPECT_EQ(copy.size(), 3U);
  EXPECT_EQ(copy.bytes()[2], std::byte{'c'});
  EXPECT_EQ(copy.bytes().data(), payload.bytes().data());
}

TEST(Payload, IsEmptyOfAnEmptyText) {
  EXPECT_EQ(Payload("").size(), 0U);
  EXPECT_EQ(Payload().bytes().size(), 0U);
}

TEST(SessionFrame, IsAsLongAsItsParts) { EXPECT_EQ((Frame{"head", Payload("body!")}.size()), 9U); }

}  // namespace
}  // namespace pongsim::web
