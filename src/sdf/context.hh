#pragma once

#include <set>
#include <string>

#include "pongsim/diagnostic.hh"

namespace pongsim::sdf {

/// What the readers of one file share.
struct Context {
  Diagnostics& diagnostics;
  /// The file is written in SDF 1.`version`.
  int version = 9;
  /// Subjects of warnings that are given once a file.
  std::set<std::string> said;
  /// How many more unknown names are worth a search for one that is spelt alike, which takes its time.
  int searchesLeft = 50;

  /// @return Whether this is the first time that `subject` comes up.
  bool firstTime(std::string subject) { return said.insert(std::move(subject)).second; }
};

}  // namespace pongsim::sdf
