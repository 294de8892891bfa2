#pragma once

#include <ignition/msgs/time.pb.h>

#include "msgs/fields/stamp.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

inline Time timeOf(const ignition::msgs::Time& message) { return timeOf(message.sec(), message.nsec()); }

using pongsim::setTime;

}  // namespace pongsim::msgs
