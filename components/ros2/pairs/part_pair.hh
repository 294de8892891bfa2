#pragma once

#include "ros2/pairs/convert.hh"
#include "ros2/pairs/frames.hh"
#include "ros2/pairs/gz_parts.hh"
#include "ros2/pairs/parameter_value.hh"

namespace pongsim::ros2 {

/// A pair of two types that convert like parts of messages, with a `convert` from the headers above.
template <class RosType, class IgnitionType>
struct PartPair {
  using Ros = RosType;
  using Ignition = IgnitionType;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) { convertPart(from, to, frames); }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) { convertPart(from, to, frames); }

 private:
  template <class From, class To>
  static void convertPart(const From& from, To& to, const Frames& frames) {
    if constexpr (requires { ros2::convert(from, to, frames); }) {
      ros2::convert(from, to, frames);
    } else {
      ros2::convert(from, to);
    }
  }
};

/// The same for commands, in which all numbers must be finite.
template <class RosType, class IgnitionType>
struct CommandPair : PartPair<RosType, IgnitionType> {
  static constexpr bool kMustBeFinite = true;
};

}  // namespace pongsim::ros2
