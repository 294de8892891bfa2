#include "web/frames/pose_feed.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/physical_properties.hh"
#include "support/running_world.hh"
#include "support/wait_until.hh"
#include "web/server/client_queue.hh"
#include "web/server/limits.hh"
#include "web/server/traffic.hh"

namespace pongsim::web {
namespace {

using pongsim::test::RunningWorld;
using pongsim::test::waitUntil;

/// A client whose socket is free when the test decides.
class FreeClient final : public Client {
 public:
  void sendText(std::string) override {}
  void sendBinary(Frame) override {}
  void sendData(std::uint64_t, std::size_t, Frame) override {}
  void sendWhenFree(std::uint64_t key, std::function<Frame()> make) override { queue_.addMaker(key, std::move(make)); }
  void callSoon(std::shared_ptr<Callee> callee) override { callee->called(); }
  std::shared_ptr<void> callRegularly(std::weak_ptr<Callee>) override { return std::make_shared<int>(0); }
  void forget(std::uint64_t key) override { queue_.forget(key); }
  void close(std::uint16_t, std::string) override {}
  bool mayWrite() const override { return true; }
  std::uint64_t dropped() const override { return 0; }
  ClientTraffic& traffic() override { return traffic_; }

  std::optional<Frame> take() {
    auto item = queue_.take();
    return item ? std::optional(std::move(item->frame)) : std::nullopt;
  }

 private:
  ClientTraffic traffic_{1, "127.0.0.1", "test"};
  ServerLimits limits_;
  ClientQueue queue_{limits_};
};

template <class Number>
Number at(const Frame& frame, std::size_t place) {
  Number number{};
  std::memcpy(&number, frame.body.bytes().data() + place, sizeof number);
  return number;
}
std::uint32_t countIn(const Frame& frame) { return at<std::uint32_t>(frame, 44); }

class PoseFeedTest : public testing::Test {
 protected:
  /// A step long enough for the next frame to be due.
  void step() {
    world_.step(1);
    feed_->update({.time = world_.simulation().time(), .dt = {}, .iteration = ++iteration_, .paused = isPaused_});
    channel_->called();
  }
  std::shared_ptr<void> open(const std::shared_ptr<Client>& client, std::uint64_t key = 1) {
    return channel_->open(client, key, [](std::uint64_t) { return std::string("head"); });
  }
  /// Steps until a frame arrives.
  Frame next(FreeClient& client) {
    std::optional<Frame> frame;
    EXPECT_TRUE(waitUntil([&] {
      step();
      frame = client.take();
      return frame.has_value();
    }));
    return frame.value_or(Frame{});
  }

