#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/sensing/sensor_topic.hh"
#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

class SensorTopicTest : public testing::Test {
 protected:
  void start(const std::string& content) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(
        "<sdf version='1.9'><world name='w'><model name='m'><link name='l'><sensor name='s' type='imu'>" + content +
            "</sensor></link></model></world></sdf>",
        "world.sdf", {.loadSystems = false}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    Node node = simulation_->transport().node();
    topic_ =
        std::make_unique<SensorTopic>(simulation_->world().sensors("imu").at(0), "/imu", "ignition.msgs.Int32", node);
    subscription_ = node.subscribe("/t", "ignition.msgs.Int32", [](const Message&) {});
  }

  StepInfo at(int count) const { return {std::chrono::milliseconds(count), Time(1), 1, false}; }

  /// @return The number of messages due after `from` and up to `to` [ms].
  int dueBetween(int from, int to) {
    int count = 0;
    for (int time = from + 1; time <= to; ++time) {
      if (topic_->isDue(at(time))) ++count;
    }
    return count;
  }

  /// @return Whether the service accepted the request.
  bool setRate(double rate) {
    MessagePointer request = newMessage("ignition.msgs.Double");
    parseMessage("data: " + std::to_string(rate), *request);
    MessagePointer reply = newMessage("ignition.msgs.Empty");
    std::atomic<bool> over = false;
    CallResult result;
    std::thread caller([&] {
      result = simulation_->transport().node().call("/t/set_rate", *request, *reply, std::chrono::seconds(60));
      over = true;
      simulation_->transport().wake();
    });
    while (!over) simulation_->transport().dispatchFor(std::chrono::milliseconds(10));
    caller.join();
    return static_cast<bool>(result);
  }

  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SensorTopic> topic_;
  Subscription subscription_;
};

TEST_F(SensorTopicTest, IsDueEachStepWithoutARate) {
  start("<topic>t</topic>");
  EXPECT_EQ(dueBetween(0, 10), 10);
  EXPECT_EQ(topic_->sequence(), 9U);
  EXPECT_TRUE(topic_->isDue(at(12)));
  EXPECT_NEAR(topic_->sinceLast(), 0.002, 1e-12);
}

TEST_F(SensorTopicTest, IsDueAtOnceAndThenAtItsRate) {
  start("<topic>t</topic><update_rate>100</update_rate>");
  EXPECT_EQ(dueBetween(0, 9), 1);
  EXPECT_EQ(dueBetween(9, 1000), 100);
}

TEST_F(SensorTopicTest, IsNotDueWhilePaused) {
  start("<topic>t</topic>");
  StepInfo paused = at(1);
  paused.paused = true;
  EXPECT_FALSE(topic_->isDue(paused));
}

TEST_F(SensorTopicTest, IsDueAtTheSameTimesWhetherOrNotSomebodyListens) {
  start("<topic>t</topic><update_rate>100</update_rate>");
  EXPECT_TRUE(topic_->hasSubscribers());
  subscription_ = Subscription();
  EXPECT_FALSE(topic_->hasSubscribers());
  EXPECT_EQ(dueBetween(0, 995), 100);
  EXPECT_EQ(dueBetween(995, 1015), 2);
  EXPECT_EQ(topic_->sequence(), 101U);
}

TEST_F(SensorTopicTest, BeginsAnewAndGoesOnWhereItWas) {
  start("<topic>t</topic><update_rate>100</update_rate>");
  EXPECT_EQ(dueBetween(0, 25), 3);
  StateArchive saved;
  topic_->transfer(saved);
  EXPECT_EQ(dueBetween(25, 100), 8);
  const std::vector<std::byte> bytes = saved.take();
  StateArchive given(bytes);
  topic_->transfer(given);
  EXPECT_EQ(dueBetween(25, 100), 8);
  EXPECT_EQ(topic_->sequence(), 10U);
  topic_->reset();
  EXPECT_EQ(dueBetween(0, 25), 3);
  EXPECT_EQ(topic_->sequence(), 2U);
}

TEST_F(SensorTopicTest, ChangesItsRateUpToThatOfTheFile) {
  start("<topic>t</topic><update_rate>100</update_rate>");
  dueBetween(0, 1000);
  EXPECT_TRUE(setRate(10));
  EXPECT_EQ(dueBetween(1000, 2000), 10);
  EXPECT_TRUE(setRate(1000));
  EXPECT_EQ(dueBetween(2000, 3000), 100);
}

TEST_F(SensorTopicTest, TellsItsMetricsToWhoeverListensToThemAlone) {
  start("<topic>t</topic><update_rate>100</update_rate><enable_metrics>true</enable_metrics>");
  subscription_ = Subscription();
  EXPECT_FALSE(topic_->hasSubscribers());
  std::vector<std::string> heard;
  const Subscription metrics = simulation_->transport().node().subscribe(
      "/t/performance_metrics", "ignition.msgs.PerformanceSensorMetrics",
      [&heard](const Message& message) { heard.push_back(messageText(message)); });
  EXPECT_TRUE(topic_->hasSubscribers());
  EXPECT_TRUE(setRate(50));
  const MessagePointer reading = newMessage("ignition.msgs.Int32");
  for (int time = 1; time <= 60; ++time) {
    if (topic_->isDue(at(time))) topic_->publish(*reading);
  }
  simulation_->transport().dispatch();
  ASSERT_EQ(heard.size(), 2);
  EXPECT_NE(heard[1].find("sim_update_rate: 50\n"), std::string::npos) << heard[1];
  EXPECT_NE(heard[1].find("nominal_update_rate: 50\n"), std::string::npos) << heard[1];
}

TEST_F(SensorTopicTest, HasNoMetricsThatNobodyAskedFor) {
  start("<topic>t</topic>");
  const Subscription metrics = simulation_->transport().node().subscribe(
      "/t/performance_metrics", "ignition.msgs.PerformanceSensorMetrics", [](const Message&) {});
  subscription_ = Subscription();
  EXPECT_FALSE(topic_->hasSubscribers());
}

TEST_F(SensorTopicTest, NamesTheSensorWhoseTopicIsNone) {
  EXPECT_THROW(
      try { start("<topic>/</topic>"); } catch (const Error& error) {
        EXPECT_EQ(error.diagnostic().position.line, 1);
        EXPECT_NE(error.diagnostic().message.find("sensor 'm::l::s' can't publish on '/'"), std::string::npos)
            << error.diagnostic().message;
        throw;
      },
      Error);
}

}  // namespace
}  // namespace pongsim
