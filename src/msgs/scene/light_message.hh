#pragma once

#include <cstdint>
#include <string>

#include "description/light.hh"
#include "pongsim/message.hh"

namespace ignition::msgs {
class Light;
}

namespace pongsim::msgs {

/// Fills in a light as Fortress does, except for its id and its parent's. That it is off is stored in the header, as
/// Fortress does with values that have no field.
void setLight(const description::Light& light, ignition::msgs::Light& message);

/// @return The light in a message.
description::Light lightFrom(const ignition::msgs::Light& message);

/// The light that an `ignition.msgs.Light` refers to.
struct LightName {
  /// 0: identified by its name.
  std::uint64_t id = 0;
  std::string name;
  /// Id of the parent link; 0: the world.
  std::uint64_t parent = 0;
};

/// @param light An `ignition.msgs.Light`.
LightName lightName(const Message& light);

/// @param light An `ignition.msgs.Light`.
/// @return `before` with the message's changes. Colours, direction and position that the message lacks stay unchanged,
/// and so do the rotation and the name. Scalars that it leaves out become 0 or false, because that is how the format
/// stores them. Unless its header says that it is off, the light is on.
description::Light changedLight(const description::Light& before, const Message& light);

}  // namespace pongsim::msgs
