#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "pongsim/export.hh"
#include "pongsim/types.hh"

namespace pongsim {

// The components of which states as messages (`Scene::fillInState`, `StateChanges`) are made up.

/// @param name Of a component of Fortress, as "Pose".
/// @return The number that stands for it.
PONGSIM_API std::uint64_t componentType(std::string_view name);

/// @param text Of a "Pose": x y z roll pitch yaw [m, rad].
/// @return Nothing where it is none.
PONGSIM_API std::optional<Pose> componentPose(std::string_view text);

}  // namespace pongsim
