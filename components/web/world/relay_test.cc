#include "web/world/relay.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <optional>

#include "support/web/stepped_world.hh"

namespace pongsim::web {
namespace {

namespace im = ignition::msgs;

class RelayTest : public testing::Test {
 protected:
  std::optional<Topic> topic(const std::string& name) {
    for (const auto& place : worlds_->topics()) {
      if (place.topic.name == name) return place.topic;
    }
    return std::nullopt;
  }
  std::shared_ptr<WorldLink> link() { return worlds_->find("w"); }
  /// Subscribes, and adds received messages to `texts_`.
  std::shared_ptr<void> subscribe(const std::string& name) {
    return link()->subscribe(name, "ignition.msgs.StringMsg", {[this](const Payload& bytes, std::uint64_t timeNs) {
                               im::StringMsg message;
                               message.ParseFromArray(bytes.bytes().data(), static_cast<int>(bytes.size()));
                               texts_.push_back(message.data() + "@" + std::to_string(timeNs / 1'000'000'000));
                             }});
  }
  static im::StringMsg text(const std::string& data) {
    im::StringMsg message;
    message.set_data(data);
    return message;
  }
  static Payload payload(const Message& message) { return Payload(message.SerializeAsString()); }

  std::shared_ptr<Worlds> worlds_ = std::make_shared<Worlds>();
  SteppedWorld world_{worlds_};
  int changes_ = 0;
  std::shared_ptr<void> watch_ = worlds_->watch({.changed = [this] { ++changes_; }});
  std::vector<std::string> texts_;
};

TEST_F(RelayTest, TellsWhatComesAndGoes) {
  auto publisher = world_.node().advertise<im::StringMsg>("/said", {.latched = true});
  const Subscription subscription = world_.node().subscribe<im::StringMsg>("/asked", [](const auto&) {});
  const Service service =
      world_.node().serve<im::StringMsg, im::Boolean>("/s", [](const auto&, auto&) { return true; });
  ASSERT_TRUE(world_.stepUntil([&] { return topic("/said").has_value(); }));
  EXPECT_EQ(topic("/said"), (Topic{"/said", "ignition.msgs.StringMsg", 1, 0, true}));
  EXPECT_EQ(topic("/asked"), (Topic{"/asked", "ignition.msgs.StringMsg", 0, 1, false}));
  ASSERT_EQ(worlds_->services().size(), 1U);
  EXPECT_EQ(worlds_->services()[0].service, (OwnService{"/s", "ignition.msgs.StringMsg", "ignition.msgs.Boolean"}));
  EXPECT_GT(changes_, 0);
  publisher = {};
  EXPECT_TRUE(world_.stepUntil([&] { return !topic("/said").has_value(); }));
}

TEST_F(RelayTest, LooksAtNothingWhileNobodyWatches) {
  watch_.reset();
  auto publisher = world_.node().advertise<im::StringMsg>("/said");
  world_.steps(5);
  EXPECT_FALSE(topic("/said").has_value());
  watch_ = worlds_->watch({.changed = [] {}});
  EXPECT_TRUE(world_.stepUntil([&] { return topic("/said").has_value(); }));
}

TEST_F(RelayTest, ListensForAsLongAsAClientDoes) {
  auto publisher = world_.node().advertise<im::StringMsg>("/said");
  world_.step();
  EXPECT_FALSE(publisher.hasSubscribers());
  auto subscription = subscribe("/said");
  world_.step();
  EXPECT_TRUE(publisher.hasSubscribers());
  publisher.publish(text("a"));
  EXPECT_EQ(texts_, (std::vector<std::string>{"a@2"}));
  subscription.reset();
  world_.step();
  EXPECT_FALSE(publisher.hasSubscribers());
}

TEST_F(RelayTest, DoesNotTellOfItsOwnListening) {
  const auto subscription = subscribe("/nobody");
  world_.step();
  const auto publisher = world_.node().advertise<im::StringMsg>("/somebody");
  ASSERT_TRUE(world_.stepUntil([&] { return topic("/somebody").has_value(); }));
  EXPECT_FALSE(topic("/nobody").has_value());
}

TEST_F(RelayTest, TellsWhatIsLatchedToEachWhoComes) {
  auto publisher = world_.node().advertise<im::StringMsg>("/said", {.latched = true});
  publisher.publish(text("a"));
  const auto first = subscribe("/said");
  ASSERT_TRUE(world_.stepUntil([&] { return texts_.size() == 1; }));
  const auto second = subscribe("/said");
  EXPECT_EQ(texts_.size(), 2U);
}

TEST_F(RelayTest, CarriesWhatAClientPublishes) {
  std::vector<std::string> received;
  const Subscription subscription = world_.node().subscribe<im::StringMsg>(
      "/asked", [&](const im::StringMsg& message) { received.push_back(message.data()); });
  auto publisher = link()->advertise("/asked", "ignition.msgs.StringMsg");
  ASSERT_TRUE(publisher->publish(payload(text("a"))));
  ASSERT_TRUE(publisher->publish(payload(text("b"))));
  world_.steps(2);
  EXPECT_EQ(received, (std::vector<std::string>{"a", "b"}));
  publisher.reset();
  world_.step();
  ASSERT_TRUE(world_.stepUntil([&] { return topic("/asked").has_value(); }));
  EXPECT_TRUE(world_.stepUntil([&] { return topic("/asked")->publishers == 0; }));
}

TEST_F(RelayTest, RefusesWhatAWorldThatStandsStillCannotTake) {
  const auto publisher = link()->advertise("/asked", "ignition.msgs.StringMsg");
  bool isRefused = false;
  for (int i = 0; i < 100'000 && !isRefused; ++i) isRefused = !publisher->publish(payload(text("a")));
  EXPECT_TRUE(isRefused);
  world_.step();
  EXPECT_TRUE(publisher->publish(payload(text("a"))));
}

TEST_F(RelayTest, CarriesRequestsAndAnswers) {
  const Service service =
      world_.node().serve<im::StringMsg, im::Boolean>("/s", [](const im::StringMsg& request, auto& reply) {
        reply.set_data(true);
        return request.data() == "yes" ? ServiceAnswer(true) : ServiceAnswer::refused("it says no");
      });
  std::vector<std::string> answers;
  const auto ask = [&](const std::string& name, const std::string& data) {
    link()->request({name, "ignition.msgs.StringMsg", "ignition.msgs.Boolean"},
                    std::make_shared<im::StringMsg>(text(data)), [&](const CallResult& result, const Message& reply) {
                      answers.push_back(result ? reply.GetTypeName() : result.error);
                    });
  };
  ask("/s", "yes");
  ask("/s", "no");
  ask("/nothing", "yes");
  ASSERT_TRUE(world_.stepUntil([&] { return answers.size() == 3; }));
  // there is no such service, which is reported at once
  EXPECT_EQ(answers[0], "there is no service '/nothing'");
  EXPECT_EQ(answers[1], "ignition.msgs.Boolean");
  EXPECT_NE(answers[2].find("it says no"), std::string::npos) << answers[2];
}

TEST_F(RelayTest, AnswersWhatWaitsWhenTheWorldEnds) {
  const Service service =
      world_.node().serve<im::StringMsg, im::Boolean>("/s", [](const auto&, auto&) { return true; });
  const auto gone = link();
  std::string answer;
  gone->request({"/s", "ignition.msgs.StringMsg", "ignition.msgs.Boolean"}, std::make_shared<im::StringMsg>(),
                [&](const CallResult& result, const Message&) { answer = result.error; });
  world_.end();
  EXPECT_NE(answer.find("ended"), std::string::npos) << answer;
  EXPECT_TRUE(worlds_->all().empty());
  EXPECT_EQ(gone->advertise("/t", "ignition.msgs.StringMsg"), nullptr);
  EXPECT_TRUE(gone->lists()->topics.empty());
}

}  // namespace
}  // namespace pongsim::web
