#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "pongsim/types.hh"

namespace pongsim {

/// A visual, as cameras tell it from others.
struct SeenVisual {
  /// Name of the top-level model or of the actor with it.
  std::string owner;
  /// From the system `label` in the visual, else in the nearest model around it or in its actor.
  std::optional<std::uint8_t> label;
};

/// A box that may be turned.
struct TurnedBox {
  /// Of its centre.
  Pose pose;
  /// Side lengths [m].
  Vector3 size = Vector3::Zero();
};

}  // namespace pongsim
