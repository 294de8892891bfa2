// builtin_interfaces, rosgraph_msgs, std_msgs
#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include "ros2/pairs/convert.hh"
#include "ros2/pairs/pairs.hh"
#include "ros2/types/rosgraph_msgs.hh"

namespace pongsim::ros2 {

namespace {

struct ClockPair {
  using Ros = rosgraph_msgs::Clock;
  using Ignition = ignition::msgs::Clock;
  static void convert(const Ignition& from, Ros& to, const Frames&) { ros2::convert(from.sim(), to.clock); }
  static void convert(const Ros& from, Ignition& to, const Frames&) { ros2::convert(from.clock, *to.mutable_sim()); }
};

struct StringPair {
  using Ros = std_msgs::String;
  using Ignition = ignition::msgs::StringMsg;
  static void convert(const Ignition& from, Ros& to, const Frames&) { to.data = from.data(); }
  static void convert(const Ros& from, Ignition& to, const Frames&) { to.set_data(from.data); }
};

struct EmptyPair {
  using Ros = std_msgs::Empty;
  using Ignition = ignition::msgs::Empty;
  static void convert(const Ignition&, Ros&, const Frames&) {}
  static void convert(const Ros&, Ignition&, const Frames&) {}
};

}  // namespace

std::vector<Pair> basicPairs() {
  return {pairOf<ClockPair>(Choice::kDefault), pairOf<StringPair>(Choice::kDefault),
          pairOf<EmptyPair>(Choice::kDefault)};
}

}  // namespace pongsim::ros2
