#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "pongsim/diagnostic.hh"
#include "pongsim/urdf_source.hh"

namespace pongsim::sdf {

class Includes;

/// What the readers of one file share.
struct Context {
  /// What is wrong with the files.
  Diagnostics& diagnostics;
  /// What they say well, and nothing here simulates.
  Diagnostics& unsimulated;
  /// Opens the files that this one includes.
  Includes& includes;
  /// The file is written in SDF 1.`version`.
  int version = 9;
  /// The file's folder.
  std::filesystem::path folder = {};
  /// What the file is, where it is URDF: its model, not one within that, was made from it.
  std::shared_ptr<const UrdfSource> urdf = nullptr;
  /// What is read stands in a world or at the root, not in a model.
  bool isInWorld = false;
  /// Subjects of warnings that are given once a file.
  std::set<std::string> said = {};
  /// How many more unknown names are worth a search for one that is spelt alike, which takes its time.
  int searchesLeft = 50;

  /// @return Whether this is the first time that `subject` comes up.
  bool firstTime(std::string subject) { return said.insert(std::move(subject)).second; }
};

}  // namespace pongsim::sdf
