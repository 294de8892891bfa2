#include "web/world/client_endpoints.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <string>
#include <vector>

namespace pongsim::web {
namespace {

namespace im = ignition::msgs;

class WorldSideTest : public testing::Test {
 protected:
  Service serve() {
    return transport_.node().serve<im::StringMsg, im::Boolean>("/s", [](const auto&, auto&) { return true; });
  }
  void ask(const std::string& replyType = "ignition.msgs.Boolean") {
    endpoints_->request(
        {"/s", "ignition.msgs.StringMsg", replyType}, im::StringMsg(),
        [this](const CallResult& result, const Message&) { answers_.push_back(result ? "done" : result.error); });
  }

  Transport transport_{TransportOptions{.network = false, .domain = {}, .interface = {}}};
  Logger log_{"web"};
  std::vector<std::string> answers_;
  std::unique_ptr<ClientEndpoints> endpoints_ = std::make_unique<ClientEndpoints>(transport_.node(), log_);
};

TEST_F(WorldSideTest, PublishesForAsLongAsAVoiceIsOpen) {
  std::string received;
  const Subscription subscription = transport_.node().subscribe<im::StringMsg>(
      "/asked", [&](const im::StringMsg& message) { received += message.data(); });
  im::StringMsg a;
  a.set_data("a");
  const std::string bytes = a.SerializeAsString();
  const auto publish = [&] { endpoints_->publish(7, std::as_bytes(std::span(bytes))); };
  publish();
  endpoints_->open(7, "/asked", "ignition.msgs.StringMsg");
  publish();
  endpoints_->close(7);
  publish();
  transport_.dispatch();
  EXPECT_EQ(received, "a");
}

TEST_F(WorldSideTest, LeavesOutATopicThatCannotBeHad) {
  endpoints_->open(7, "a b", "ignition.msgs.StringMsg");
  endpoints_->publish(7, {});
}

TEST_F(WorldSideTest, AnswersEachRequestOnce) {
  const Service service = serve();
  ask();
  ask("ignition.msgs.Int32");
  EXPECT_EQ(answers_, std::vector<std::string>{"there is no service '/s'"});
  transport_.dispatch();
  EXPECT_EQ(answers_.size(), 2U);
  EXPECT_EQ(answers_.back(), "done");
  endpoints_.reset();
  EXPECT_EQ(answers_.size(), 2U);
}

TEST_F(WorldSideTest, RefusesWhatIsTooMuchAndAnswersWhatWaitsAtTheEnd) {
  const Service service = serve();
  for (int i = 0; i < 1000; ++i) ask();
  EXPECT_TRUE(answers_.empty());
  ask();
  ASSERT_EQ(answers_.size(), 1U);
  EXPECT_EQ(answers_[0], "too many requests are waiting for responses");
  endpoints_->failOverdue();
  endpoints_.reset();
  ASSERT_EQ(answers_.size(), 1001U);
  EXPECT_EQ(answers_.back(), "the world ended before '/s' answered");
}

}  // namespace
}  // namespace pongsim::web
