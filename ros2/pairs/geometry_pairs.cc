// geometry_msgs
#include <ignition/msgs/twist.pb.h>

#include "ros2/pairs/convert.hh"
#include "ros2/pairs/pairs.hh"

namespace pongsim::ros2 {

namespace {

struct TwistPair {
  using Ros = geometry_msgs::Twist;
  using Ignition = ignition::msgs::Twist;
  static constexpr bool kMustBeFinite = true;
  static void convert(const Ignition& from, Ros& to, const Frames&) {
    ros2::convert(from.linear(), to.linear);
    ros2::convert(from.angular(), to.angular);
  }
  static void convert(const Ros& from, Ignition& to, const Frames&) {
    ros2::convert(from.linear, *to.mutable_linear());
    ros2::convert(from.angular, *to.mutable_angular());
  }
};

}  // namespace

std::vector<Pair> geometryPairs() { return {pairOf<TwistPair>(Choice::kDefault)}; }

}  // namespace pongsim::ros2
