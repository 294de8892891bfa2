#pragma once

#include <memory>
#include <string>
#include <utility>

#include "ros2/controllers/controller.hh"
#include "ros2/controllers/odometry_output.hh"
#include "ros2/controllers/tricycle_controller/axle_limiters.hh"
#include "ros2/controllers/twist_input.hh"
#include "ros2/controllers/wheel_odometry.hh"
#include "ros2/node/service.hh"

namespace pongsim::ros2 {

/// Drives a vehicle with one wheel that is both driven and steered, from `~/cmd_vel`.
class TricycleController final : public Controller {
 public:
  Outcome<void> configure(const ControllerSetup& setup) override;
  Interfaces interfaces() const override;
  Outcome<void> activate(const Loan& loan, Time now) override;
  void deactivate() override;
  void update(Time now, double period) override;
  void reset() override;
  void transfer(StateArchive& archive) override;

 private:
  struct Axle {
    /// [rad/s]
    double speed = 0;
    /// [rad]
    double angle = 0;
    void transfer(StateArchive& archive) {
      archive(speed);
      archive(angle);
    }
  };
  Axle axleFor(double linear, double angular) const;

  std::string tractionJoint_;
  std::string steeringJoint_;
  double wheelbase_ = 0;
  double wheelRadius_ = 0;
  bool isOpenLoop_ = false;
  bool tellsPose_ = true;
  Time timeout_{0};
  TractionLimiter tractionLimiter_;
  SteeringLimiter steeringLimiter_;
  TwistInput input_;
  OdometryOutput output_;
  std::unique_ptr<RosPublisher> ackermann_;
  std::unique_ptr<RosServer> resetOdometry_;
  Loan loan_;

  WheelOdometry odometry_;
  Axle last_;
  Axle beforeLast_;
};

}  // namespace pongsim::ros2
