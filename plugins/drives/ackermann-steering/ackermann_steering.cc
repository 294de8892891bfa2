#include <ignition/msgs/twist.pb.h>

#include <string>
#include <vector>

#include "geometry.hh"
#include "pongsim/commands.hh"
#include "pongsim/control/odometry_topics.hh"
#include "pongsim/control/speed_limiter.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Drives a car with steered wheels by Twist commands, and publishes its odometry.
class AckermannSteering : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Drives a car with steered wheels by Twist commands, and publishes its odometry.",
                   Declaration::Place::kModel);
    const auto joints = [&](const char* name, std::vector<std::string>& names, const char* text) {
      declaration.parameter(name, &names, "", text).required();
    };
    joints("left_joint", leftNames_, "joints that drive the left wheels; odometry uses the first one");
    joints("right_joint", rightNames_, "joints that drive the right wheels; odometry uses the first");
    joints("left_steering_joint", leftSteeringNames_, "joints that steer the left wheels");
    joints("right_steering_joint", rightSteeringNames_, "joints that steer the right wheels");
    const auto length = [&](const char* name, double& value, const char* text) {
      declaration.parameter(name, &value, "m", text).above(0);
    };
    length("wheel_separation", geometry_.wheelSeparation, "distance between left and right wheels");
    length("kingpin_width", geometry_.kingpinWidth, "distance between the steering axes");
    length("wheel_base", geometry_.wheelBase, "distance between front and rear axles");
    length("wheel_radius", geometry_.wheelRadius, "radius of the wheels");
    declaration.parameter("steering_limit", &geometry_.steeringLimit, "rad", "maximum steering angle").above(0);
    declaration.parameter("topic", &topic_, "", "command topic").otherwise("/model/M/cmd_vel");
    odometryTopics_.declare(declaration);
    declareSpeedLimits(declaration, limits_, "", "m/s or rad/s");
    declaration.subscribes("<topic>", "ignition.msgs.Twist",
                           "`linear.x` [m/s] and `angular.z` [rad/s], which hold until the next command");
  }

  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    const Model& model = *context.model;
    leftJoints_ = requiredJoints(sdf, "left_joint", model);
    rightJoints_ = requiredJoints(sdf, "right_joint", model);
    leftSteeringJoints_ = requiredJoints(sdf, "left_steering_joint", model);
    rightSteeringJoints_ = requiredJoints(sdf, "right_steering_joint", model);
    linearLimiter_ = SpeedLimiter(speedLimits({}, limits_, "linear", sdf));
    angularLimiter_ = SpeedLimiter(speedLimits({}, limits_, "angular", sdf));
    command_ = context.node.subscribe<ignition::msgs::Twist>(
        topicOr(topic_, "/model/" + std::string(model.name()) + "/cmd_vel"),
        [this](const ignition::msgs::Twist& twist) { receive(twist); }, kCommands);
    odometryTopics_.open(model, context.node);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const double dt = toSeconds(info.dt);
    const double linear = linearLimiter_.limit(targetLinear_, dt);
    const double angular = angularLimiter_.limit(targetAngular_, dt);
    const AckermannCommand command = ackermannCommand(geometry_, linear, angular);
    for (Joint& joint : leftJoints_) joint.setVelocityTarget(command.leftSpeed);
    for (Joint& joint : rightJoints_) joint.setVelocityTarget(command.rightSpeed);
    steer(leftSteeringJoints_, command.leftAngle);
    steer(rightSteeringJoints_, command.rightAngle);
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    odometry_.update(geometry_, leftJoints_.front().position(), rightJoints_.front().position(),
                     (leftSteeringJoints_.front().position() + rightSteeringJoints_.front().position()) / 2,
                     toSeconds(info.dt));
    odometryTopics_.update(odometry_.value(), info.time);
  }

  void reset() override {
    odometry_ = {};
    odometryTopics_.reset();
    linearLimiter_.reset();
    angularLimiter_.reset();
    targetLinear_ = targetAngular_ = 0;
  }

  void transfer(StateArchive& archive) override {
    odometry_.transfer(archive);
    odometryTopics_.transfer(archive);
    linearLimiter_.transfer(archive);
    angularLimiter_.transfer(archive);
    archive(targetLinear_);
    archive(targetAngular_);
  }

 private:
  /// As in Fortress, turns all joints of a side by the error of the first, with a gain of 1/s.
  static void steer(std::vector<Joint>& joints, double angle) {
    const double velocity = angle - joints.front().position();
    for (Joint& joint : joints) joint.setVelocityTarget(velocity);
  }

  void receive(const ignition::msgs::Twist& twist) {
    targetLinear_ = twist.linear().x();
    targetAngular_ = twist.angular().z();
  }

  std::vector<std::string> leftNames_, rightNames_, leftSteeringNames_, rightSteeringNames_;
  AckermannGeometry geometry_;
  std::string topic_;
  SpeedLimitParameters limits_;

  std::vector<Joint> leftJoints_, rightJoints_, leftSteeringJoints_, rightSteeringJoints_;
  double targetLinear_ = 0;
  double targetAngular_ = 0;
  SpeedLimiter linearLimiter_;
  SpeedLimiter angularLimiter_;
  AckermannOdometry odometry_;

  OdometryTopics odometryTopics_;
  Subscription command_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::AckermannSteering, "ignition::gazebo::systems::AckermannSteering",
                      "gz::sim::systems::AckermannSteering");
