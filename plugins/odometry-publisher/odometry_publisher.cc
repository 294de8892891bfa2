#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/pose_v.pb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "pongsim/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/rolling_mean.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Roll, pitch and yaw [rad] of R = Rz(yaw) Ry(pitch) Rx(roll).
Vector3 anglesOf(const Quaternion& rotation) {
  const Matrix3 R = rotation.toRotationMatrix();
  return {std::atan2(R(2, 1), R(2, 2)), std::asin(std::clamp(-R(2, 0), -1.0, 1.0)), std::atan2(R(1, 0), R(0, 0))};
}

/// Publishes where a model is and how fast, as the simulation knows it.
class OdometryPublisher : public System {
 public:
  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    model_ = requiredModel(context, "OdometryPublisher");
    random_ = &context.random;
    readGeometry(sdf);
    noise_ = sdf.get("gaussian_noise", 0.0);
    if (!(noise_ >= 0) || !std::isfinite(noise_)) {
      refuse(*sdf.child("gaussian_noise"), "<gaussian_noise> must be a deviation from zero up");
    }
    schedule_ = Schedule(periodParameter(sdf, "odom_publish_frequency", 50));

    const std::string name(model_->name());
    frame_ = sdf.get<std::string>("odom_frame", name + "/odom");
    childFrame_ = sdf.get<std::string>("robot_base_frame", name + "/base_footprint");
    const std::string prefix = "/model/" + name;
    odometry_ =
        context.node.advertise<ignition::msgs::Odometry>(topicParameter(sdf, "odom_topic", prefix + "/odometry"));
    tf_ = context.node.advertise<ignition::msgs::Pose_V>(topicParameter(sdf, "tf_topic", prefix + "/pose"));
    last_ = basePose();
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const Pose X_WorldBase = basePose();
    addVelocity(X_WorldBase, toSeconds(info.dt));
    last_ = X_WorldBase;
    if (!schedule_.isDue(info.time)) return;
    if (odometry_.hasSubscribers()) publishOdometry(X_WorldBase, info.time);
    if (tf_.hasSubscribers()) publishTf(X_WorldBase, info.time);
  }

  void reset() override {
    schedule_.reset();
    last_ = basePose();
    velocity_ = {};
  }

 private:
  void readGeometry(const Element& sdf) {
    const int dimensions = sdf.get("dimensions", 2);
    if (dimensions != 2 && dimensions != 3) refuse(*sdf.child("dimensions"), "<dimensions> must be 2 or 3");
    isSpatial_ = dimensions == 3;
    const Vector3 angles = sdf.get("rpy_offset", Vector3(0, 0, 0));
    X_ModelBase_ = {sdf.get("xyz_offset", Vector3(0, 0, 0)), fromRollPitchYaw(angles.x(), angles.y(), angles.z())};
    if (!X_ModelBase_.position.allFinite() || !angles.allFinite()) refuse(sdf, "the offset must be finite");
  }

  Pose basePose() const { return model_->pose() * X_ModelBase_; }

  /// The change of pose in a step, in the axes of the base, as Fortress takes it.
  void addVelocity(const Pose& X_WorldBase, double dt) {
    Vector3 turn = anglesOf(X_WorldBase.rotation) - anglesOf(last_.rotation);
    for (double& angle : turn) angle = std::remainder(angle, 2 * std::numbers::pi);
    const Quaternion axes =
        isSpatial_ ? X_WorldBase.rotation : fromRollPitchYaw(0, 0, anglesOf(X_WorldBase.rotation).z());
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

  std::optional<Model> model_;
  Pose X_ModelBase_;
  bool isSpatial_ = false;
  double noise_ = 0;
  Random* random_ = nullptr;
  std::string frame_;
  std::string childFrame_;

  Schedule schedule_;
  Pose last_;
  /// Linear x, y, z [m/s], then roll, pitch, yaw [rad/s].
  std::array<RollingMean<10>, 6> velocity_;

  Publisher odometry_;
  Publisher tf_;
  ignition::msgs::Odometry message_;
  ignition::msgs::Pose_V tfMessage_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::OdometryPublisher, "ignition::gazebo::systems::OdometryPublisher",
                      "gz::sim::systems::OdometryPublisher");
