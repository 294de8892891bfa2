#pragma once

#include <optional>

#include "pongsim/types.hh"

namespace pongsim {

/// Colours of a visual instead of those of its file: red, green, blue, 0 to 1. What is unset stays.
struct VisualColors {
  std::optional<Vector3> diffuse = std::nullopt;
  /// Unset: like `diffuse`, if that is set.
  std::optional<Vector3> ambient = std::nullopt;
  std::optional<Vector3> specular = std::nullopt;
  std::optional<Vector3> emissive = std::nullopt;

  bool operator==(const VisualColors&) const = default;
};

}  // namespace pongsim
