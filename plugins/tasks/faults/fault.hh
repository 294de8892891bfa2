#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim::faults {

enum class Kind { kDrop, kDuplicate, kDelay, kNoise, kFreeze, kSensor, kStick, kSlip, kWeaken };

/// A fault on purpose, as a `<fault>` says.
struct Fault {
  Kind kind = Kind::kDrop;
  /// The name of a topic, a sensor or a joint.
  std::string target;
  /// When it begins, and when it ends.
  Time from{0};
  Time to = Time::max();
  /// It repeats after this time; zero: it does not.
  Time every{0};
  /// Of each message.
  double probability = 1;
  Time delay{0};
  /// Standard deviation of noise, and the field that has it; empty: all.
  double deviation = 0;
  std::string field;
  /// Factor of friction.
  double friction = 0.1;
  /// Largest force or torque [N or N m], or a factor of the joint's own.
  std::optional<double> effort;
  std::optional<double> factor;
  SourcePosition position;

  /// @return Whether it is there at a time.
  bool isActive(Time now) const;
  bool isOfTopic() const { return kind < Kind::kSensor; }
  bool isOfJoint() const { return kind > Kind::kSensor; }
};

/// @throws Error with the position of what is wrong, and the nearest word.
Fault faultOf(const Element& element);

/// @return "did you mean 'X'?", or the names that there are if there are few of
/// them; empty without any.
std::string hintFor(std::string_view word, std::span<const std::string_view> known);

}  // namespace pongsim::faults
