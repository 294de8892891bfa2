#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/odometry_with_covariance.pb.h>
#include <ignition/msgs/pose_v.pb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "pongsim/control/rolling_mean.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Publishes a model's true pose and velocity as odometry.
class OdometryPublisher : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Publishes a model's true pose and velocity as odometry.", Declaration::Place::kModel);
    declaration.parameter("odom_frame", &frame_, "", "frame of the odometry, in the headers").otherwise("M/odom");
    declaration.parameter("robot_base_frame", &childFrame_, "", "frame of the model, in the headers")
        .otherwise("M/base_footprint");
    declaration.parameter("odom_publish_frequency", &frequency_, "Hz",
                          "messages per simulated second; 0: one per step");
    declaration.parameter("odom_topic", &odometryTopic_, "", "topic of odometry").otherwise("/model/M/odometry");
    declaration.parameter("odom_covariance_topic", &covarianceTopic_, "", "topic of odometry with covariance")
        .otherwise("/model/M/odometry_with_covariance");
    declaration.parameter("tf_topic", &tfTopic_, "", "topic of the pose").otherwise("/model/M/pose");
    declaration.parameter("dimensions", &dimensions_, "", "2 leaves out height, roll and pitch; or 3")
        .atLeast(2)
        .atMost(3);
    declaration.parameter("xyz_offset", &offset_, "m", "position of the base in the model");
    declaration.parameter("rpy_offset", &angles_, "rad", "roll, pitch and yaw of the base in the model");
    declaration.parameter("gaussian_noise", &noise_, "m/s and rad/s", "standard deviation of the noise on velocities")
        .atLeast(0);
    declaration.publishes("<odom_topic>", "ignition.msgs.Odometry", "pose in the world and velocity in the base");
    declaration.publishes("<odom_covariance_topic>", "ignition.msgs.OdometryWithCovariance",
                          "the same, with the square of the noise as variances");
    declaration.publishes("<tf_topic>", "ignition.msgs.Pose_V", "the same pose");
  }

  void configure(const SystemContext& context) override {
    model_ = *context.model;
    random_ = &context.random;
    isSpatial_ = dimensions_ == 3;
    X_ModelBase_ = {offset_, fromRollPitchYaw(angles_.x(), angles_.y(), angles_.z())};
    schedule_ = Schedule(periodOf(frequency_));

    const std::string name(model_->name());
    if (frame_.empty()) frame_ = name + "/odom";
    if (childFrame_.empty()) childFrame_ = name + "/base_footprint";
    const std::string prefix = "/model/" + name;
    odometry_ = context.node.advertise<ignition::msgs::Odometry>(topicOr(odometryTopic_, prefix + "/odometry"));
    covariance_ = context.node.advertise<ignition::msgs::OdometryWithCovariance>(
        topicOr(covarianceTopic_, prefix + "/odometry_with_covariance"));
    tf_ = context.node.advertise<ignition::msgs::Pose_V>(topicOr(tfTopic_, prefix + "/pose"));
    last_ = basePose();
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const Pose X_WorldBase = basePose();
    addVelocity(X_WorldBase, toSeconds(info.dt));
    last_ = X_WorldBase;
    if (!schedule_.isDue(info.time)) return;
    if (odometry_.hasSubscribers() || covariance_.hasSubscribers()) publishOdometry(X_WorldBase, info.time);
    if (tf_.hasSubscribers()) publishTf(X_WorldBase, info.time);
  }

  void reset() override {
    schedule_.reset();
    last_ = basePose();
    velocity_ = {};
  }

  void transfer(StateArchive& archive) override {
    archive(schedule_);
    archive(last_);
    for (RollingMean<10>& mean : velocity_) archive(mean);
  }

 private:
  Pose basePose() const { return model_->pose() * X_ModelBase_; }

  /// The change of pose in a step, in the axes of the base, as in Fortress.
  void addVelocity(const Pose& X_WorldBase, double dt) {
    Vector3 turn = rollPitchYawOf(X_WorldBase.rotation) - rollPitchYawOf(last_.rotation);
    for (double& angle : turn) angle = std::remainder(angle, 2 * std::numbers::pi);
    const Quaternion axes =
        isSpatial_ ? X_WorldBase.rotation : fromRollPitchYaw(0, 0, rollPitchYawOf(X_WorldBase.rotation).z());
    const Vector3 way = axes.conjugate() * (X_WorldBase.position - last_.position);
    for (Eigen::Index i = 0; i < 3; ++i) {
      velocity_[static_cast<std::size_t>(i)].add(way[i] / dt);
      velocity_[static_cast<std::size_t>(i + 3)].add(turn[i] / dt);
    }
  }

  double falsified(std::size_t quantity) { return velocity_[quantity].mean() + random_->normal(0, noise_); }

  void publishOdometry(const Pose& X_WorldBase, Time time) {
    ignition::msgs::Twist& twist = *message_.mutable_twist();
    setHeader(time, *message_.mutable_header());
    setPlace(X_WorldBase, *message_.mutable_pose());
    twist.mutable_linear()->set_x(falsified(0));
    twist.mutable_linear()->set_y(falsified(1));
    if (isSpatial_) {
      twist.mutable_linear()->set_z(falsified(2));
      twist.mutable_angular()->set_x(falsified(3));
      twist.mutable_angular()->set_y(falsified(4));
    }
    twist.mutable_angular()->set_z(falsified(5));
    odometry_.publish(message_);
    if (covariance_.hasSubscribers()) publishCovariance();
  }

  /// Publishes the odometry again, with its covariance.
  void publishCovariance() {
    auto& pose = *covarianceMessage_.mutable_pose_with_covariance();
    auto& twist = *covarianceMessage_.mutable_twist_with_covariance();
    *covarianceMessage_.mutable_header() = message_.header();
    *pose.mutable_pose() = message_.pose();
    *twist.mutable_twist() = message_.twist();
    if (pose.covariance().data_size() == 0) {
      fillCovariance(*pose.mutable_covariance());
      fillCovariance(*twist.mutable_covariance());
    }
    covariance_.publish(covarianceMessage_);
  }

  /// Sets the diagonal of a 6 × 6 matrix to the variance, for the pose too, as in Fortress.
  void fillCovariance(ignition::msgs::Float_V& covariance) const {
    constexpr int kSize = 6;
    for (int row = 0; row < kSize; ++row) {
      for (int column = 0; column < kSize; ++column) {
        covariance.add_data(row == column ? static_cast<float>(noise_ * noise_) : 0.0F);
      }
    }
  }

  void publishTf(const Pose& X_WorldBase, Time time) {
    if (tfMessage_.pose_size() == 0) tfMessage_.add_pose();
    setHeader(time, *tfMessage_.mutable_pose(0)->mutable_header());
    setPlace(X_WorldBase, *tfMessage_.mutable_pose(0));
    tf_.publish(tfMessage_);
  }

  void setHeader(Time time, ignition::msgs::Header& header) const {
    setStamp(time, header);
    setHeaderValue("frame_id", frame_, header);
    setHeaderValue("child_frame_id", childFrame_, header);
  }

  void setPlace(const Pose& X_WorldBase, ignition::msgs::Pose& pose) const {
    pose.mutable_position()->set_x(X_WorldBase.position.x());
    pose.mutable_position()->set_y(X_WorldBase.position.y());
    if (isSpatial_) pose.mutable_position()->set_z(X_WorldBase.position.z());
    setRotation(X_WorldBase.rotation, *pose.mutable_orientation());
  }

  std::string frame_;
  std::string childFrame_;
  double frequency_ = 50;
  std::string odometryTopic_;
  std::string covarianceTopic_;
  std::string tfTopic_;
  int dimensions_ = 2;
  Vector3 offset_ = Vector3::Zero();
  Vector3 angles_ = Vector3::Zero();
  double noise_ = 0;

  std::optional<Model> model_;
  Pose X_ModelBase_;
  bool isSpatial_ = false;
  Random* random_ = nullptr;

  Schedule schedule_;
  Pose last_;
  /// Linear x, y, z [m/s], then roll, pitch, yaw [rad/s].
  std::array<RollingMean<10>, 6> velocity_;

  Publisher odometry_;
  Publisher covariance_;
  Publisher tf_;
  ignition::msgs::Odometry message_;
  ignition::msgs::OdometryWithCovariance covarianceMessage_;
  ignition::msgs::Pose_V tfMessage_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::OdometryPublisher, "ignition::gazebo::systems::OdometryPublisher",
                      "gz::sim::systems::OdometryPublisher");
