#include "web/frames/contact_channel.hh"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <string>

#include "support/running_world.hh"
#include "support/wait_until.hh"
#include "support/web/recorded_client.hh"

namespace pongsim::web {
namespace {

using pongsim::test::RunningWorld;
using pongsim::test::waitUntil;

constexpr const char* kBoxOnGround = R"(
  <model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane/></geometry></collision>
  </link></model>
  <model name="box"><pose>0 0 0.5 0 0 0</pose><link name="l"><inertial><mass>2</mass></inertial>
  <collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model>)";

template <class Number>
Number at(const std::string& message, std::size_t place) {
  Number number{};
  std::memcpy(&number, message.data() + place, sizeof number);
  return number;
}

class ContactChannelTest : public testing::Test {
 protected:
  std::shared_ptr<void> open() {
    return channel_->open(client_, 1, [](std::uint64_t) { return std::string(); });
  }
  void step(int steps) {
    world_.step(steps);
    channel_->update(world_.simulation().world(),
                     {.time = world_.simulation().time(), .dt = {}, .iteration = 0, .paused = false});
    client_->free();
  }
  std::string next() {
    std::string found;
    EXPECT_TRUE(waitUntil([&] {
      step(1);
      for (const std::string& each : client_->takeBinaries()) found = each;
      return !found.empty();
    }));
    return found;
  }

  RunningWorld world_{std::string(kBoxOnGround)};
  int wakes_ = 0;
  std::shared_ptr<ContactChannel> channel_ = std::make_shared<ContactChannel>("w", [this] { ++wakes_; });
  std::shared_ptr<RecordedClient> client_ = std::make_shared<RecordedClient>();
};

TEST_F(ContactChannelTest, TellsPointsNormalsAndForcesWithoutAContactSensor) {
  EXPECT_EQ(channel_->topic(), "/world/w/contacts");
  world_.step(2000);
  const auto opened = open();
  EXPECT_EQ(wakes_, 1);
  const std::string message = next();
  const auto count = at<std::uint32_t>(message, 0);
  ASSERT_EQ(message.size(), kContactHead + count * kContactEntry);
  ASSERT_GE(count, 3U);
  double force = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = kContactHead + i * kContactEntry;
    EXPECT_NEAR(at<float>(message, place + 8), 0, 0.01);
    EXPECT_NEAR(std::abs(at<float>(message, place + 20)), 1, 1e-6);
    // on the first collision: along the normal, whichever of the two that is
    EXPECT_GE(at<float>(message, place + 20) * at<float>(message, place + 32), 0);
    force += std::abs(at<float>(message, place + 32));
  }
  EXPECT_NEAR(force, 2 * 9.8, 0.1);
}

TEST_F(ContactChannelTest, TellsNothingWhileNobodyWatches) {
  open();
  for (int i = 0; i < 10; ++i) step(1);
  EXPECT_TRUE(client_->takeBinaries().empty());
}

TEST_F(ContactChannelTest, TellsThatThereAreNoneAnyMore) {
  const auto opened = open();
  EXPECT_GT(at<std::uint32_t>(next(), 0), 0U);
  world_.model("box").setPose({{0, 0, 5}});
  std::string last;
  EXPECT_TRUE(waitUntil([&] {
    last = next();
    return at<std::uint32_t>(last, 0) == 0;
  }));
}

TEST(EncodedContacts, AreAtMostSoMany) {
  EXPECT_EQ(encodeContacts(std::vector<Contact>(kMostContacts + 5)).size(),
            kContactHead + kMostContacts * kContactEntry);
}

}  // namespace
}  // namespace pongsim::web
