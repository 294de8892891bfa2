#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pongsim/parameters.hh"
#include "ros2/controllers/controller.hh"
#include "ros2/controllers/odometry_output.hh"
#include "ros2/controllers/rate_limiter.hh"
#include "ros2/controllers/twist_input.hh"
#include "ros2/controllers/wheel_odometry.hh"

namespace pongsim::ros2 {

/// Drives wheels on two sides from `~/cmd_vel`, and publishes `~/odom`.
class DiffDriveController final : public Controller {
 public:
  Outcome<void> configure(const ControllerSetup& setup) override;
  Interfaces interfaces() const override;
  Outcome<void> activate(const Loan& loan, Time now) override;
  void deactivate() override;
  void update(Time now, double period) override;
  void reset() override;
  void transfer(StateArchive& archive) override;

 private:
  struct Speeds {
    double linear = 0;
    double angular = 0;
    void transfer(StateArchive& archive) {
      archive(linear);
      archive(angular);
    }
  };
  void begin();
  Speeds wanted(Time now) const;
  void updateOdometry(double period, const Speeds& commanded);
  double mean(std::size_t firstState) const;

  std::vector<std::string> left_;
  std::vector<std::string> right_;
  double separation_ = 0;
  double leftRadius_ = 0;
  double rightRadius_ = 0;
  bool isOpenLoop_ = false;
  bool readsPositions_ = true;
  Time timeout_{0};
  Frames frames_;
  RateLimiter linearLimiter_;
  RateLimiter angularLimiter_;
  TwistInput input_;
  OdometryOutput output_;
  std::unique_ptr<RosPublisher> limited_;
  Loan loan_;

  Schedule publishing_;
  WheelOdometry odometry_;
  Speeds last_;
  Speeds beforeLast_;
  /// Distances that the wheels have rolled, in the last update [m].
  double leftDistance_ = 0;
  double rightDistance_ = 0;
};

}  // namespace pongsim::ros2
