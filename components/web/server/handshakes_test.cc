#include "web/server/handshakes.hh"

#include <gtest/gtest.h>

#include <array>

namespace pongsim::web {
namespace {

/// Any address serves as a socket: it is never used.
class HandshakesTest : public testing::Test {
 protected:
  lws* socket(std::size_t number) { return reinterpret_cast<lws*>(&places_.at(number)); }

  std::array<char, 4> places_{};
  Handshakes handshakes_;
};

TEST_F(HandshakesTest, NameTheOldestOfAllAndOfAPeer) {
  EXPECT_EQ(handshakes_.oldest(), nullptr);
  handshakes_.add(socket(0), 1);
  handshakes_.add(socket(1), 2);
  handshakes_.add(socket(2), 2);
  EXPECT_EQ(handshakes_.oldest(), socket(0));
  EXPECT_EQ(handshakes_.oldest(2), socket(1));
  EXPECT_EQ(handshakes_.oldest(3), nullptr);
  EXPECT_EQ(handshakes_.count(2), 2U);
  EXPECT_EQ(handshakes_.count(3), 0U);
}

TEST_F(HandshakesTest, ForgetWhatHasEnded) {
  handshakes_.add(socket(0), 1);
  handshakes_.add(socket(1), 1);
  handshakes_.remove(socket(0));
  handshakes_.remove(socket(0));
  EXPECT_EQ(handshakes_.oldest(), socket(1));
  EXPECT_EQ(handshakes_.count(1), 1U);
  handshakes_.remove(socket(1));
  EXPECT_EQ(handshakes_.oldest(), nullptr);
  EXPECT_EQ(handshakes_.count(1), 0U);
}

TEST_F(HandshakesTest, ARequestMakesAConnectionTheYoungest) {
  handshakes_.add(socket(0), 1);
  handshakes_.add(socket(1), 1);
  handshakes_.renew(socket(0));
  EXPECT_EQ(handshakes_.oldest(), socket(1));
  EXPECT_EQ(handshakes_.count(1), 2U);
}

}  // namespace
}  // namespace pongsim::web
