// actuator_msgs, nav_msgs, tf2_msgs, trajectory_msgs, and the joint states of sensor_msgs
#include <ignition/msgs/actuators.pb.h>
#include <ignition/msgs/joint_trajectory.pb.h>
#include <ignition/msgs/model.pb.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/odometry_with_covariance.pb.h>
#include <ignition/msgs/pose_v.pb.h>

#include <limits>

#include "ros2/pairs/convert.hh"
#include "ros2/pairs/covariance.hh"
#include "ros2/pairs/pairs.hh"
#include "ros2/types/actuator_msgs.hh"
#include "ros2/types/nav_msgs.hh"
#include "ros2/types/sensor_msgs.hh"
#include "ros2/types/tf2_msgs.hh"
#include "ros2/types/trajectory_msgs.hh"

namespace pongsim::ros2 {

namespace {

struct OdometryPair {
  using Ros = nav_msgs::Odometry;
  using Ignition = ignition::msgs::Odometry;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    childFrame(from.header(), to.child_frame_id, frames);
    ros2::convert(from.pose(), to.pose.pose);
    ros2::convert(from.twist(), to.twist.twist);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    addChildFrame(from.child_frame_id, *to.mutable_header(), frames);
    ros2::convert(from.pose.pose, *to.mutable_pose());
    ros2::convert(from.twist.twist, *to.mutable_twist());
  }
};

struct OdometryWithCovariancePair {
  using Ros = nav_msgs::Odometry;
  using Ignition = ignition::msgs::OdometryWithCovariance;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    childFrame(from.header(), to.child_frame_id, frames);
    ros2::convert(from.pose_with_covariance(), to.pose);
    ros2::convert(from.twist_with_covariance(), to.twist);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    addChildFrame(from.child_frame_id, *to.mutable_header(), frames);
    ros2::convert(from.pose, *to.mutable_pose_with_covariance());
    ros2::convert(from.twist, *to.mutable_twist_with_covariance());
  }
};

struct TransformsPair {
  using Ros = tf2_msgs::TFMessage;
  using Ignition = ignition::msgs::Pose_V;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    to.transforms.resize(static_cast<std::size_t>(from.pose_size()));
    for (int i = 0; i < from.pose_size(); ++i) {
      const ignition::msgs::Pose& pose = from.pose(i);
      geometry_msgs::TransformStamped& transform = to.transforms[static_cast<std::size_t>(i)];
      ros2::convert(pose, transform, frames);
      // poses of a world are identified by names and have no headers; ros_gz leaves both empty
      if (!pose.header().has_stamp()) ros2::convert(from.header().stamp(), transform.header.stamp);
      if (transform.child_frame_id.empty()) frames.toRos(pose.name(), transform.child_frame_id);
    }
  }
  // the message has the header of the first transform, as in ros_gz
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    to.Clear();
    for (const geometry_msgs::TransformStamped& transform : from.transforms) {
      ros2::convert(transform, *to.add_pose(), frames);
    }
    if (!from.transforms.empty()) {
      ros2::convert(from.transforms.front().header, *to.mutable_header(), frames);
    }
  }
};

struct JointTrajectoryPair {
  using Ros = trajectory_msgs::JointTrajectory;
  using Ignition = ignition::msgs::JointTrajectory;
  static constexpr bool kMustBeFinite = true;

  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.joint_names.assign(from.joint_names().begin(), from.joint_names().end());
    to.points.resize(static_cast<std::size_t>(from.points_size()));
    for (int i = 0; i < from.points_size(); ++i) convertPoint(from.points(i), to.points[static_cast<std::size_t>(i)]);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    to.Clear();
    ros2::convert(from.header, *to.mutable_header(), frames);
    for (const std::string& name : from.joint_names) to.add_joint_names(name);
    for (const trajectory_msgs::JointTrajectoryPoint& point : from.points) convertPoint(point, *to.add_points());
  }

 private:
  static void convertPoint(const ignition::msgs::JointTrajectoryPoint& from,
                           trajectory_msgs::JointTrajectoryPoint& to) {
    copyNumbers(from.positions(), to.positions);
    copyNumbers(from.velocities(), to.velocities);
    copyNumbers(from.accelerations(), to.accelerations);
    copyNumbers(from.effort(), to.effort);
    to.time_from_start.sec = static_cast<std::int32_t>(from.time_from_start().sec());
    to.time_from_start.nanosec = static_cast<std::uint32_t>(from.time_from_start().nsec());
  }
  static void convertPoint(const trajectory_msgs::JointTrajectoryPoint& from,
                           ignition::msgs::JointTrajectoryPoint& to) {
    addNumbers(from.positions, to.mutable_positions());
    addNumbers(from.velocities, to.mutable_velocities());
    addNumbers(from.accelerations, to.mutable_accelerations());
    addNumbers(from.effort, to.mutable_effort());
    to.mutable_time_from_start()->set_sec(from.time_from_start.sec);
    to.mutable_time_from_start()->set_nsec(static_cast<std::int32_t>(from.time_from_start.nanosec));
  }
};

struct ActuatorsPair {
  using Ros = actuator_msgs::Actuators;
  using Ignition = ignition::msgs::Actuators;
  static constexpr bool kMustBeFinite = true;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    copyNumbers(from.position(), to.position);
    copyNumbers(from.velocity(), to.velocity);
    copyNumbers(from.normalized(), to.normalized);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    to.Clear();
    ros2::convert(from.header, *to.mutable_header(), frames);
    addNumbers(from.position, to.mutable_position());
    addNumbers(from.velocity, to.mutable_velocity());
    addNumbers(from.normalized, to.mutable_normalized());
  }
};

/// The joints with an axis, with the values of the first one.
struct JointStatePair {
  using Ros = sensor_msgs::JointState;
  using Ignition = ignition::msgs::Model;
  static constexpr bool kMustBeFinite = true;

  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    std::size_t count = 0;
    for (const auto& joint : from.joint()) count += joint.has_axis1() ? 1 : 0;
    to.name.resize(count);
    to.position.resize(count);
    to.velocity.resize(count);
    to.effort.resize(count);
    std::size_t i = 0;
    for (const auto& joint : from.joint()) {
      if (!joint.has_axis1()) continue;
      to.name[i] = joint.name();
      to.position[i] = joint.axis1().position();
      to.velocity[i] = joint.axis1().velocity();
      to.effort[i] = joint.axis1().force();
      ++i;
    }
  }
  // Each of the three lists may be missing, or shorter than that of the names. Missing values become NaN, because the
  // zeros of a Fortress message would be commands.
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    to.Clear();
    ros2::convert(from.header, *to.mutable_header(), frames);
    for (std::size_t i = 0; i < from.name.size(); ++i) {
      auto* joint = to.add_joint();
      joint->set_name(from.name[i]);
      auto* axis = joint->mutable_axis1();
      constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
      axis->set_position(i < from.position.size() ? from.position[i] : kNothing);
      axis->set_velocity(i < from.velocity.size() ? from.velocity[i] : kNothing);
      axis->set_force(i < from.effort.size() ? from.effort[i] : kNothing);
    }
  }
};

}  // namespace

std::vector<Pair> motionPairs() {
  return {pairOf<OdometryPair>(Choice::kDefault),   pairOf<OdometryWithCovariancePair>(Choice::kDefault),
          pairOf<TransformsPair>(Choice::kDefault), pairOf<JointTrajectoryPair>(Choice::kDefault),
          pairOf<ActuatorsPair>(Choice::kDefault),  pairOf<JointStatePair>(Choice::kDefault)};
}

}  // namespace pongsim::ros2
