#pragma once

#include <ignition/msgs/pose_v.pb.h>

#include <memory>
#include <string>
#include <vector>

#include "pongsim/parameters.hh"
#include "ros2/controllers/controller.hh"
#include "ros2/controllers/wheel_odometry.hh"
#include "ros2/types/nav_msgs.hh"
#include "ros2/types/tf2_msgs.hh"

namespace pongsim::ros2 {

/// Publishes the odometry of a drive, with the parameters that the drives of ros2_controllers have in common:
/// `odom_frame_id`, `base_frame_id`, `pose_covariance_diagonal`, `twist_covariance_diagonal`, `enable_odom_tf`.
///
/// The transform goes to /tf. Where the simulation publishes the robot's frames there, it passes on this one, so that
/// each frame has one parent.
class OdometryOutput {
 public:
  struct Defaults {
    /// "~/odom"
    std::string odometryTopic;
    /// "/tf", or "~/tf_odometry", which users give the name /tf.
    std::string transformTopic;
    std::vector<double> covariance = std::vector<double>(6, 0.0);
    bool tellsTransform = true;
    /// Whether there are `tf_frame_prefix_enable` and `tf_frame_prefix`.
    bool hasPrefix = false;
  };

  void configure(const ControllerSetup& setup, const Defaults& defaults);
  /// @param withPose Whether the odometry's pose is given.
  void publish(const WheelOdometry& odometry, Time now, bool withPose = true);

 private:
  void publishTransform(const WheelOdometry& odometry, Time now);

  Frames frames_;
  std::unique_ptr<RosPublisher> odometry_;
  std::unique_ptr<RosPublisher> transform_;
  Publisher passedOn_;
  nav_msgs::Odometry message_;
  tf2_msgs::TFMessage transformMessage_;
  ignition::msgs::Pose_V passedMessage_;
};

}  // namespace pongsim::ros2
