#include <ignition/msgs/twist.pb.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "kinematics.hh"
#include "pongsim/commands.hh"
#include "pongsim/control/odometry_topics.hh"
#include "pongsim/control/speed_limiter.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Drives four mecanum wheels by Twist commands, also sideways, and publishes odometry.
class MecanumDrive : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Drives four mecanum wheels by Twist commands, also sideways, and publishes odometry.",
                   Declaration::Place::kModel);
    for (Wheel& wheel : wheels_) {
      declaration
          .parameter(wheel.parameter, &wheel.names, "",
                     std::string("joints of the ") + wheel.place + " wheels; odometry uses the first")
          .required();
    }
    const auto length = [&](const char* name, double& value, const char* text) {
      declaration.parameter(name, &value, "m", text).above(0);
    };
    length("wheel_separation", geometry_.wheelSeparation, "distance between left and right wheels");
    length("wheelbase", geometry_.wheelbase, "distance between front and rear axles");
    length("wheel_radius", geometry_.wheelRadius, "radius of the wheels");
    declaration.parameter("topic", &topic_, "", "command topic").otherwise("/model/M/cmd_vel");
    odometryTopics_.declare(declaration);
    declareSpeedLimits(declaration, limits_, "", "m/s or rad/s");
    declaration.subscribes("<topic>", "ignition.msgs.Twist",
                           "`linear.x`, `linear.y` [m/s] and `angular.z` [rad/s], which hold until the next command");
  }

  void configure(const SystemContext& context) override {
    const Model& model = *context.model;
    for (Wheel& wheel : wheels_) wheel.joints = requiredJoints(context.sdf, wheel.parameter, model);
    const SpeedLimits linear = speedLimits({}, limits_, "linear", context.sdf);
    forward_ = lateral_ = SpeedLimiter(linear);
    angular_ = SpeedLimiter(speedLimits({}, limits_, "angular", context.sdf));
    command_ = context.node.subscribe<ignition::msgs::Twist>(
        topicOr(topic_, "/model/" + std::string(model.name()) + "/cmd_vel"),
        [this](const ignition::msgs::Twist& twist) { receive(twist); }, kCommands);
    odometryTopics_.open(model, context.node);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const double dt = toSeconds(info.dt);
    const MecanumWheels speeds = wheelsFor(
        geometry_, {forward_.limit(target_.x, dt), lateral_.limit(target_.y, dt), angular_.limit(target_.yaw, dt)});
    const std::array<double, 4> inOrder{speeds.frontLeft, speeds.frontRight, speeds.backLeft, speeds.backRight};
    for (std::size_t i = 0; i < wheels_.size(); ++i) {
      for (Joint& joint : wheels_[i].joints) joint.setVelocityTarget(inOrder[i]);
    }
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const auto angle = [this](std::size_t wheel) { return wheels_[wheel].joints.front().position(); };
    odometry_.update(geometry_, {angle(0), angle(1), angle(2), angle(3)}, toSeconds(info.dt));
    odometryTopics_.update(odometry_.value(), info.time);
  }

  void reset() override {
    odometry_ = {};
    odometryTopics_.reset();
    for (SpeedLimiter* limiter : {&forward_, &lateral_, &angular_}) limiter->reset();
    target_ = {};
  }

  void transfer(StateArchive& archive) override {
    odometry_.transfer(archive);
    odometryTopics_.transfer(archive);
    for (SpeedLimiter* limiter : {&forward_, &lateral_, &angular_}) limiter->transfer(archive);
    for (double* value : {&target_.x, &target_.y, &target_.yaw}) archive(*value);
  }

 private:
  struct Wheel {
    const char* parameter;
    const char* place;
    std::vector<std::string> names = {};
    std::vector<Joint> joints = {};
  };

  void receive(const ignition::msgs::Twist& twist) {
    target_ = {twist.linear().x(), twist.linear().y(), twist.angular().z()};
  }

  std::array<Wheel, 4> wheels_{Wheel{"front_left_joint", "front left"}, Wheel{"front_right_joint", "front right"},
                               Wheel{"back_left_joint", "back left"}, Wheel{"back_right_joint", "back right"}};
  MecanumGeometry geometry_;
  std::string topic_;
  SpeedLimitParameters limits_;

  PlanarTwist target_;
  SpeedLimiter forward_, lateral_, angular_;
  MecanumOdometry odometry_;

  OdometryTopics odometryTopics_;
  Subscription command_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::MecanumDrive, "ignition::gazebo::systems::MecanumDrive",
                      "gz::sim::systems::MecanumDrive");
