#pragma once

#include <filesystem>

namespace pongsim::sim {

/// Told on the simulation's thread what a run does with its world.
class RunObserver {
 public:
  virtual ~RunObserver() = default;
  /// Messages and requests were handed over.
  virtual void dispatched() = 0;
  /// Requests were handled, and no messages.
  virtual void served() = 0;
  /// A step was made, or without moving anything if the run is paused.
  virtual void advanced(bool paused) = 0;
  /// A request to another world has added a resource folder.
  virtual void folderAdded(const std::filesystem::path& folder) = 0;
};

}  // namespace pongsim::sim
