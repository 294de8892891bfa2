#pragma once

#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "pongsim/bulk.hh"
#include "pongsim/message.hh"
#include "ros2/pairs/frames.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/finite.hh"
#include "ros2/types/message_definition.hh"
#include "ros2/types/type_info.hh"

namespace pongsim::ros2 {

/// Takes a payload's size, and has the payload written to its destination immediately.
using Sink = std::function<void(std::size_t size, const Fill& fill)>;

/// Converts messages of a topic to ROS payloads. Reuses its memory, so that a steady stream allocates nothing; for one
/// thread at a time.
class ToRos {
 public:
  virtual ~ToRos() = default;
  /// @param bulk Content of the message's bytes field if it is stored separately; else null.
  virtual void convert(const Message& from, const Bulk* bulk, const Sink& to) = 0;
};

/// Converts ROS payloads to messages; for one thread at a time.
class ToIgnition {
 public:
  virtual ~ToIgnition() = default;
  /// @return The message, valid until the next call; null, with the reason in `error`, if the payload is invalid.
  virtual const Message* convert(std::span<const std::byte> payload, std::string& error) = 0;
};

/// Two types that convert to each other.
struct Pair {
  /// "sensor_msgs/msg/LaserScan"
  std::string_view ros;
  /// "ignition.msgs.LaserScan"
  std::string ignition;
  /// Whether topics of this ignition type are bridged with this pair by default.
  bool isDefault;
  /// Whether messages of the ROS type have their own header, with a frame.
  bool hasHeader;
  TypeInfo (*type)();
  /// The ROS type's definition, in the .msg language.
  std::string (*definition)();
  std::unique_ptr<ToRos> (*toRos)(const Frames& frames);
  std::unique_ptr<ToIgnition> (*toIgnition)(const Frames& frames);
};

/// Whether topics of the ignition type use this pair by default. One of the pairs for each ignition type is the
/// default.
enum class Choice { kDefault, kOnRequest };

/// A pair is a struct with two functions, each of which overwrites all of `to`:
///
///     struct TwistPair {
///       using Ros = geometry_msgs::Twist;
///       using Ignition = ignition::msgs::Twist;
///       static constexpr bool kMustBeFinite = true;   // a command: refused if a number in it is not finite
///       static void convert(const Ignition& from, Ros& to, const Frames& frames);
///       static void convert(const Ros& from, Ignition& to, const Frames& frames);
///     };
///
/// and a line in its file's list: `pairOf<TwistPair>(Choice::kDefault)`. A pair with bulk bytes also has `RosOut`, the
/// type with `BulkBytes` in a member `data`, and converts to that instead of `Ros`; the message's field is also named
/// `data`.
template <class P>
concept HasBulk = requires { typename P::RosOut; };

namespace detail {

template <class Ros>
concept HasHeader = requires(Ros message) { message.header.frame_id; };

template <class Ros>
void setFrame(Ros& message, const Frames& frames) {
  if constexpr (HasHeader<Ros>) {
    if (!frames.frameId.empty()) message.header.frame_id = frames.frameId;
  }
}

template <class P>
struct RosTypeOf {
  using Type = typename P::Ros;
};
template <HasBulk P>
struct RosTypeOf<P> {
  using Type = typename P::RosOut;
};

template <class P>
class PairToRos final : public ToRos {
 public:
  explicit PairToRos(const Frames& frames) : frames_(frames) {}

  void convert(const Message& from, [[maybe_unused]] const Bulk* bulk, const Sink& to) override {
    const auto& message = static_cast<const typename P::Ignition&>(from);
    P::convert(message, ros_, frames_);
    setFrame(ros_, frames_);
    if constexpr (HasBulk<P>) {
      const std::string& data = message.data();
      if (bulk != nullptr) {
        ros_.data = {bulk->size, [bulk](std::span<std::byte> place) { bulk->write(place); }};
      } else {
        ros_.data = {data.size(),
                     [&data](std::span<std::byte> place) { std::memcpy(place.data(), data.data(), data.size()); }};
      }
    }
    to(cdrSize(ros_), [this](std::span<std::byte> place) { writeCdr(ros_, place); });
  }

 private:
  Frames frames_;
  typename RosTypeOf<P>::Type ros_;
};

template <class P>
class PairToIgnition final : public ToIgnition {
 public:
  explicit PairToIgnition(const Frames& frames) : frames_(frames) {}

  const Message* convert(std::span<const std::byte> payload, std::string& error) override {
    if (const auto wrong = readCdr(payload, ros_)) {
      error = *wrong;
      return nullptr;
    }
    if constexpr (requires { P::kMustBeFinite; }) {
      if (!isFinite(ros_)) {
        error = "a number in it is not finite";
        return nullptr;
      }
    }
    P::convert(ros_, message_, frames_);
    return &message_;
  }

 private:
  Frames frames_;
  typename P::Ros ros_;
  typename P::Ignition message_;
};

template <class P>
std::unique_ptr<ToRos> toRosOf(const Frames& frames) {
  return std::make_unique<PairToRos<P>>(frames);
}
template <class P>
std::unique_ptr<ToIgnition> toIgnitionOf(const Frames& frames) {
  return std::make_unique<PairToIgnition<P>>(frames);
}

}  // namespace detail

template <class P>
Pair pairOf(Choice choice) {
  return {P::Ros::kName,
          P::Ignition::descriptor()->full_name(),
          choice == Choice::kDefault,
          detail::HasHeader<typename P::Ros>,
          typeInfo<typename P::Ros>,
          messageDefinition<typename P::Ros>,
          detail::toRosOf<P>,
          detail::toIgnitionOf<P>};
}

}  // namespace pongsim::ros2
