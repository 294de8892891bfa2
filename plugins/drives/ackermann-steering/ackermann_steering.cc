#include <ignition/msgs/twist.pb.h>

#include <string>
#include <vector>

#include "geometry.hh"
#include "pongsim/commands.hh"
#include "pongsim/control/command_topic.hh"
#include "pongsim/control/odometry_topics.hh"
#include "pongsim/control/setpoint.hh"
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
    const auto joints = [&](const char* name, std::vector<std::string>& names, const char* text) -> Parameter& {
      return declaration.parameter(name, &names, "", text);
    };
    joints("left_joint", leftNames_, "joints that drive the left wheels; odometry uses the first one")
        .otherwise("required unless steering_only");
    joints("right_joint", rightNames_, "joints that drive the right wheels; odometry uses the first")
        .otherwise("required unless steering_only");
    joints("left_steering_joint", leftSteeringNames_, "joints that steer the left wheels").required();
    joints("right_steering_joint", rightSteeringNames_, "joints that steer the right wheels").required();
    declaration.parameter("steering_only", &steersOnly_, "",
                          "the command is a steering angle; wheels are not driven, and there is no odometry");
    declaration.parameter("steer_p_gain", &steeringGain_, "1/s", "gain of the steering joints").atLeast(0);
    const auto length = [&](const char* name, double& value, const char* text) {
      declaration.parameter(name, &value, "m", text).above(0);
    };
    length("wheel_separation", geometry_.wheelSeparation, "distance between left and right wheels");
    length("kingpin_width", geometry_.kingpinWidth, "distance between the steering axes");
    length("wheel_base", geometry_.wheelBase, "distance between front and rear axles");
    length("wheel_radius", geometry_.wheelRadius, "radius of the wheels");
    declaration.parameter("steering_limit", &geometry_.steeringLimit, "rad", "maximum steering angle").above(0);
    commandTopic_.declare(declaration, "/model/M/cmd_vel, with steering_only /model/M/steer_angle");
    odometryTopics_.declare(declaration);
    declareSpeedLimits(declaration, limits_, "", "m/s or rad/s");
    declaration.subscribes("<topic>", "ignition.msgs.Twist",
                           "`linear.x` [m/s] and `angular.z` [rad/s], which hold until the next command");
    declaration.subscribes("<topic>", "ignition.msgs.Double", "with `<steering_only>`: steering angle [rad]");
    declaration.subscribes(
        "<topic>", "ignition.msgs.Actuators",
        "with `<use_actuator_msg>`, which implies `<steering_only>`: steering angle `position[actuator_number]` [rad]");
  }

  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    const Model& model = *context.model;
    leftSteeringJoints_ = requiredJoints(sdf, "left_steering_joint", model);
    rightSteeringJoints_ = requiredJoints(sdf, "right_steering_joint", model);
    linearLimiter_ = SpeedLimiter(speedLimits({}, limits_, "linear", sdf));
    angularLimiter_ = SpeedLimiter(speedLimits({}, limits_, "angular", sdf));
    commandTopic_.check(context);
    steersOnly_ = steersOnly_ || commandTopic_.usesActuators;
    const std::string prefix = "/model/" + std::string(model.name());
    if (steersOnly_) {
      angle_.listen(context, commandTopic_, prefix + "/steer_angle", Setpoint::Kind::kPosition, 0);
      return;
    }
    leftJoints_ = requiredJoints(sdf, "left_joint", model);
    rightJoints_ = requiredJoints(sdf, "right_joint", model);
    command_ = context.node.subscribe<ignition::msgs::Twist>(
        commandTopic_.name(context, prefix + "/cmd_vel"),
        [this](const ignition::msgs::Twist& twist) { receive(twist); }, kCommands);
    odometryTopics_.open(model, context.node);
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const double dt = toSeconds(info.dt);
    AckermannCommand command;
    if (steersOnly_) {
      command = ackermannAngles(geometry_, angularLimiter_.limit(angle_.value(), dt));
    } else {
      const double linear = linearLimiter_.limit(targetLinear_, dt);
      const double angular = angularLimiter_.limit(targetAngular_, dt);
      command = ackermannCommand(geometry_, linear, angular);
    }
    for (Joint& joint : leftJoints_) joint.setVelocityTarget(command.leftSpeed);
    for (Joint& joint : rightJoints_) joint.setVelocityTarget(command.rightSpeed);
    steer(leftSteeringJoints_, command.leftAngle);
    steer(rightSteeringJoints_, command.rightAngle);
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused || steersOnly_) return;
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
    angle_.reset();
  }

  void transfer(StateArchive& archive) override {
    odometry_.transfer(archive);
    odometryTopics_.transfer(archive);
    linearLimiter_.transfer(archive);
    angularLimiter_.transfer(archive);
    archive(targetLinear_);
    archive(targetAngular_);
    archive(angle_);
  }

 private:
  /// As in Fortress, turns all joints of a side by the error of the first.
  void steer(std::vector<Joint>& joints, double angle) const {
    const double velocity = steeringGain_ * (angle - joints.front().position());
    for (Joint& joint : joints) joint.setVelocityTarget(velocity);
  }

  void receive(const ignition::msgs::Twist& twist) {
    targetLinear_ = twist.linear().x();
    targetAngular_ = twist.angular().z();
  }

  std::vector<std::string> leftNames_, rightNames_, leftSteeringNames_, rightSteeringNames_;
  AckermannGeometry geometry_;
  CommandTopic commandTopic_;
  SpeedLimitParameters limits_;
  bool steersOnly_ = false;
  double steeringGain_ = 1;

  std::vector<Joint> leftJoints_, rightJoints_, leftSteeringJoints_, rightSteeringJoints_;
  double targetLinear_ = 0;
  double targetAngular_ = 0;
  /// With `steersOnly_`: steering angle of the middle of the axle [rad].
  Setpoint angle_;
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
