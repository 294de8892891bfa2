#include "sim/running/status_publisher.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/world_stats.pb.h>

#include <vector>

namespace pongsim::sim {
namespace {

using std::chrono::milliseconds;

class StatusPublisherTest : public testing::Test {
 protected:
  template <class M>
  std::vector<M> heardOn(const std::string& topic, int calls) {
    std::vector<M> heard;
    const Subscription subscription =
        transport_.node().subscribe<M>(topic, [&](const M& message) { heard.push_back(message); });
    for (int i = 0; i < calls; ++i) {
      publisher_.publish({.simulated = milliseconds(1500 + i),
                          .real = milliseconds(3000),
                          .system = std::chrono::seconds(1'700'000'000),
                          .iterations = 1500U + static_cast<unsigned>(i),
                          .realTimeFactor = 0.500049,
                          .paused = false},
                         std::chrono::steady_clock::time_point(milliseconds(1000 + i)));
      transport_.dispatch();
    }
    return heard;
  }

  Transport transport_{TransportOptions{.network = false, .domain = {}}};
  StatusPublisher publisher_{transport_, "my world", true};
};

TEST_F(StatusPublisherTest, TellsTheThreeTimesEachStep) {
  for (const char* topic : {"/clock", "/world/my_world/clock"}) {
    const auto heard = heardOn<ignition::msgs::Clock>(topic, 3);
    ASSERT_EQ(heard.size(), 3U) << topic;
    EXPECT_EQ(heard[2].sim().sec(), 1);
    EXPECT_EQ(heard[2].sim().nsec(), 502'000'000);
    EXPECT_EQ(heard[2].real().sec(), 3);
    EXPECT_EQ(heard[2].system().sec(), 1'700'000'000);
  }
}

TEST_F(StatusPublisherTest, TellsStatisticsEachStepOnStats) {
  const auto heard = heardOn<ignition::msgs::WorldStatistics>("/stats", 3);
  ASSERT_EQ(heard.size(), 3U);
  EXPECT_EQ(heard[1].iterations(), 1501U);
  EXPECT_EQ(heard[1].real_time_factor(), 0.5);
  EXPECT_EQ(heard[1].sim_time().nsec(), 501'000'000);
  EXPECT_FALSE(heard[1].paused());
}

TEST_F(StatusPublisherTest, TellsStatisticsOfTheWorldTenTimesASecond) {
  EXPECT_EQ(heardOn<ignition::msgs::WorldStatistics>("/world/my_world/stats", 250).size(), 3U);
}

}  // namespace
}  // namespace pongsim::sim
