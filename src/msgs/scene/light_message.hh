#pragma once

#include <cstdint>
#include <string>

#include "description/light.hh"
#include "pongsim/message.hh"

namespace ignition::msgs {
class Light;
}

namespace pongsim::msgs {

/// Fills in a light as Fortress does, but for its id and that of what holds it.
void setLight(const description::Light& light, ignition::msgs::Light& message);

/// @return The light that a message tells of.
description::Light lightFrom(const ignition::msgs::Light& message);

/// Tells in the header that a light is off, as Fortress does where its messages have no field for something.
void setWhetherOn(bool isOn, ignition::msgs::Light& message);
/// @return What `setWhetherOn` has told; lights of which nothing is told are on.
bool isOn(const ignition::msgs::Light& message);

/// Which light an `ignition.msgs.Light` means.
struct LightName {
  /// 0: it is named by its name.
  std::uint64_t id = 0;
  std::string name;
  /// Id of the link that holds it; 0: the world.
  std::uint64_t parent = 0;
};

/// @param light An `ignition.msgs.Light`.
LightName lightName(const Message& light);

/// @param light An `ignition.msgs.Light`.
/// @return What becomes of `before`: colours, direction and position that the message has not stay, as the rotation
/// always does; single values that it leaves out become 0 or false, for it can't tell the one from the other. A light of
/// which nothing is told (`setWhetherOn`) is on. The name stays.
description::Light changedLight(const description::Light& before, const Message& light);

}  // namespace pongsim::msgs
