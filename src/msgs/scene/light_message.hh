#pragma once

#include <cstdint>
#include <string>

#include "description/light.hh"
#include "pongsim/message.hh"

namespace ignition::msgs {
class Light;
}

namespace pongsim::msgs {

/// Fills in a light as Fortress does, except for its id and its parent's.
void setLight(const description::Light& light, ignition::msgs::Light& message);

/// @return The light in a message.
description::Light lightFrom(const ignition::msgs::Light& message);

/// Stores in the header whether a light is on, as Fortress does for values without a field.
void setWhetherOn(bool isOn, ignition::msgs::Light& message);
/// @return The value stored by `setWhetherOn`; without one a light is on.
bool isOn(const ignition::msgs::Light& message);

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
/// stores them. Without a value from `setWhetherOn`, the light is on.
description::Light changedLight(const description::Light& before, const Message& light);

}  // namespace pongsim::msgs
