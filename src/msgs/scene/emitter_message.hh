#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "description/particle_emitter.hh"
#include "pongsim/message.hh"

namespace pongsim::msgs {

/// Fills in an `ignition.msgs.ParticleEmitter` as Fortress does. Images are given by full path.
void setEmitter(const description::ParticleEmitter& emitter, std::uint64_t id, Message& message);

/// @param message An `ignition.msgs.ParticleEmitter`.
/// @return Whether it begins the duration again, as it does in Fortress if it sets that, or switches the emitter.
bool beginsEmission(const Message& message);

/// @param message An `ignition.msgs.ParticleEmitter`.
/// @return `before` with what the message sets, except name and pose. Its type is POINT where it sets none, which
/// changes nothing, as in Fortress. Images are not looked for: only those that `before` has are known.
description::ParticleEmitter changedEmitter(const description::ParticleEmitter& before, const Message& message);

/// @param changes Bytes of an `ignition.msgs.ParticleEmitter`: earlier changes. What `message` sets is set in them.
void mergeEmitter(const Message& message, std::string& changes);

/// @param changes From `mergeEmitter`.
/// @return `before` with them; nothing if they are no message.
std::optional<description::ParticleEmitter> emitterAfter(const description::ParticleEmitter& before,
                                                         const std::string& changes);

}  // namespace pongsim::msgs
