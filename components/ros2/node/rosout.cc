#include "ros2/node/rosout.hh"

#include <algorithm>
#include <chrono>
#include <string>

#include "ros2/types/rcl_interfaces.hh"

namespace pongsim::ros2 {

namespace {

// Equal to rmw_qos_profile_rosout_default.
constexpr Qos kRosoutQos{.isTransientLocal = true, .depth = 1000, .lifespan = std::chrono::seconds(10)};

builtin_interfaces::Time wallTime() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(now);
  return {static_cast<std::int32_t>(seconds.count()),
          static_cast<std::uint32_t>(std::chrono::nanoseconds(now - seconds).count())};
}

/// A node's logger name as in rcl: "robot.pongsim" for "/robot/pongsim".
std::string loggerName(const RosNode& node) {
  std::string name = node.fullName().substr(1);
  std::ranges::replace(name, '/', '.');
  return name;
}

}  // namespace

Rosout::Rosout(RosNode& node) : publisher_(node.advertise<rcl_interfaces::Log>("/rosout", kRosoutQos)) {
  sink_ = std::make_unique<LogSink>(
      LogLevel::kWarning, [publisher = publisher_.get(), node = loggerName(node)](const LogRecord& record) {
        rcl_interfaces::Log log;
        log.stamp = wallTime();
        log.level = record.level == LogLevel::kError ? rcl_interfaces::Log::kError : rcl_interfaces::Log::kWarn;
        log.name = node + "." + std::string(record.speaker);
        log.msg = record.message;
        publisher->publish(log);
      });
}

}  // namespace pongsim::ros2
