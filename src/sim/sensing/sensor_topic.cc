#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "msgs/control/control_messages.hh"
#include "pongsim/log.hh"
#include "pongsim/sensing/sensor_topic.hh"
#include "sim/sensing/sensor_metrics.hh"

namespace pongsim {

namespace {

/// @return Time between two messages; zero: one every step.
Time messagePeriod(double rate) {
  if (!(rate > 0)) return Time::zero();
  return std::chrono::floor<std::chrono::milliseconds>(fromSeconds(std::min(1 / rate, 1e9)));
}

}  // namespace

SensorTopic::SensorTopic(const Sensor& sensor, std::string_view suffix, std::string_view type, Node& node,
                         std::string_view behind)
    : frameName_(sensor.frameName()),
      name_(cleanTopic(sensor.topic(suffix))),
      largestRate_(sensor.updateRate()),
      rate_(largestRate_),
      period_(messagePeriod(rate_)) {
  try {
    publisher_ = node.advertise(name_ + std::string(behind), type);
    if (sensor.hasMetrics()) metrics_ = std::make_unique<sim::SensorMetrics>(sensor, name_, node);
  } catch (const std::invalid_argument& error) {
    throw Error({Severity::kError,
                 sensor.sdf().position,
                 "sensor '" + sensor.scopedName() + "' can't publish on '" + name_ + "': " + error.what(),
                 {}});
  }
  try {
    rateService_ = node.serve(name_ + "/set_rate", "ignition.msgs.Double", "ignition.msgs.Empty",
                              [this](const Message& request, Message&) {
                                setRate(msgs::number(request));
                                return true;
                              });
  } catch (const std::invalid_argument& error) {
    // such as that of a model's copy, which publishes on the same topic, as in Fortress
    Logger("sensors").warning("the rate of sensor '" + sensor.scopedName() + "' can't be changed: " + error.what());
  }
}

SensorTopic::~SensorTopic() = default;

void SensorTopic::declare(Declaration& declaration) {
  declaration.publishes("TOPIC/performance_metrics", "ignition.msgs.PerformanceSensorMetrics",
                        "with `<enable_metrics>`: its actual rate, in simulated and in real time");
  declaration.serves("TOPIC/set_rate", "ignition.msgs.Double", "ignition.msgs.Empty",
                     "messages per simulated second, at most the file's rate");
}

bool SensorTopic::hasSubscribers() const {
  return publisher_.hasSubscribers() || (metrics_ && metrics_->hasSubscribers());
}

void SensorTopic::publish(const Message& message) {
  publisher_.publish(message);
  if (metrics_) metrics_->publish(last_, rate_);
}

void SensorTopic::publish(const Message& message, const Bulk& bulk) {
  publisher_.publish(message, bulk);
  if (metrics_) metrics_->publish(last_, rate_);
}

void SensorTopic::setRate(double rate) {
  if (!(rate >= 0)) return;
  // `<update_rate>` of the file is the upper limit
  if (largestRate_ > 0) rate = rate > 0 ? std::min(rate, largestRate_) : largestRate_;
  rate_ = rate;
  period_ = messagePeriod(rate);
  due_ = now_ + period_;
}

bool SensorTopic::isDue(const StepInfo& info) {
  if (info.paused) return false;
  now_ = info.time;
  if (info.time < due_) return false;
  // at multiples of the period, so that the mean rate is exact even if the period is no multiple of the step
  if (period_ > Time::zero()) due_ = Time((info.time / period_ + 1) * period_.count());
  sinceLast_ = count_ > 0 ? toSeconds(info.time - last_) : 0;
  last_ = info.time;
  ++count_;
  return true;
}

void SensorTopic::reset() {
  due_ = now_ = last_ = Time::zero();
  sinceLast_ = 0;
  count_ = 0;
  if (metrics_) metrics_->reset();
}

void SensorTopic::transfer(StateArchive& archive) {
  archive(rate_);
  archive.check(rate_ >= 0);
  period_ = messagePeriod(rate_);
  archive(due_);
  archive(now_);
  archive(last_);
  archive(count_);
}

}  // namespace pongsim
