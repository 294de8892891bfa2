#include "msgs/control/status_messages.hh"

#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/performance_sensor_metrics.pb.h>
#include <ignition/msgs/serialized_map.pb.h>
#include <ignition/msgs/world_stats.pb.h>

#include <cmath>

#include "msgs/fields/time.hh"

namespace pongsim::msgs {

struct StatusMessages::Parts {
  ignition::msgs::Clock clock;
  ignition::msgs::WorldStatistics statistics;
};

StatusMessages::StatusMessages() : parts_(std::make_unique<Parts>()) {}

StatusMessages::~StatusMessages() = default;

const Message& StatusMessages::clock(const Status& status) {
  setTime(status.simulated, *parts_->clock.mutable_sim());
  setTime(status.real, *parts_->clock.mutable_real());
  setTime(status.system, *parts_->clock.mutable_system());
  return parts_->clock;
}

const Message& StatusMessages::statistics(const Status& status) {
  setTime(status.simulated, *parts_->statistics.mutable_sim_time());
  setTime(status.real, *parts_->statistics.mutable_real_time());
  parts_->statistics.set_iterations(status.iterations);
  parts_->statistics.set_paused(status.paused);
  parts_->statistics.set_real_time_factor(std::round(status.realTimeFactor * 1e4) / 1e4);
  return parts_->statistics;
}

Status statusOf(const Message& message) {
  const auto& statistics = static_cast<const ignition::msgs::WorldStatistics&>(message);
  return {.simulated = timeOf(statistics.sim_time()),
          .real = timeOf(statistics.real_time()),
          .iterations = statistics.iterations(),
          .realTimeFactor = statistics.real_time_factor(),
          .paused = statistics.paused(),
          .stepSize = timeOf(statistics.step_size())};
}

Status statusOfState(const Message& step) {
  return statusOf(static_cast<const ignition::msgs::SerializedStepMap&>(step).stats());
}

void setSensorName(const std::string& name, Message& message) {
  static_cast<ignition::msgs::PerformanceSensorMetrics&>(message).set_name(name);
}

void setRates(const SensorRates& rates, Message& message) {
  auto& metrics = static_cast<ignition::msgs::PerformanceSensorMetrics&>(message);
  metrics.set_sim_update_rate(rates.simulated);
  metrics.set_real_update_rate(rates.real);
  metrics.set_nominal_update_rate(rates.nominal);
  if (rates.pictures) metrics.mutable_fps_optional()->set_data(*rates.pictures);
}

}  // namespace pongsim::msgs
