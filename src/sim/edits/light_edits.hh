#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "description/light.hh"
#include "pongsim/message.hh"
#include "pongsim/outcome.hh"
#include "pongsim/simulation.hh"
#include "sim/api/access.hh"

namespace pongsim::sim {

// Changes of lights, between two steps. A refused change has no effect.

/// Adds a light to the world.
/// @param light Its pose is in the world.
/// @param options Their name and pose take precedence over the light's.
/// @return Its name, or why it was refused.
Outcome<std::string> insertLight(Access& access, description::Light light, const InsertOptions& options);
/// Adds the light of an `ignition.msgs.Light`.
Outcome<std::string> insertLight(Access& access, const Message& light, const InsertOptions& options);

/// Changes the light that the message identifies; see `msgs::changedLight`.
Outcome<void> changeLight(Access& access, const Message& light);

/// Removes a light of the world.
/// @param id 0: use the name.
Outcome<void> removeLight(Access& access, std::uint64_t id, const std::string& name);

}  // namespace pongsim::sim
