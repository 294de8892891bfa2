#include "video/recording.hh"

#include <cstddef>
#include <span>
#include <utility>

namespace pongsim::video {

namespace {

/// How many images wait at most.
constexpr std::size_t kMostWaiting = 4;

}  // namespace

Recording::Recording(std::unique_ptr<Encoder> encoder)
    : encoder_(std::move(encoder)), worker_([this](const std::stop_token& stop) { work(stop); }) {}

Recording::~Recording() = default;

Outcome<void> Recording::add(std::int64_t frame, std::string image) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.size() < kMostWaiting || !outcome_; });
  if (outcome_) waiting_.push_back({frame, std::move(image)});
  changed_.notify_all();
  return outcome_;
}

Outcome<void> Recording::complete() {
  worker_.request_stop();
  worker_.join();
  if (outcome_) outcome_ = encoder_->complete();
  return outcome_;
}

/// Encodes images until it is told to stop and none waits, or one can't be written.
void Recording::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return !waiting_.empty(); }), !waiting_.empty()) {
    const Image image = std::move(waiting_.front());
    lock.unlock();
    Outcome<void> added =
        encoder_->add(image.frame, {reinterpret_cast<const std::uint8_t*>(image.pixels.data()), image.pixels.size()});
    lock.lock();
    waiting_.pop_front();
    outcome_ = std::move(added);
    changed_.notify_all();
    if (!outcome_) return;
  }
}

}  // namespace pongsim::video
