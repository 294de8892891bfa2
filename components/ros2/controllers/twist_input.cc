#include "ros2/controllers/twist_input.hh"

#include <cmath>

#include "pongsim/commands.hh"
#include "ros2/node/stamp.hh"

namespace pongsim::ros2 {

namespace {

bool isSound(const geometry_msgs::Twist& twist) {
  // comparisons with what is not a number are false
  for (const double value : {twist.linear.x, twist.linear.y, twist.angular.z}) {
    if (!(std::abs(value) <= kLargestCommand)) return false;
  }
  return true;
}

}  // namespace

void TwistInput::configure(const ControllerSetup& setup, const std::string& topic, Time timeout, bool isStamped) {
  log_ = &setup.log;
  name_ = setup.ros.options().name;
  now_ = setup.now;
  timeout_ = timeout;
  if (isStamped) {
    subscription_ = setup.subscribe<geometry_msgs::TwistStamped>(topic, [this](const auto& message) {
      const builtin_interfaces::Time& stamp = message.header.stamp;
      const bool hasStamp = stamp.sec != 0 || stamp.nanosec != 0;
      receive(message.twist, hasStamp ? timeOf(stamp) : now_());
    });
  } else {
    subscription_ =
        setup.subscribe<geometry_msgs::Twist>(topic, [this](const auto& message) { receive(message, now_()); });
  }
}

void TwistInput::enable(bool isEnabled) {
  isEnabled_ = isEnabled;
  command_.reset();
}

void TwistInput::receive(const geometry_msgs::Twist& twist, Time stamp) {
  if (!isEnabled_) return;
  if (!isSound(twist)) return warnOnce("a command is ignored: a velocity is not finite, or very large");
  if (timeout_ > Time::zero() && now_() - stamp > timeout_) {
    return warnOnce("a command is ignored: its stamp is more than " + std::to_string(toSeconds(timeout_)) +
                    " s before the simulation's time; give the node that sends it use_sim_time");
  }
  command_ = {stamp, twist.linear.x, twist.linear.y, twist.angular.z};
}

void TwistInput::warnOnce(const std::string& what) {
  if (warned_ == what) return;
  warned_ = what;
  log_->warning("controller '" + name_ + "': " + what);
}

}  // namespace pongsim::ros2
