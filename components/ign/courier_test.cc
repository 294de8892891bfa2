#include "ign/courier.hh"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <future>
#include <memory>
#include <string>

#include "support/wait_until.hh"

namespace pongsim::ign {
namespace {

class CourierTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    setenv("IGN_PARTITION", ("courier_test_" + std::to_string(getpid())).c_str(), 1);
    setenv("IGN_IP", "127.0.0.1", 1);
  }

  Logger log_{"test"};
  Courier courier_{log_, "127.0.0.1", [] {}};
  std::shared_ptr<OutgoingTopic> topic_ = std::make_shared<OutgoingTopic>("/out", "ignition.msgs.StringMsg");
};

TEST_F(CourierTest, DropsTheOldestWithoutHoldingUpWhoSends) {
  const std::size_t before = Payload::total();
  {
    // blocks the courier's thread, as the library's locks may do
    std::promise<void> begun, end;
    courier_.post([&begun, ended = end.get_future().share()] {
      begun.set_value();
      ended.wait();
    });
    begun.get_future().wait();
    courier_.open(topic_);
    for (int i = 0; i < 10'100; ++i) courier_.send(topic_, Payload(10));
    EXPECT_GE(courier_.dropped(), 100U);
    const std::uint64_t small = courier_.dropped();
    for (int i = 0; i < 100; ++i) courier_.send(topic_, Payload(1 << 20));
    EXPECT_GT(courier_.dropped(), small);
    EXPECT_LE(Payload::total() - before, (64U << 20) + (1 << 20));
    end.set_value();
  }
  // discarded, because the topic has no subscriber
  EXPECT_TRUE(test::waitUntil([&] { return Payload::total() == before; }));
}

TEST_F(CourierTest, DoesInOrderWhatItIsAskedBeforeItEnds) {
  std::string done;
  {
    Courier other(log_, "127.0.0.1", [] {});
    other.post([&done] { done += "a"; });
    other.post([&done] { done += "b"; });
  }
  EXPECT_EQ(done, "ab");
}

}  // namespace
}  // namespace pongsim::ign
