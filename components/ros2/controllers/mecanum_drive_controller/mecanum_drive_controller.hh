#pragma once

#include <array>
#include <memory>
#include <string>

#include "ros2/controllers/controller.hh"
#include "ros2/controllers/odometry_output.hh"
#include "ros2/controllers/rate_limiter.hh"
#include "ros2/controllers/twist_input.hh"
#include "ros2/controllers/wheel_odometry.hh"
#include "ros2/types/control_msgs.hh"

namespace pongsim::ros2 {

/// Drives four mecanum wheels from `~/reference`.
class MecanumDriveController final : public Controller {
 public:
  Outcome<void> configure(const ControllerSetup& setup) override;
  Interfaces interfaces() const override;
  Outcome<void> activate(const Loan& loan, Time now) override;
  void deactivate() override;
  void update(Time now, double period) override;
  void reset() override;
  void transfer(StateArchive& archive) override;

 private:
  /// Forward, to the left, anticlockwise.
  using Speeds = std::array<double, 3>;
  void updateOdometry(double period);
  std::array<double, 4> wheelSpeeds(const Speeds& speeds) const;
  void publishState(Time now, const Speeds& wanted);

  /// Front left, front right, rear right, rear left.
  std::array<std::string, 4> joints_;
  std::array<std::string, 4> stateJoints_;
  double radius_ = 0;
  /// Half the wheelbase plus half the track [m].
  double reach_ = 0;
  Vector3 offset_ = Vector3::Zero();
  Time timeout_{0};
  Frames frames_;
  std::array<RateLimiter, 3> limiters_;
  TwistInput input_;
  OdometryOutput output_;
  std::unique_ptr<RosPublisher> state_;
  control_msgs::MecanumDriveControllerState message_;
  Loan loan_;

  WheelOdometry odometry_;
  Speeds last_{};
  Speeds beforeLast_{};
};

}  // namespace pongsim::ros2
