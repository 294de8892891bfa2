#include "web/world/world_link.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <atomic>
#include <thread>
#include <vector>

#include "support/web/stepped_world.hh"

namespace pongsim::web {
namespace {

namespace im = ignition::msgs;

constexpr const char* kText = "ignition.msgs.StringMsg";

class WorldLinkTest : public testing::Test {
 protected:
  std::shared_ptr<Worlds> worlds_ = std::make_shared<Worlds>();
  SteppedWorld world_{worlds_};
  std::shared_ptr<WorldLink> link_ = worlds_->find("w");
};

TEST_F(WorldLinkTest, KnowsTheNameAndTheTime) {
  EXPECT_EQ(link_->world(), "w");
  world_.steps(2);
  EXPECT_EQ(link_->timeNs(), 2'000'000'000U);
}

TEST_F(WorldLinkTest, ListensAnewAfterTheLastHasLeft) {
  auto publisher = world_.node().advertise<im::StringMsg>("/said");
  for (int round = 0; round < 3; ++round) {
    int received = 0;
    auto subscription = link_->subscribe("/said", kText, {[&](const Payload&, std::uint64_t) { ++received; }});
    auto other = link_->subscribe("/said", kText, {[&](const Payload&, std::uint64_t) { ++received; }});
    world_.step();
    publisher.publish(im::StringMsg());
    EXPECT_EQ(received, 2);
    other.reset();
    publisher.publish(im::StringMsg());
    EXPECT_EQ(received, 3);
    subscription.reset();
    publisher.publish(im::StringMsg());
    EXPECT_EQ(received, 3);
  }
}

TEST_F(WorldLinkTest, MayBeAskedByWhoHearsAMessage) {
  auto publisher = world_.node().advertise<im::StringMsg>("/said");
  const Service service =
      world_.node().serve<im::StringMsg, im::Boolean>("/s", [](const auto&, auto&) { return true; });
  // the end of the world fails the pending requests
  const auto answers = std::make_shared<int>(0);
  const auto subscription =
      link_->subscribe("/said", kText, {[this, answers](const Payload&, std::uint64_t) {
                         link_->request({"/s", kText, "ignition.msgs.Boolean"}, std::make_shared<im::StringMsg>(),
                                        [answers](const CallResult&, const Message&) { ++*answers; });
                       }});
  ASSERT_TRUE(world_.stepUntil([&] {
    publisher.publish(im::StringMsg());
    return *answers > 0;
  }));
}

TEST_F(WorldLinkTest, OutlivesTheWorld) {
  auto publisher = link_->advertise("/asked", kText);
  auto subscription = link_->subscribe("/said", kText, {[](const Payload&, std::uint64_t) {}});
  world_.end();
  EXPECT_FALSE(publisher->publish(Payload("")));
  std::string error;
  link_->request({"/s", kText, kText}, std::make_shared<im::StringMsg>(),
                 [&](const CallResult& result, const Message&) { error = result.error; });
  EXPECT_NE(error.find("ended"), std::string::npos) << error;
  EXPECT_NE(link_->subscribe("/other", kText, {[](const Payload&, std::uint64_t) {}}), nullptr);
}

TEST_F(WorldLinkTest, TakesWhatSeveralThreadsWish) {
  auto publication = world_.node().advertise<im::StringMsg>("/said", {.latched = true});
  const Service service =
      world_.node().serve<im::StringMsg, im::Boolean>("/s", [](const auto&, auto&) { return true; });
  std::atomic<int> asked = 0;
  std::atomic<int> answered = 0;
  std::atomic<int> running = 3;
  std::vector<std::jthread> clients;
  for (int i = 0; i < 3; ++i) {
    clients.emplace_back([&] {
      for (int round = 0; round < 300; ++round) {
        std::atomic<int> received = 0;
        const auto subscription =
            link_->subscribe("/said", kText, {[&](const Payload&, std::uint64_t) { ++received; }});
        const auto publisher = link_->advertise("/asked", kText);
        if (publisher) publisher->publish(Payload(""));
        ++asked;
        link_->request({"/s", kText, "ignition.msgs.Boolean"}, std::make_shared<im::StringMsg>(),
                       [&](const CallResult&, const Message&) { ++answered; });
      }
      --running;
    });
  }
  ASSERT_TRUE(world_.stepUntil([&] {
    publication.publish(im::StringMsg());
    return running == 0;
  }));
  clients.clear();
  EXPECT_TRUE(world_.stepUntil([&] { return answered == asked; }));
  world_.steps(2);
  EXPECT_FALSE(publication.hasSubscribers());
}

}  // namespace
}  // namespace pongsim::web
