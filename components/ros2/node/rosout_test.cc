#include "ros2/node/rosout.hh"

#include <gtest/gtest.h>

#include <mutex>
#include <thread>

#include "ros2/types/rcl_interfaces.hh"
#include "support/process.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::ros2 {
namespace {

using rcl_interfaces::Log;

class RosoutTest : public testing::Test {
 protected:
  RosoutTest() { setLogLevel(LogLevel::kNone); }
  ~RosoutTest() override { setLogLevel(LogLevel::kWarning); }

  /// A subscribing node, with the messages that it received.
  struct Listener {
    Listener(int domain, bool wantsLast) : participant({.domain = domain}), node(participant, {.name = "peer"}) {
      subscription = node.subscribe<Log>("/rosout",
                                         [this](const Log& log) {
                                           const std::lock_guard lock(mutex);
                                           heard.push_back(log);
                                         },
                                         {.isTransientLocal = wantsLast, .depth = 1000});
    }
    std::size_t count() {
      const std::lock_guard lock(mutex);
      return heard.size();
    }
    std::mutex mutex;
    std::vector<Log> heard;
    Participant participant;
    RosNode node;
    std::unique_ptr<RosSubscription> subscription;
  };

  const int domain_ = test::testDomain();
  const Logger log_{"diff-drive of robot"};
  Participant participant_{{.domain = domain_}};
  RosNode node_{participant_, {.nameSpace = "/fleet"}};
};

TEST_F(RosoutTest, ALateReaderGetsWhatWasWarnedOf) {
  const Rosout rosout(node_);
  log_.info("not this");
  log_.warning("slow");
  log_.error("gone");
  Listener listener(domain_, true);
  ASSERT_TRUE(test::waitUntil([&] { return listener.count() >= 2; }));
  const Log &warning = listener.heard[0], &error = listener.heard[1];
  EXPECT_EQ(warning.msg, "slow");
  EXPECT_EQ(warning.level, Log::kWarn);
  EXPECT_EQ(warning.name, "fleet.pongsim.diff-drive of robot");
  EXPECT_GT(warning.stamp.sec, 1'600'000'000);
  EXPECT_EQ(error.msg, "gone");
  EXPECT_EQ(error.level, Log::kError);
}

TEST_F(RosoutTest, ALateReaderDoesNotGetWhatIsTooOld) {
  const auto publisher =
      node_.advertise<Log>("/rosout", {.isTransientLocal = true, .depth = 1000, .lifespan = std::chrono::seconds(1)});
  Log log;
  log.msg = "old";
  publisher->publish(log);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  log.msg = "new";
  Listener listener(domain_, true);
  // on a busy machine it may be older than a second before the subscriber is discovered
  ASSERT_TRUE(test::waitUntil([&] {
    publisher->publish(log);
    return listener.count() > 0;
  }));
  EXPECT_EQ(listener.heard[0].msg, "new");
}

TEST_F(RosoutTest, TheRoomsOwnComplaintsAreToldOnce) {
  const Rosout rosout(node_);
  Listener listener(domain_, true);
  node_.complainOf("/scan", "field 'data' is too long");
  ASSERT_TRUE(test::waitUntil([&] { return listener.count() > 0; }));
  log_.error("end");
  ASSERT_TRUE(test::waitUntil([&] { return listener.count() > 1; }));
  EXPECT_EQ(listener.heard[0].name, "fleet.pongsim.ros2");
  EXPECT_EQ(listener.heard[1].msg, "end");
}

}  // namespace
}  // namespace pongsim::ros2
