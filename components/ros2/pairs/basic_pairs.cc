// builtin_interfaces, rcl_interfaces, rosgraph_msgs, std_msgs
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/float.pb.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/uint32.pb.h>

#include "ros2/pairs/pairs.hh"
#include "ros2/pairs/part_pair.hh"
#include "ros2/types/rosgraph_msgs.hh"

namespace pongsim::ros2 {

namespace {

/// Converts between two types with a field `data`. A number must be finite, because on its own topic it is a command.
template <class RosType, class IgnitionType>
struct DataPair {
  using Ros = RosType;
  using Ignition = IgnitionType;
  static constexpr bool kMustBeFinite = true;
  static void convert(const Ignition& from, Ros& to, const Frames&) { to.data = from.data(); }
  static void convert(const Ros& from, Ignition& to, const Frames&) { to.set_data(from.data); }
};

struct EmptyPair {
  using Ros = std_msgs::Empty;
  using Ignition = ignition::msgs::Empty;
  static void convert(const Ignition&, Ros&, const Frames&) {}
  static void convert(const Ros&, Ignition&, const Frames&) {}
};

struct ClockPair {
  using Ros = rosgraph_msgs::Clock;
  using Ignition = ignition::msgs::Clock;
  static void convert(const Ignition& from, Ros& to, const Frames&) { ros2::convert(from.sim(), to.clock); }
  static void convert(const Ros& from, Ignition& to, const Frames&) { ros2::convert(from.clock, *to.mutable_sim()); }
};

}  // namespace

std::vector<Pair> basicPairs() {
  return {pairOf<PartPair<builtin_interfaces::Time, ignition::msgs::Time>>(Choice::kDefault),
          pairOf<ClockPair>(Choice::kDefault),
          pairOf<DataPair<std_msgs::Bool, ignition::msgs::Boolean>>(Choice::kDefault),
          pairOf<PartPair<std_msgs::ColorRGBA, ignition::msgs::Color>>(Choice::kDefault),
          pairOf<EmptyPair>(Choice::kDefault),
          pairOf<DataPair<std_msgs::Float32, ignition::msgs::Float>>(Choice::kDefault),
          pairOf<DataPair<std_msgs::Float64, ignition::msgs::Double>>(Choice::kDefault),
          pairOf<PartPair<std_msgs::Header, ignition::msgs::Header>>(Choice::kDefault),
          pairOf<DataPair<std_msgs::Int32, ignition::msgs::Int32>>(Choice::kDefault),
          pairOf<DataPair<std_msgs::UInt32, ignition::msgs::UInt32>>(Choice::kDefault),
          pairOf<DataPair<std_msgs::String, ignition::msgs::StringMsg>>(Choice::kDefault),
          pairOf<PartPair<rcl_interfaces::ParameterValue, ignition::msgs::Any>>(Choice::kDefault)};
}

}  // namespace pongsim::ros2
