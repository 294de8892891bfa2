#include "pongsim/background_calls.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pongsim {
namespace {

class BackgroundCallsTest : public testing::Test {
 protected:
  /// Posts a call of the service "/echo".
  void post(const std::string& text, BackgroundCalls& calls) {
    MessagePointer request = newMessage("StringMsg");
    ASSERT_FALSE(parseMessage("data: '" + text + "'", *request));
    calls.post({.service = "/echo", .request = std::move(request), .replyType = "ignition.msgs.Empty"});
  }

  Service serve() {
    return transport_.node().serve("/echo", "ignition.msgs.StringMsg", "ignition.msgs.Empty",
                                   [this](const Message& request, Message&) {
                                     requests_.push_back(messageText(request));
                                     return true;
                                   });
  }

  Transport transport_{{.network = false, .domain = {}}};
  Logger log_{"test"};
  std::vector<std::string> requests_;
};

TEST_F(BackgroundCallsTest, AreMadeInOrderWhileTheCallerGoesOn) {
  BackgroundCalls calls(transport_.node(), log_);
  const Service service = serve();
  for (const char* text : {"a", "b", "c"}) post(text, calls);
  while (requests_.size() < 3) transport_.dispatchFor(std::chrono::milliseconds(10));
  EXPECT_EQ(requests_, (std::vector<std::string>{"data: \"a\"\n", "data: \"b\"\n", "data: \"c\"\n"}));
}

TEST_F(BackgroundCallsTest, TellWhatCameOfThem) {
  std::atomic<int> told = 0;
  std::string error;
  {
    BackgroundCalls calls(transport_.node(), log_);
    const Service service = serve();
    calls.post({.service = "/echo",
                .request = newMessage("StringMsg"),
                .replyType = "ignition.msgs.Empty",
                .done = [&](const CallResult& result, const Message&) { told += result ? 1 : 100; }});
    calls.post({.service = "/nobody",
                .request = newMessage("Empty"),
                .replyType = "ignition.msgs.Empty",
                .timeout = std::chrono::milliseconds(1),
                .done = [&](const CallResult& result, const Message&) {
                  error = result.error;
                  ++told;
                }});
    while (told < 2) transport_.dispatchFor(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(told, 2);
  EXPECT_NE(error.find("/nobody"), std::string::npos) << error;
}

TEST_F(BackgroundCallsTest, AreRefusedWhereTooManyWait) {
  testing::internal::CaptureStderr();
  {
    BackgroundCalls calls(transport_.node(), log_, 2);
    const Service service = serve();
    // without dispatch no call ends: at most one is in progress and two are queued
    int posted = 0;
    for (int i = 0; i < 10; ++i) {
      posted += calls.post({.service = "/echo",
                            .request = newMessage("StringMsg"),
                            .replyType = "ignition.msgs.Empty",
                            .timeout = std::chrono::milliseconds(100)});
    }
    EXPECT_GE(posted, 2);
    EXPECT_LE(posted, 3);
  }
  EXPECT_NE(testing::internal::GetCapturedStderr().find("2 calls are already waiting"), std::string::npos);
}

TEST_F(BackgroundCallsTest, SayWhatGoesWrongAndGoOn) {
  testing::internal::CaptureStderr();
  {
    BackgroundCalls calls(transport_.node(), log_);
    calls.post({.service = "/nobody",
                .request = newMessage("Empty"),
                .replyType = "ignition.msgs.Empty",
                .timeout = std::chrono::milliseconds(1)});
    const Service service = serve();
    post("still here", calls);
    while (requests_.empty()) transport_.dispatchFor(std::chrono::milliseconds(10));
  }
  EXPECT_NE(testing::internal::GetCapturedStderr().find("/nobody"), std::string::npos);
}

}  // namespace
}  // namespace pongsim
