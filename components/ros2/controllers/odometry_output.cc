#include "ros2/controllers/odometry_output.hh"

#include "pongsim/math.hh"
#include "pongsim/messages/fields.hh"
#include "ros2/robot/stamps.hh"

namespace pongsim::ros2 {

namespace {

constexpr const char* kTransformTopic = "/tf";

/// @return "robot/" for the prefix "/robot" or "robot".
std::string framePrefix(ControllerParameters& parameters, const std::string& nameSpace) {
  if (!parameters.flag("tf_frame_prefix_enable", true)) return {};
  std::string prefix = parameters.text("tf_frame_prefix", "");
  if (prefix.empty()) prefix = nameSpace;
  if (!prefix.ends_with('/')) prefix += '/';
  if (prefix.starts_with('/')) prefix.erase(0, 1);
  return prefix;
}

geometry_msgs::Quaternion headingOf(const WheelOdometry& odometry) {
  const auto [sine, cosine] = math::sinCos(odometry.heading() / 2);
  return {0, 0, sine, cosine};
}

}  // namespace

void OdometryOutput::configure(const ControllerSetup& setup, const Defaults& defaults) {
  ControllerParameters& parameters = setup.parameters;
  frames_ = setup.frames;
  const std::string prefix = defaults.hasPrefix ? framePrefix(parameters, setup.ros.options().nameSpace) : "";
  const std::string odom = prefix + parameters.text("odom_frame_id", "odom");
  const std::string base = prefix + parameters.text("base_frame_id", "base_link");
  const auto pose = parameters.numbers("pose_covariance_diagonal", defaults.covariance, 6);
  const auto twist = parameters.numbers("twist_covariance_diagonal", defaults.covariance, 6);
  message_.header.frame_id = frames_.toRos(odom);
  message_.child_frame_id = frames_.toRos(base);
  for (std::size_t i = 0; i < 6; ++i) {
    message_.pose.covariance[7 * i] = pose[i];
    message_.twist.covariance[7 * i] = twist[i];
  }
  odometry_ = setup.advertise<nav_msgs::Odometry>(defaults.odometryTopic);
  if (!parameters.flag("enable_odom_tf", defaults.tellsTransform)) return;
  if (setup.tellsTransforms && setup.remaps.apply(setup.ros, defaults.transformTopic) == kTransformTopic) {
    passedOn_ = setup.simulation.advertise<ignition::msgs::Pose_V>(
        cleanTopic("/model/" + std::string(setup.model.name()) + "/tf"));
    auto& header = *passedMessage_.add_pose()->mutable_header();
    setHeaderValue("frame_id", odom, header);
    setHeaderValue("child_frame_id", base, header);
  } else {
    transform_ = setup.advertise<tf2_msgs::TFMessage>(defaults.transformTopic, {.depth = 100});
    auto& transform = transformMessage_.transforms.emplace_back();
    transform.header.frame_id = message_.header.frame_id;
    transform.child_frame_id = message_.child_frame_id;
  }
}

void OdometryOutput::publish(const WheelOdometry& odometry, Time now, bool withPose) {
  if (odometry_->hasReaders()) {
    message_.header.stamp = stampOf(now, frames_);
    if (withPose) {
      message_.pose.pose.position = {odometry.x(), odometry.y(), 0};
      message_.pose.pose.orientation = headingOf(odometry);
    }
    message_.twist.twist.linear = {odometry.linear(), odometry.lateral(), 0};
    message_.twist.twist.angular = {0, 0, odometry.angular()};
    odometry_->publish(message_);
  }
  publishTransform(odometry, now);
}

void OdometryOutput::publishTransform(const WheelOdometry& odometry, Time now) {
  const geometry_msgs::Quaternion heading = headingOf(odometry);
  if (transform_ && transform_->hasReaders()) {
    auto& transform = transformMessage_.transforms[0];
    transform.header.stamp = stampOf(now, frames_);
    transform.transform.translation = {odometry.x(), odometry.y(), 0};
    transform.transform.rotation = heading;
    transform_->publish(transformMessage_);
  }
  if (passedOn_ && passedOn_.hasSubscribers()) {
    auto& pose = *passedMessage_.mutable_pose(0);
    setStamp(now, *pose.mutable_header());
    pose.mutable_position()->set_x(odometry.x());
    pose.mutable_position()->set_y(odometry.y());
    pose.mutable_orientation()->set_z(heading.z);
    pose.mutable_orientation()->set_w(heading.w);
    passedOn_.publish(passedMessage_);
  }
}

}  // namespace pongsim::ros2
