#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "pongsim/outcome.hh"

namespace pongsim::video {

/// How an image's pixels are stored, row by row.
enum class Pixels { kRgb, kBgr, kGrey, kGrey16 };

struct VideoSettings {
  /// Of the images. The video lacks the last row or column of odd ones, because its colours are those of 2 by 2 pixels.
  int width = 0;
  int height = 0;
  Pixels pixels = Pixels::kRgb;
  /// "mp4", "avi" or "ogv": H.264, MPEG-4 Part 2 or Theora.
  std::string format = "mp4";
  /// Frames per second.
  int rate = 25;
  /// [bit/s]
  int bitrate = 2'070'000;
};

/// @return Whether there is a video format of that name.
bool isVideoFormat(const std::string& format);

/// Encodes images into a video file, by FFmpeg's libraries. The same images give the same bytes.
class Encoder {
 public:
  /// Begins a new file.
  /// @param place Where it is when it is complete; see `OutputFile`.
  static Outcome<std::unique_ptr<Encoder>> create(const std::filesystem::path& place, const VideoSettings& settings);
  /// Removes the file, unless it is complete.
  ~Encoder();
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  /// Adds an image. It is shown until the next one.
  /// @param frame Its number, higher than that of the image before.
  Outcome<void> add(std::int64_t frame, std::span<const std::uint8_t> image);

  /// Completes the file. Nothing can be added behind it.
  Outcome<void> complete();

  const std::filesystem::path& place() const;

 private:
  class Parts;
  explicit Encoder(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim::video
