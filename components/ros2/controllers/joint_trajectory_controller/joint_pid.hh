#pragma once

#include <algorithm>
#include <limits>
#include <string>

#include "pongsim/state/state_archive.hh"
#include "ros2/controllers/controller_parameters.hh"

namespace pongsim::ros2 {

/// The PID controller of a joint that follows a trajectory by velocities or efforts.
class JointPid {
 public:
  /// Reads "gains.JOINT.p" and the others.
  static JointPid read(ControllerParameters& parameters, const std::string& joint) {
    const auto number = [&](const char* name, double fallback) {
      return parameters.number("gains." + joint + "." + name, fallback);
    };
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    JointPid pid;
    pid.p_ = number("p", 0);
    pid.i_ = number("i", 0);
    pid.d_ = number("d", 0);
    pid.feedForward_ = number("ff_velocity_scale", 0);
    const double clamp = number("i_clamp", kInfinity);
    pid.integralMax_ = std::min(clamp, number("i_clamp_max", kInfinity));
    pid.integralMin_ = std::max(-clamp, number("i_clamp_min", -kInfinity));
    pid.commandMax_ = number("u_clamp_max", kInfinity);
    pid.commandMin_ = number("u_clamp_min", -kInfinity);
    if (pid.integralMin_ > pid.integralMax_ || pid.commandMin_ > pid.commandMax_) {
      parameters.complain("'gains." + joint + "': a lower clamp is above the upper one");
    }
    return pid;
  }

  /// @param desiredVelocity Fed forward.
  double command(double error, double velocityError, double desiredVelocity, double dt) {
    // of the term, so that a change of the gain does not jump
    integral_ = std::max(integralMin_, std::min(integralMax_, integral_ + i_ * error * dt));
    const double command = p_ * error + integral_ + d_ * velocityError;
    return std::max(commandMin_, std::min(commandMax_, command)) + feedForward_ * desiredVelocity;
  }
  void reset() { integral_ = 0; }
  void transfer(StateArchive& archive) { archive(integral_); }

 private:
  double p_ = 0;
  double i_ = 0;
  double d_ = 0;
  double feedForward_ = 0;
  double integralMin_ = 0;
  double integralMax_ = 0;
  double commandMin_ = 0;
  double commandMax_ = 0;
  double integral_ = 0;
};

}  // namespace pongsim::ros2
