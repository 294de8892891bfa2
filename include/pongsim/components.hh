#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "pongsim/export.hh"
#include "pongsim/types.hh"

namespace pongsim {

// Components of the state messages made by `Scene::fillInState` and `StateChanges`.

/// @param name A component's name in Fortress, such as "Pose".
/// @return Its type number.
PONGSIM_API std::uint64_t componentType(std::string_view name);

/// @param text Of a "Pose" component: x y z roll pitch yaw [m, rad].
/// @return Nothing if the text is not a pose.
PONGSIM_API std::optional<Pose> componentPose(std::string_view text);

}  // namespace pongsim
