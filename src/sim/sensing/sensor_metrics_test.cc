#include "sim/sensing/sensor_metrics.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/performance_sensor_metrics.pb.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"

namespace pongsim::sim {
namespace {

using ignition::msgs::PerformanceSensorMetrics;

class SensorMetricsTest : public testing::Test {
 protected:
  void start(const std::string& type) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(
        "<sdf version='1.9'><world name='w'><model name='m'><link name='l'><sensor name='s' type='" + type +
            "'><camera/></sensor></link></model></world></sdf>",
        "world.sdf", {.loadSystems = false}, diagnostics);
    Node node = simulation_->transport().node();
    metrics_ = std::make_unique<SensorMetrics>(simulation_->world().sensors(type).at(0), "/t", node);
    EXPECT_FALSE(metrics_->hasSubscribers());
    subscription_ = node.subscribe<PerformanceSensorMetrics>(
        "/t/performance_metrics", [this](const PerformanceSensorMetrics& message) { heard_.push_back(message); });
    EXPECT_TRUE(metrics_->hasSubscribers());
  }

  void publishAt(const std::vector<int>& times) {
    for (const int time : times) metrics_->publish(std::chrono::milliseconds(time), 30);
    simulation_->transport().dispatch();
  }

  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SensorMetrics> metrics_;
  Subscription subscription_;
  std::vector<PerformanceSensorMetrics> heard_;
};

TEST_F(SensorMetricsTest, TellTheRatesFromTheSecondReadingOn) {
  start("altimeter");
  publishAt({100, 120, 220});
  ASSERT_EQ(heard_.size(), 2);
  EXPECT_EQ(heard_[0].name(), "m::l::s");
  EXPECT_NEAR(heard_[0].sim_update_rate(), 50, 1e-9);
  EXPECT_NEAR(heard_[1].sim_update_rate(), 10, 1e-9);
  EXPECT_EQ(heard_[0].nominal_update_rate(), 30);
  // readings follow each other without waiting, so in real time they are faster
  EXPECT_GT(heard_[0].real_update_rate(), heard_[0].sim_update_rate());
  EXPECT_FALSE(heard_[0].has_fps_optional());
}

TEST_F(SensorMetricsTest, TellACamerasPicturesASecond) {
  start("camera");
  publishAt({0, 100});
  ASSERT_EQ(heard_.size(), 1);
  EXPECT_DOUBLE_EQ(heard_[0].fps_optional().data(), heard_[0].real_update_rate());
}

TEST_F(SensorMetricsTest, BeginAnewWithTheWorld) {
  start("altimeter");
  publishAt({100, 120});
  metrics_->reset();
  publishAt({0});
  EXPECT_EQ(heard_.size(), 1);
  publishAt({20});
  ASSERT_EQ(heard_.size(), 2);
  EXPECT_NEAR(heard_[1].sim_update_rate(), 50, 1e-9);
}

}  // namespace
}  // namespace pongsim::sim
