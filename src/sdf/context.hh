#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "pongsim/diagnostic.hh"
#include "pongsim/files/urdf_source.hh"

namespace pongsim::sdf {

class Includes;

/// Shared by the readers of a file.
struct Context {
  /// Errors and warnings about the files.
  Diagnostics& diagnostics;
  /// Valid content that pongsim does not simulate.
  Diagnostics& unsimulated;
  /// Reads included files.
  Includes& includes;
  /// The file is in SDF 1.`version`.
  int version = 9;
  /// The file's folder.
  std::filesystem::path folder = {};
  /// Source of the file's own model, not of nested ones, if it is URDF.
  std::shared_ptr<const UrdfSource> urdf = nullptr;
  /// Whether the parent is a world or the root, not a model.
  bool isInWorld = false;
  /// Subjects of the warnings given so far that are given once per file.
  std::set<std::string> said = {};
  /// How many more times a name similar to an unknown one is looked for, which is slow.
  int searchesLeft = 50;

  /// @return Whether this is the first time for `subject`.
  bool firstTime(std::string subject) { return said.insert(std::move(subject)).second; }
};

}  // namespace pongsim::sdf
