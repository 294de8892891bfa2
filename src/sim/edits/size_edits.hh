#pragma once

#include <cstddef>
#include <span>

#include "pongsim/outcome.hh"
#include "pongsim/state/state_archive.hh"
#include "sim/api/access.hh"

namespace pongsim::sim {

/// What takes the new size of a collision along.
struct SizeFollowers {
  /// The visuals of its link with the same shape, size and pose.
  bool visuals = true;
  /// Mass and inertia of its link, at the same density.
  bool mass = false;
};

/// Gives a collision of simple shape another size [m] (`description::sizeOf`), until a reset. A refusal changes
/// nothing.
/// @param number Index in the link.
Outcome<void> setCollisionSize(Access& access, world::Slot link, std::size_t number, std::span<const double> size,
                               const SizeFollowers& followers);
/// Likewise for a visual.
Outcome<void> setVisualSize(Access& access, world::Slot link, std::size_t number, std::span<const double> size);

/// Saves the sizes that are not those of the file, or restores them: before the engine's state, which reads the sizes.
/// @throws std::out_of_range if they are not of these links.
void transferSizes(StateArchive& archive, Access& access);

}  // namespace pongsim::sim