  RunningWorld world_{std::string(R"(<gravity>0 0 0</gravity>
    <model name="still"><link name="link"/></model>
    <model name="moves"><pose>3 0 0 0 0 0</pose><link name="link"/></model>)")};
  int wakes_ = 0;
  std::shared_ptr<PoseChannel> channel_ = std::make_shared<PoseChannel>("w", [this] { ++wakes_; });
  std::optional<PoseFeed> feed_{std::in_place, world_.simulation().world(), channel_};
  std::uint64_t iteration_ = 0;
  bool isPaused_ = false;
};

TEST_F(PoseFeedTest, IsCalledAsTheWorldIs) {
  EXPECT_EQ(channel_->topic(), "/world/w/frame");
  EXPECT_EQ(channel_->schemaName(), "pongsim.Frame");
}

TEST_F(PoseFeedTest, TellsAllAtFirstThenWhatHasMoved) {
  const auto client = std::make_shared<FreeClient>();
  const auto seen = open(client);
  EXPECT_EQ(wakes_, 1);
  const Frame first = next(*client);
  EXPECT_EQ(first.head, "head");
  EXPECT_EQ(countIn(first), 4U);
  world_.model("moves").setVelocity({1, 0, 0}, {0, 0, 0});
  const Frame second = next(*client);
  EXPECT_EQ(countIn(second), 2U);
  EXPECT_GT(at<std::uint64_t>(second, 8), at<std::uint64_t>(first, 8));
  EXPECT_GT(at<float>(second, 52), 3.F);
}

TEST_F(PoseFeedTest, ClientsEachGetWhatTheyHaveNotGot) {
  const auto quick = std::make_shared<FreeClient>(), slow = std::make_shared<FreeClient>();
  const auto seenByQuick = open(quick), seenBySlow = open(slow);
  next(*quick);
  world_.model("moves").setVelocity({1, 0, 0}, {0, 0, 0});
  EXPECT_EQ(countIn(next(*quick)), 2U);
  // it did not read meanwhile, and gets one current frame
  const std::optional<Frame> frame = slow->take();
  ASSERT_TRUE(frame);
  EXPECT_EQ(countIn(*frame), 4U);
  EXPECT_GT(at<float>(*frame, 48 + 2 * 32 + 4) + at<float>(*frame, 48 + 32 + 4), 3.F);
  EXPECT_FALSE(slow->take());
}

TEST_F(PoseFeedTest, TellsAllAgainWhenModelsCome) {
  const auto client = std::make_shared<FreeClient>();
  const auto seen = open(client);
  const std::uint32_t revision = at<std::uint32_t>(next(*client), 40);
  world_.simulation().remove(world_.model("still"));
  feed_->worldChanged();
  const Frame frame = next(*client);
  EXPECT_EQ(countIn(frame), 2U);
  EXPECT_EQ(at<std::uint32_t>(frame, 4), 1U);
  EXPECT_NE(at<std::uint32_t>(frame, 40), revision);
}

TEST_F(PoseFeedTest, LetsPagesReadTheSceneAgainWhenColorsChange) {
  const auto client = std::make_shared<FreeClient>();
  const auto seen = open(client);
  const std::uint32_t revision = at<std::uint32_t>(next(*client), 40);
  PhysicalProperties properties(world_.simulation().world());
  ASSERT_TRUE(properties.setColors(VisualId{1}, {.specular = Vector3(1, 0, 0)}));
  EXPECT_EQ(at<std::uint32_t>(next(*client), 40), revision + 1);
  ASSERT_TRUE(properties.setColors(VisualId{1}, {.specular = Vector3(0, 0, 0)}));
  EXPECT_EQ(at<std::uint32_t>(next(*client), 40), revision + 1) << "not with each change: lights may blink";
}

TEST_F(PoseFeedTest, ComesAtMost60TimesASecond) {
  const auto client = std::make_shared<FreeClient>();
  const auto seen = open(client);
  const auto begin = std::chrono::steady_clock::now();
  int frames = 0;
  for (int i = 0; i < 2000; ++i) {
    step();
    frames += client->take() ? 1 : 0;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  // two arrive at once, when the channel opens and at the first regular call; the next one after half a period
  EXPECT_LE(frames, 60 * seconds + 3);
}

TEST_F(PoseFeedTest, CopiesNothingWhileNobodyWatches) {
  const auto client = std::make_shared<FreeClient>();
  open(client);
  EXPECT_FALSE(channel_->takeIsWanted());
  for (int i = 0; i < 10; ++i) step();
  EXPECT_FALSE(client->take());
}

TEST(PoseFeed, FollowsActorsOnTheirWay) {
  RunningWorld world(std::string(R"(<actor name="walker"><link name="l"/><script>
    <trajectory id="0" type="walk" tension="1">
      <waypoint><time>0</time><pose>0 0 0 0 0 0</pose></waypoint>
      <waypoint><time>100</time><pose>100 0 0 0 0 0</pose></waypoint>
    </trajectory></script></actor>)"));
  const auto channel = std::make_shared<PoseChannel>("w", [] {});
  PoseFeed feed(world.simulation().world(), channel);
  const auto client = std::make_shared<FreeClient>();
  const auto seen = channel->open(client, 1, [](std::uint64_t) { return std::string(); });
  float before = -1;
  for (int frames = 0; frames < 3; ++frames) {
    std::optional<Frame> frame;
    ASSERT_TRUE(waitUntil([&] {
      world.step(1);
      feed.update({.time = world.simulation().time(), .dt = {}, .iteration = 0, .paused = false});
      channel->called();
      return (frame = client->take()).has_value();
    }));
    ASSERT_EQ(countIn(*frame), 1U);
    EXPECT_GT(at<float>(*frame, 52), before);
    before = at<float>(*frame, 52);
  }
}

TEST_F(PoseFeedTest, CopiesOnceForAll) {
  std::vector<std::shared_ptr<FreeClient>> clients;
  std::vector<std::shared_ptr<void>> seen;
  for (int i = 0; i < 4; ++i) seen.push_back(open(clients.emplace_back(std::make_shared<FreeClient>())));
  EXPECT_TRUE(channel_->takeIsWanted());
  EXPECT_FALSE(channel_->takeIsWanted());
  for (const auto& client : clients) EXPECT_EQ(countIn(next(*client)), 4U);
}

TEST_F(PoseFeedTest, APausedWorldIsToldOf) {
  isPaused_ = true;
  const auto client = std::make_shared<FreeClient>();
  const auto seen = open(client);
  const Frame frame = next(*client);
  EXPECT_EQ(at<std::uint32_t>(frame, 32), 1U);
  EXPECT_EQ(at<double>(frame, 24), 0.0);
}

TEST_F(PoseFeedTest, APausedWorldTellsWhatSomebodyMoves) {
  isPaused_ = true;
  const auto client = std::make_shared<FreeClient>();
  const auto seen = open(client);
  next(*client);
  const auto pausedFrame = [&] {
    feed_->update({.time = world_.simulation().time(), .dt = {}, .iteration = iteration_, .paused = true});
    channel_->called();
    return client->take();
  };
  // left over from earlier steps
  EXPECT_TRUE(waitUntil([&] { return !pausedFrame(); }));
  world_.model("moves").setPose({{7, 0, 0}});
  std::optional<Frame> frame;
  EXPECT_TRUE(waitUntil([&] { return (frame = pausedFrame()).has_value(); }));
  EXPECT_EQ(countIn(*frame), 2U);
  EXPECT_EQ(at<float>(*frame, 52), 7.F);
}

TEST_F(PoseFeedTest, AClientMayOutliveTheWorld) {
  const auto client = std::make_shared<FreeClient>();
  auto seen = open(client);
  next(*client);
  feed_.reset();
  seen.reset();
  const auto late = open(client);
  EXPECT_EQ(wakes_, 1);
}

}  // namespace
}  // namespace pongsim::web
