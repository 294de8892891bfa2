#pragma once

#include <memory>
#include <string>

#include "ros2/controllers/controller.hh"
#include "ros2/types/sensor_msgs.hh"

namespace pongsim::ros2 {

/// Publishes the state interfaces of an IMU on `~/imu`.
class ImuSensorBroadcaster final : public Controller {
 public:
  Outcome<void> configure(const ControllerSetup& setup) override;
  Interfaces interfaces() const override;
  Outcome<void> activate(const Loan& loan, Time now) override;
  void deactivate() override { loan_ = {}; }
  void update(Time now, double period) override;
  void reset() override {}
  void transfer(StateArchive&) override {}

 private:
  std::string sensor_;
  Frames frames_;
  std::unique_ptr<RosPublisher> publisher_;
  sensor_msgs::Imu message_;
  Loan loan_;
};

}  // namespace pongsim::ros2
