#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ros2/controllers/controller.hh"
#include "ros2/controllers/odometry_output.hh"
#include "ros2/controllers/steering_controllers/steering_kinematics.hh"
#include "ros2/controllers/twist_input.hh"
#include "ros2/controllers/wheel_odometry.hh"
#include "ros2/types/control_msgs.hh"

namespace pongsim::ros2 {

/// Drives a vehicle with steered wheels from `~/reference`: ackermann_steering_controller,
/// tricycle_steering_controller and bicycle_steering_controller.
class SteeringController final : public Controller {
 public:
  enum class Kind { kBicycle, kTricycle, kAckermann };
  explicit SteeringController(Kind kind) : kind_(kind) {}

  Outcome<void> configure(const ControllerSetup& setup) override;
  Interfaces interfaces() const override;
  Outcome<void> activate(const Loan& loan, Time now) override;
  void deactivate() override;
  void update(Time now, double period) override;
  void reset() override;
  void transfer(StateArchive& archive) override;

 private:
  void readWheels(ControllerParameters& parameters);
  void readKinematics(ControllerParameters& parameters, bool steersFront);
  std::vector<double> states(std::size_t first, std::size_t count) const;
  void updateOdometry(double period, double linear, double angular);
  void publishState(Time now);

  Kind kind_;
  std::vector<std::string> traction_;
  std::vector<std::string> steering_;
  std::vector<std::string> tractionStates_;
  std::vector<std::string> steeringStates_;
  SteeringKinematics kinematics_;
  bool isOpenLoop_ = false;
  bool readsPositions_ = false;
  bool slowsUntilSteered_ = false;
  Time timeout_{0};
  Frames frames_;
  TwistInput input_;
  OdometryOutput output_;
  std::unique_ptr<RosPublisher> state_;
  control_msgs::SteeringControllerStatus message_;
  Loan loan_;

  WheelOdometry odometry_;
  double steeringAngle_ = 0;
  std::vector<double> lastPositions_;
};

}  // namespace pongsim::ros2
