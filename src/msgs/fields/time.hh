#pragma once

#include <ignition/msgs/time.pb.h>

#include <chrono>
#include <cstdint>

#include "msgs/fields/stamp.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

inline Time timeOf(const ignition::msgs::Time& message) { return timeOf(message.sec(), message.nsec()); }

inline void setTime(Time time, ignition::msgs::Time& message) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  message.set_sec(seconds.count());
  message.set_nsec(static_cast<std::int32_t>((time - seconds).count()));
}

}  // namespace pongsim::msgs
