#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "pongsim/outcome.hh"
#include "video/encoder.hh"

namespace pongsim::video {

/// Encodes images on a thread of its own. Where that is behind by some images, `add` waits.
class Recording {
 public:
  explicit Recording(std::unique_ptr<Encoder> encoder);
  /// Removes the file, unless it is complete.
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// @param frame See `Encoder::add`.
  /// @return Why an earlier image could not be written; then nothing more is.
  Outcome<void> add(std::int64_t frame, std::string image);

  /// Waits for all images, and completes the file.
  Outcome<void> complete();

  const std::filesystem::path& place() const { return encoder_->place(); }

 private:
  struct Image {
    std::int64_t frame;
    std::string pixels;
  };

  void work(const std::stop_token& stop);

  std::unique_ptr<Encoder> encoder_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Image> waiting_;
  Outcome<void> outcome_;
  // ends first
  std::jthread worker_;
};

}  // namespace pongsim::video
