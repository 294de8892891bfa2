#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "cli/view/view_command.hh"

namespace pongsim::cli {

/// A video that the program pongsim-video makes, because FFmpeg's libraries are no part of the core.
class VideoFile {
 public:
  /// Begins one. Reports if that is not possible.
  /// @param rate Frames per second.
  /// @return Null on failure.
  static std::unique_ptr<VideoFile> begin(const ViewOptions& options, int rate);
  /// Completes it.
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// @param frame Its number, higher than that of the picture before.
  /// @param pixels Red, green, blue.
  /// @return Whether the video goes on; otherwise it has been said why not.
  bool add(std::int64_t frame, std::span<const std::uint8_t> pixels);

  /// Ends it, and waits until it is complete.
  /// @return Whether it is; otherwise it has been said why not.
  bool complete();

 private:
  class Program;
  explicit VideoFile(std::unique_ptr<Program> program);

  std::unique_ptr<Program> program_;
};

}  // namespace pongsim::cli
