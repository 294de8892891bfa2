#pragma once

#include <optional>
#include <string>

#include "pongsim/types.hh"

namespace pongsim {

/// How to insert a model into a running world.
struct InsertOptions {
  /// Replaces the name in the file; empty: keeps it.
  std::string name = {};
  /// Pose of the model frame in the world; replaces the one in the file.
  std::optional<Pose> pose = std::nullopt;
  /// If the name is taken by a model or light, use the first free one of NAME_0, NAME_1 and so on, as in Fortress,
  /// instead of refusing.
  bool allowRenaming = false;
  /// Prefix, such as "/robot1", of all topics and services of the model's systems and sensors, including absolute
  /// names. Empty: none. No effect on a light.
  std::string nameSpace = {};
};

}  // namespace pongsim
