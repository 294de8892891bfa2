#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <optional>
#include <string>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/control/differential_odometry.hh"
#include "pongsim/control/odometry_topics.hh"
#include "pongsim/control/speed_limiter.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Drives a differential drive by Twist commands, and publishes its odometry.
class DiffDrive : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Drives a differential drive by Twist commands, and publishes its odometry.",
                   Declaration::Place::kModel);
    declaration.parameter("left_joint", &leftNames_, "", "joints of the left wheels; odometry uses the first")
        .required();
    declaration.parameter("right_joint", &rightNames_, "", "joints of the right wheels; odometry uses the first")
        .required();
    declaration.parameter("wheel_separation", &separation_, "m", "distance between the wheels").above(0);
    declaration.parameter("wheel_radius", &radius_, "m", "radius of the wheels").above(0);
    declaration.parameter("topic", &topic_, "", "command topic").otherwise("/model/M/cmd_vel");
    odometryTopics_.declare(declaration);
    declareSpeedLimits(declaration, limits_, "", "m/s or rad/s");
    declareSpeedLimits(declaration, linearLimits_, "linear", "m/s");
    declareSpeedLimits(declaration, angularLimits_, "angular", "rad/s");
    declaration.subscribes("<topic>", "ignition.msgs.Twist",
                           "`linear.x` [m/s] and `angular.z` [rad/s], which hold until the next command");
    declaration.subscribes("/model/M/enable", "ignition.msgs.Boolean", "`false` stops and ignores commands");
  }

  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    const Model& model = *context.model;
    leftJoints_ = requiredJoints(sdf, "left_joint", model);
    rightJoints_ = requiredJoints(sdf, "right_joint", model);
    odometry_.emplace(separation_, radius_);
    linearLimiter_ = SpeedLimiter(speedLimits(linearLimits_, limits_, "linear", sdf));
    angularLimiter_ = SpeedLimiter(speedLimits(angularLimits_, limits_, "angular", sdf));

    const std::string prefix = cleanTopic("/model/" + std::string(model.name()));
    command_ = context.node.subscribe<ignition::msgs::Twist>(
        topicOr(topic_, prefix + "/cmd_vel"), [this](const ignition::msgs::Twist& twist) { receive(twist); },
        kCommands);
    enable_ = context.node.subscribe<ignition::msgs::Boolean>(
        prefix + "/enable", [this](const ignition::msgs::Boolean& message) { setEnabled(message.data()); });
    odometryTopics_.open(model, context.node);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const double dt = toSeconds(info.dt);
    const double linear = linearLimiter_.limit(targetLinear_, dt);
    const double angular = angularLimiter_.limit(targetAngular_, dt);
    for (Joint& joint : leftJoints_) joint.setVelocityTarget((linear - angular * separation_ / 2) / radius_);
    for (Joint& joint : rightJoints_) joint.setVelocityTarget((linear + angular * separation_ / 2) / radius_);
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    odometry_->update(leftJoints_.front().position(), rightJoints_.front().position(), toSeconds(info.dt));
    odometryTopics_.update(odometry_->value(), info.time);
  }

  void reset() override {
    odometry_->reset();
    odometryTopics_.reset();
    linearLimiter_.reset();
    angularLimiter_.reset();
    targetLinear_ = targetAngular_ = 0;
    enabled_ = true;
  }

  void transfer(StateArchive& archive) override {
    odometry_->transfer(archive);
    linearLimiter_.transfer(archive);
    angularLimiter_.transfer(archive);
    archive(targetLinear_);
    archive(targetAngular_);
    archive(enabled_);
    odometryTopics_.transfer(archive);
  }

 private:
  void receive(const ignition::msgs::Twist& twist) {
    if (!enabled_) return;
    targetLinear_ = twist.linear().x();
    targetAngular_ = twist.angular().z();
  }

  void setEnabled(bool enabled) {
    enabled_ = enabled;
    if (!enabled) targetLinear_ = targetAngular_ = 0;
  }

  std::vector<std::string> leftNames_, rightNames_;
  double separation_ = 1;
  double radius_ = 0.2;
  std::string topic_;
  SpeedLimitParameters limits_, linearLimits_, angularLimits_;

  std::vector<Joint> leftJoints_;
  std::vector<Joint> rightJoints_;
  double targetLinear_ = 0;
  double targetAngular_ = 0;
  bool enabled_ = true;
  SpeedLimiter linearLimiter_;
  SpeedLimiter angularLimiter_;
  std::optional<DifferentialOdometry> odometry_;

  OdometryTopics odometryTopics_;
  Subscription command_;
  Subscription enable_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::DiffDrive, "ignition::gazebo::systems::DiffDrive", "gz::sim::systems::DiffDrive");
