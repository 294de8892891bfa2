#include <ignition/msgs/pose.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "pongsim/commands.hh"
#include "pongsim/math.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// A pose in the plane [m, rad].
struct PlanarPose {
  double x = 0;
  double y = 0;
  double heading = 0;

  void transfer(StateArchive& archive) {
    archive(x);
    archive(y);
    archive(heading);
  }
};

/// Commands a drive to turn to a pose, to drive there, and to take its heading.
class DriveToPoseController : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Drives a model with DiffDrive to a commanded pose, by the odometry of OdometryPublisher.",
                   Declaration::Place::kModel);
    declaration.parameter("linear_p_gain", &linearGain_, "1/s", "speed per distance");
    declaration.parameter("angular_p_gain", &angularGain_, "1/s", "turning rate per error of the heading");
    declaration.parameter("linear_deviation", &nearEnough_, "m", "a pose is reached within this distance").atLeast(0);
    declaration.parameter("angular_deviation", &straightEnough_, "rad", "and with this error of the heading")
        .atLeast(0);
    declaration.subscribes("/model/M/cmd_pose", "ignition.msgs.Pose_V", "its first pose is the goal");
    declaration.subscribes("/model/M/pose", "ignition.msgs.Pose_V", "current pose, in the frame of the goal");
    declaration.publishes("/model/M/cmd_vel", "ignition.msgs.Twist", "command to the drive, until the goal is reached");
    declaration.publishes("/model/M/reached_pose", "ignition.msgs.Pose", "current pose, once the goal is reached");
    declaration.sharesTopics();
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    const std::string prefix = "/model/" + std::string(context.model->name());
    goals_ = context.node.subscribe<ignition::msgs::Pose_V>(
        cleanTopic(prefix + "/cmd_pose"),
        [this](const ignition::msgs::Pose_V& message) { receive(message, "/cmd_pose", goal_); }, kCommands);
    poses_ = context.node.subscribe<ignition::msgs::Pose_V>(
        cleanTopic(prefix + "/pose"),
        [this](const ignition::msgs::Pose_V& message) { receive(message, "/pose", pose_); }, kCommands);
    commands_ = context.node.advertise<ignition::msgs::Twist>(cleanTopic(prefix + "/cmd_vel"));
    reached_ = context.node.advertise<ignition::msgs::Pose>(cleanTopic(prefix + "/reached_pose"));
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused || !goal_ || !pose_) return;
    const double x = goal_->x - pose_->x, y = goal_->y - pose_->y;
    double distance = math::hypot(x, y);
    double error = turn(goal_->heading);
    const bool isThere = distance <= nearEnough_;
    const bool isReached = isThere && std::abs(error) <= straightEnough_;
    if (isReached) error = 0;
    if (!isThere) {
      error = turn(math::atan2(y, x));
      if (std::abs(error) <= straightEnough_) error = 0;
    }
    // it turns on the spot, then it drives straight
    if (isThere || error != 0) distance = 0;
    command(linearGain_ * distance, angularGain_ * error);
    if (!isReached) return;
    tellReached();
    goal_.reset();
  }

  void reset() override {
    goal_.reset();
    pose_.reset();
    hasWarned_ = false;
  }

  void transfer(StateArchive& archive) override {
    archive(goal_);
    archive(pose_);
  }

 private:
  /// @return From the current heading to another one, in [-pi, pi].
  double turn(double heading) const { return std::remainder(heading - pose_->heading, 2 * std::numbers::pi); }

  void receive(const ignition::msgs::Pose_V& message, const char* topic, std::optional<PlanarPose>& pose) {
    if (message.pose_size() == 0) {
      if (!hasWarned_) log_->warning(std::string("a message without a pose on ") + topic + " was ignored");
      hasWarned_ = true;
      return;
    }
    const ignition::msgs::Pose& first = message.pose(0);
    const ignition::msgs::Quaternion& q = first.orientation();
    Quaternion rotation(q.w(), q.x(), q.y(), q.z());
    // one that is not given
    if (rotation.coeffs().isZero(0)) rotation = Quaternion::Identity();
    pose = {.x = first.position().x(), .y = first.position().y(), .heading = yawOf(rotation.normalized())};
  }

  void command(double speed, double rate) {
    ignition::msgs::Twist message;
    message.mutable_linear()->set_x(std::clamp(speed, -kLargestCommand, kLargestCommand));
    message.mutable_angular()->set_z(std::clamp(rate, -kLargestCommand, kLargestCommand));
    commands_.publish(message);
  }

  void tellReached() {
    ignition::msgs::Pose message;
    message.mutable_position()->set_x(pose_->x);
    message.mutable_position()->set_y(pose_->y);
    message.mutable_orientation()->set_w(math::cos(pose_->heading / 2));
    message.mutable_orientation()->set_z(math::sin(pose_->heading / 2));
    reached_.publish(message);
  }

  double linearGain_ = 1;
  double angularGain_ = 2;
  double nearEnough_ = 0.1;
  double straightEnough_ = 0.05;

  std::optional<PlanarPose> goal_;
  std::optional<PlanarPose> pose_;
  bool hasWarned_ = false;
  const Logger* log_ = nullptr;
  Subscription goals_, poses_;
  Publisher commands_, reached_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::DriveToPoseController, "gz::sim::systems::DriveToPoseController",
                      "ignition::gazebo::systems::DriveToPoseController");
