#pragma once

#include <optional>
#include <string>

#include "pongsim/types.hh"

namespace pongsim {

/// How a model comes into a world that runs.
struct InsertOptions {
  /// In place of the name that the file gives it; empty: that one.
  std::string name = {};
  /// Pose of the model frame in the world, in place of the one in the file.
  std::optional<Pose> pose = std::nullopt;
  /// Where a model or a light has the name already, take the first of NAME_0, NAME_1 and so on that is free, as in
  /// Fortress, in place of refusing.
  bool allowRenaming = false;
  /// "/robot1": in front of all names of topics and services that the model's systems and sensors have, of those that
  /// begin with a slash too. Empty: none. Of no meaning for a light.
  std::string nameSpace = {};
};

}  // namespace pongsim
