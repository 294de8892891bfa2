#include "sim/sensing/sensor_metrics.hh"

#include <algorithm>
#include <utility>

#include "msgs/control/status_messages.hh"

namespace pongsim::sim {

namespace {

constexpr const char* kType = "ignition.msgs.PerformanceSensorMetrics";

// The clock's resolution [s]: a lower bound for periods, so that rates stay finite.
constexpr double kShortest = 1e-9;

}  // namespace

SensorMetrics::SensorMetrics(const Sensor& sensor, const std::string& topic, Node& node)
    : isCamera_(sensor.settings<CameraSettings>() != nullptr),
      message_(newMessage(kType)),
      publisher_(node.advertise(topic + "/performance_metrics", kType)) {
  msgs::setSensorName(sensor.scopedName(), *message_);
}

void SensorMetrics::publish(Time now, double nominalRate) {
  const Moment moment{now, Clock::now()};
  const std::optional<Moment> last = std::exchange(last_, moment);
  if (!last) return;
  const double simulated = toSeconds(moment.simulated - last->simulated);
  const double real = std::chrono::duration<double>(moment.real - last->real).count();
  realPeriods_.add(real);
  if (!hasSubscribers()) return;
  msgs::SensorRates rates{
      .simulated = 1 / std::max(simulated, kShortest), .real = 1 / std::max(real, kShortest), .nominal = nominalRate};
  if (isCamera_) rates.pictures = 1 / std::max(realPeriods_.mean(), kShortest);
  msgs::setRates(rates, *message_);
  publisher_.publish(*message_);
}

void SensorMetrics::reset() {
  last_.reset();
  realPeriods_ = {};
}

}  // namespace pongsim::sim
