#include "ros2/node/mailbox.hh"

#include <gtest/gtest.h>

#include <string>

namespace pongsim::ros2 {
namespace {

TEST(Mailbox, DoesWhatWaitsInOrderAndDropsWhatIsTooMuch) {
  Mailbox mailbox(2);
  std::string done;
  int posted = 0;
  mailbox.whenPosted([&] { ++posted; });
  EXPECT_TRUE(mailbox.post([&] { done += "a"; }));
  EXPECT_TRUE(mailbox.post([&] {
    done += "b";
    mailbox.post([&] { done += "c"; });
  }));
  EXPECT_FALSE(mailbox.post([&] { done += "x"; }));
  EXPECT_EQ(mailbox.dropped(), 1U);
  EXPECT_EQ(posted, 2);
  EXPECT_EQ(mailbox.dispatch(), 2U);
  EXPECT_EQ(done, "ab");
  EXPECT_EQ(mailbox.dispatch(), 1U);
  EXPECT_EQ(done, "abc");
  EXPECT_EQ(mailbox.dispatch(), 0U);
}

}  // namespace
}  // namespace pongsim::ros2
