#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "cli/view/sight.hh"

namespace pongsim::cli {

struct ViewOptions {
  /// File of the world; empty: one that runs is drawn.
  std::string file;
  /// Simulated seconds that go by before, of a file's world.
  double at = 0;
  /// Name of the running world, or of the one of the file; empty: the only one that runs, the first one of the file.
  std::string world;
  /// For finding that, and for its answer.
  std::chrono::nanoseconds timeout = std::chrono::seconds(1);
  std::string camera;
  std::string output;
  std::uint32_t width = 1280;
  std::uint32_t height = 720;
  bool grid = false;
  bool axes = false;
  bool names = false;
  bool terminal = false;
  /// In the terminal, whatever that says that it can.
  bool sixel = false;
};

/// Loads the world of the file and lets time go by. Says why where it can't.
/// @return Null where it can't.
std::unique_ptr<Sight> sightOfFile(const ViewOptions& options);

/// Asks the world that runs what there is to be seen. Says why where it can't, and which files are not here.
/// @return Null where it can't.
std::unique_ptr<Sight> sightOfRunningWorld(const ViewOptions& options);

}  // namespace pongsim::cli
