#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace pongsim::video {

/// Which frame of a video an image is.
class FrameClock {
 public:
  /// @param rate Frames per second.
  explicit FrameClock(int rate) : rate_(rate) {}

  /// @param time Of the image. Where it goes back, because the world was reset, the video goes on.
  /// @return Number of its frame, each higher than the one before; nothing if there is an image of that frame already.
  std::optional<std::int64_t> frameOf(std::chrono::nanoseconds time) {
    if (!last_) {
      start_ = time;
    } else if (time < lastTime_) {
      start_ = time - std::chrono::nanoseconds((*last_ + 1) * kSecond / rate_ + 1);
    }
    lastTime_ = time;
    // exact: 2^63 ns * rate does not fit, whole seconds and the rest do
    const std::int64_t passed = (time - start_).count();
    const std::int64_t frame = passed / kSecond * rate_ + passed % kSecond * rate_ / kSecond;
    if (last_ && frame <= *last_) return std::nullopt;
    last_ = frame;
    return frame;
  }

  /// @return Length of the video at the last image.
  std::chrono::nanoseconds length() const { return lastTime_ - start_; }

 private:
  static constexpr std::int64_t kSecond = 1'000'000'000;

  std::int64_t rate_;
  std::chrono::nanoseconds start_{0};
  std::chrono::nanoseconds lastTime_{0};
  std::optional<std::int64_t> last_;
};

}  // namespace pongsim::video
