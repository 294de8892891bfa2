#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "cli/view/sight.hh"

namespace pongsim::cli {

/// What a picture shows.
enum class PictureKind { kColors, kDepths, kTemperatures, kLabels };

struct ViewOptions {
  /// File of the world; empty: draw a running one.
  std::string file;
  /// For the world of a file: simulated seconds to run first.
  double at = 0;
  /// Name of the running world, or of the one in the file; empty: the only running one, or the first one in the file.
  std::string world;
  /// For finding the world, and for its answer.
  std::chrono::nanoseconds timeout = std::chrono::seconds(1);
  std::string camera;
  std::string output;
  /// Video file to write; empty: draw one picture.
  std::string video;
  /// Of the video.
  Time length = std::chrono::seconds(10);
  /// What the camera moves with; empty: nothing.
  std::string follow;
  /// Whether the camera turns around what it looks at, once in the video.
  bool orbits = false;
  PictureKind kind = PictureKind::kColors;
  std::uint32_t width = 1280;
  std::uint32_t height = 720;
  bool grid = false;
  bool axes = false;
  bool names = false;
  bool terminal = false;
  /// Draw sixels in the terminal, whatever features it reports.
  bool sixel = false;
};

/// Loads the world of the file and runs it for the given time. Reports failures.
/// @return Null on failure.
std::unique_ptr<Sight> sightOfFile(const ViewOptions& options);

/// Asks the running world for its scene. Reports failures, and files that are missing on this machine.
/// @return Null on failure.
std::unique_ptr<Sight> sightOfRunningWorld(const ViewOptions& options);

}  // namespace pongsim::cli
