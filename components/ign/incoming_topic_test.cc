#include "ign/incoming_topic.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "ign/library.hh"
#include "pongsim/program/log_sink.hh"
#include "support/wait_until.hh"

namespace pongsim::ign {
namespace {

using ignition::msgs::Int32;
using ignition::msgs::StringMsg;

class IncomingTopicTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    setenv("IGN_PARTITION", ("incoming_topic_test_" + std::to_string(getpid())).c_str(), 1);
    setenv("IGN_IP", "127.0.0.1", 1);
    library();
  }

  bool dispatchUntil(const std::function<bool()>& condition) {
    return test::waitUntil([&] {
      transport_.dispatchFor(std::chrono::milliseconds(1));
      return condition();
    });
  }

  Transport transport_{{.network = false}};
  Node node_ = transport_.node();
  Logger log_{"test"};
  std::atomic<int> woken_ = 0;
  std::shared_ptr<IncomingTopic> topic_ = std::make_shared<IncomingTopic>("/in", log_, [this] { ++woken_; });
  ignition::transport::Node speaker_;
};

TEST_F(IncomingTopicTest, TellsTheWorldUntilItEnds) {
  std::vector<std::string> heard;
  const Subscription subscription =
      node_.subscribe<StringMsg>("/in", [&](const StringMsg& message) { heard.push_back(message.data()); });
  topic_->listenTo(node_, {"ignition.msgs.StringMsg"}, false);
  topic_->subscribe();
  auto publisher = speaker_.Advertise<StringMsg>("/in");
  StringMsg message;
  message.set_data("a");
  EXPECT_TRUE(publisher.Publish(message));
  EXPECT_TRUE(dispatchUntil([&] { return !heard.empty(); }));
  topic_->end();
  EXPECT_TRUE(publisher.Publish(message));
  topic_->unsubscribe();
  // if the first message were delivered, it would arrive before this one
  node_.advertise<StringMsg>("/in").publish(message);
  EXPECT_TRUE(dispatchUntil([&] { return heard.size() > 1; }));
  EXPECT_EQ(heard.size(), 2U);
}

TEST_F(IncomingTopicTest, NamesATypeThatNobodyTakesOnce) {
  std::mutex mutex;
  std::vector<std::string> said;
  const LogSink sink(LogLevel::kWarning, [&](const LogRecord& record) {
    const std::lock_guard lock(mutex);
    said.emplace_back(record.message);
  });
  topic_->listenTo(node_, {"ignition.msgs.StringMsg"}, false);
  topic_->subscribe();
  auto publisher = speaker_.Advertise<Int32>("/in");
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(publisher.Publish(Int32()));
  EXPECT_TRUE(test::waitUntil([&] {
    const std::lock_guard lock(mutex);
    return !said.empty();
  }));
  topic_->unsubscribe();
  topic_->end();
  const std::lock_guard lock(mutex);
  EXPECT_EQ(said,
            std::vector<std::string>{"topic '/in': messages of ignition.msgs.Int32 arrived by ign-transport without a "
                                     "subscriber of that type; the world takes ignition.msgs.StringMsg"});
}

TEST_F(IncomingTopicTest, KeepsWhatComesBeforeItsTypeIsOpen) {
  std::vector<std::string> types;
  const Subscription subscription =
      node_.subscribeAnyType("/in", [&types](std::string_view type, auto) { types.emplace_back(type); });
  topic_->listenTo(node_, {}, true);
  topic_->subscribe();
  auto publisher = speaker_.Advertise<Int32>("/in");
  EXPECT_TRUE(publisher.Publish(Int32()));
  EXPECT_TRUE(test::waitUntil([&] { return woken_ > 0; }));
  EXPECT_TRUE(types.empty());
  topic_->openNewTypes(node_);
  EXPECT_TRUE(dispatchUntil([&] { return !types.empty(); }));
  EXPECT_EQ(types, std::vector<std::string>{"ignition.msgs.Int32"});
  topic_->unsubscribe();
  topic_->end();
}

}  // namespace
}  // namespace pongsim::ign
