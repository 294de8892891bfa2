// geometry_msgs
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/pose_with_covariance.pb.h>
#include <ignition/msgs/twist_with_covariance.pb.h>

#include "ros2/pairs/covariance.hh"
#include "ros2/pairs/pairs.hh"
#include "ros2/pairs/part_pair.hh"

namespace pongsim::ros2 {

namespace {

struct PoseArrayPair {
  using Ros = geometry_msgs::PoseArray;
  using Ignition = ignition::msgs::Pose_V;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.poses.resize(static_cast<std::size_t>(from.pose_size()));
    for (int i = 0; i < from.pose_size(); ++i) ros2::convert(from.pose(i), to.poses[static_cast<std::size_t>(i)]);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.clear_pose();
    for (const geometry_msgs::Pose& pose : from.poses) ros2::convert(pose, *to.add_pose());
  }
};

struct PoseStampedPair {
  using Ros = geometry_msgs::PoseStamped;
  using Ignition = ignition::msgs::Pose;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    ros2::convert(from, to.pose);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    ros2::convert(from.pose, to);
  }
};

struct TwistStampedPair {
  using Ros = geometry_msgs::TwistStamped;
  using Ignition = ignition::msgs::Twist;
  static constexpr bool kMustBeFinite = true;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    ros2::convert(from, to.twist);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    ros2::convert(from.twist, to);
  }
};

struct TwistWithCovarianceStampedPair {
  using Ros = geometry_msgs::TwistWithCovarianceStamped;
  using Ignition = ignition::msgs::TwistWithCovariance;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.twist().header(), to.header, frames);
    ros2::convert(from, to.twist);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_twist()->mutable_header(), frames);
    ros2::convert(from.twist, to);
  }
};

struct WrenchStampedPair {
  using Ros = geometry_msgs::WrenchStamped;
  using Ignition = ignition::msgs::Wrench;
  static constexpr bool kMustBeFinite = true;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    ros2::convert(from, to.wrench);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    ros2::convert(from.wrench, to);
  }
};

}  // namespace

std::vector<Pair> geometryPairs() {
  using namespace geometry_msgs;
  namespace ign = ignition::msgs;
  return {pairOf<PartPair<Vector3, ign::Vector3d>>(Choice::kDefault),
          pairOf<PartPair<Point, ign::Vector3d>>(Choice::kOnRequest),
          pairOf<PartPair<Quaternion, ign::Quaternion>>(Choice::kDefault),
          pairOf<PoseStampedPair>(Choice::kDefault),
          pairOf<PartPair<geometry_msgs::Pose, ign::Pose>>(Choice::kOnRequest),
          pairOf<PartPair<Transform, ign::Pose>>(Choice::kOnRequest),
          pairOf<PartPair<TransformStamped, ign::Pose>>(Choice::kOnRequest),
          pairOf<PoseArrayPair>(Choice::kOnRequest),
          pairOf<PartPair<PoseWithCovariance, ign::PoseWithCovariance>>(Choice::kDefault),
          pairOf<CommandPair<geometry_msgs::Twist, ign::Twist>>(Choice::kDefault),
          pairOf<TwistStampedPair>(Choice::kOnRequest),
          pairOf<TwistWithCovarianceStampedPair>(Choice::kDefault),
          pairOf<PartPair<TwistWithCovariance, ign::TwistWithCovariance>>(Choice::kOnRequest),
          pairOf<WrenchStampedPair>(Choice::kDefault),
          pairOf<CommandPair<geometry_msgs::Wrench, ign::Wrench>>(Choice::kOnRequest)};
}

}  // namespace pongsim::ros2
