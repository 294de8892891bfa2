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
  /// Whether somebody outside this program has asked for it, such as the caller of a service. Then the model, and what
  /// its systems insert, finds only files in the world's folder, in the resource folders that were set when the world
  /// was loaded, and in the Fuel cache, and its cameras save no images.
  bool isFromOutside = false;
};

}  // namespace pongsim
