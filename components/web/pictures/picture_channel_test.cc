#include "web/pictures/picture_channel.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/camera_world.hh"
#include "support/running_world.hh"
#include "support/wait_until.hh"
#include "support/web/recorded_client.hh"

namespace pongsim::web {
namespace {

using nlohmann::json;
using pongsim::test::RunningWorld;
using pongsim::test::waitUntil;
using Clock = std::chrono::steady_clock;

constexpr const char* kBall = R"(<gravity>0 0 0</gravity>
  <light type="directional" name="sun"><direction>1 0 -1</direction></light>
  <model name="ball"><pose>3 0 1 0 0 0</pose><link name="l"><visual name="v"><geometry><sphere><radius>0.5</radius>
  </sphere></geometry></visual></link></model>)";

json wishAt(double x) { return {{"pose", {x, 0, 1, 0, 0, 0, 1}}, {"fieldOfView", 1}, {"width", 64}, {"height", 48}}; }

class PictureChannelTest : public pongsim::test::DrawingTest {
 protected:
  void SetUp() override {
    DrawingTest::SetUp();
    if (IsSkipped()) return;
    world_.emplace(std::string(kBall));
  }
  ~PictureChannelTest() override { channel_->end(); }

  std::shared_ptr<void> open(const std::shared_ptr<Client>& client) {
    return channel_->open(client, 1, [](std::uint64_t timeNs) { return std::to_string(timeNs) + ":"; });
  }
  /// What the world does between two steps while it is paused.
  void look() {
    channel_->update(world_->simulation().world(),
                     {.time = world_->simulation().time(), .dt = {}, .iteration = 0, .paused = true});
  }
  /// Lets the world go on until the client has a message.
  std::string next(RecordedClient& client) {
    std::string found;
    EXPECT_TRUE(waitUntil([&] {
      look();
      client.free();
      for (const std::string& each : client.takeBinaries()) found = each;
      return !found.empty();
    }));
    return found;
  }

  std::optional<RunningWorld> world_;
  std::atomic<int> wakes_ = 0;
  std::shared_ptr<PictureChannel> channel_ = std::make_shared<PictureChannel>("w", [this] { ++wakes_; });
  std::shared_ptr<RecordedClient> client_ = std::make_shared<RecordedClient>();
};

TEST_F(PictureChannelTest, AnswersAWishByAJpegFile) {
  EXPECT_EQ(channel_->topic(), "/world/w/picture");
  const auto opened = open(client_);
  EXPECT_EQ(channel_->ask(opened, wishAt(0)), "");
  const std::string message = next(*client_);
  EXPECT_EQ(message.substr(0, 5), "0:\xff\xd8\xff");
  EXPECT_GT(wakes_, 0);
}

TEST_F(PictureChannelTest, RefusesAWishThatIsNone) {
  const auto opened = open(client_);
  EXPECT_NE(channel_->ask(opened, json{{"width", 3}}), "");
}

TEST_F(PictureChannelTest, DrawsNothingForThoseWhoDoNotAsk) {
  const auto opened = open(client_);
  const auto asking = std::make_shared<RecordedClient>();
  const auto other = open(asking);
  channel_->ask(other, wishAt(0));
  next(*asking);
  client_->free();
  EXPECT_TRUE(client_->takeBinaries().empty());
}

TEST_F(PictureChannelTest, SendsOnePictureForEachWishAndNoneThatIsTheSame) {
  const auto opened = open(client_);
  channel_->ask(opened, wishAt(0));
  const std::string first = next(*client_);
  // nothing has moved: the answer comes when something does
  channel_->ask(opened, wishAt(0));
  const int before = wakes_;
  ASSERT_TRUE(waitUntil([&] {
    look();
    return wakes_ > before + 1;
  }));
  client_->free();
  EXPECT_TRUE(client_->takeBinaries().empty());
  world_->model("ball").setPose({{3, 0.7, 1}});
  EXPECT_NE(next(*client_), first);
}

TEST_F(PictureChannelTest, AnotherViewpointIsAnotherPicture) {
  const auto opened = open(client_);
  channel_->ask(opened, wishAt(0));
  const std::string far = next(*client_);
  channel_->ask(opened, wishAt(1));
  const std::string near = next(*client_);
  EXPECT_NE(near, far);
}

TEST_F(PictureChannelTest, SendsAClientAtMostTenASecond) {
  const auto opened = open(client_);
  const auto begin = Clock::now();
  constexpr int kPictures = 6;
  for (int i = 0; i < kPictures; ++i) {
    channel_->ask(opened, wishAt(0.1 * i));
    next(*client_);
  }
  EXPECT_GE(Clock::now() - begin, (kPictures - 1) * std::chrono::milliseconds(100));
}

TEST_F(PictureChannelTest, DrawsWhatModelsAreRemovedMeanwhile) {
  const auto opened = open(client_);
  channel_->ask(opened, wishAt(0));
  const std::string first = next(*client_);
  world_->simulation().remove(world_->model("ball"));
  channel_->ask(opened, wishAt(0));
  EXPECT_NE(next(*client_), first);
}

TEST_F(PictureChannelTest, EndsWhileItDropsTheSceneOfAClientThatHasGone) {
  for (int i = 0; i < 10; ++i) {
    auto opened = open(client_);
    channel_->ask(opened, wishAt(0.1 * i));
    next(*client_);
    opened.reset();
    channel_->end();
    channel_ = std::make_shared<PictureChannel>("w", [this] { ++wakes_; });
  }
}

TEST_F(PictureChannelTest, EndsWithTheWorldThoughAClientWaits) {
  const auto opened = open(client_);
  channel_->ask(opened, wishAt(0));
  channel_->end();
  EXPECT_EQ(channel_->ask(opened, wishAt(0)), "the world has ended");
}

}  // namespace
}  // namespace pongsim::web
