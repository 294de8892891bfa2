#include "log/record/state_recorder.hh"

#include <google/protobuf/message.h>

#include <chrono>
#include <utility>

namespace pongsim::log {

namespace {

constexpr std::size_t kMostWaiting = 64;
/// The writer is woken for this many snapshots; fewer wait for the timeout.
constexpr std::size_t kWorthWaking = 16;
constexpr std::chrono::milliseconds kLongestWait{50};

}  // namespace

StateRecorder::StateRecorder(const Scene& scene, Writer& writer, std::string topic,
                             std::function<void(const Message&)> entitiesChanged)
    : watch_(scene), writer_(writer), topic_(std::move(topic)), entitiesChanged_(std::move(entitiesChanged)) {
  for (std::size_t i = 0; i < kMostWaiting; ++i) free_.push_back(std::make_unique<StateSnapshot>());
  thread_ = std::thread([this] { work(); });
}

StateRecorder::~StateRecorder() {
  try {
    finish();
  } catch (const Failure&) {
    // errors are reported by finish
  }
}

void StateRecorder::record() {
  std::unique_ptr<StateSnapshot> snapshot;
  {
    std::unique_lock lock(mutex_);
    if (free_.empty()) hasWork_.notify_one();
    hasRoom_.wait(lock, [this] { return failure_ || !free_.empty(); });
    if (failure_) throw *failure_;
    snapshot = std::move(free_.back());
    free_.pop_back();
  }
  watch_.take(*snapshot);
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(snapshot));
  if (waiting_.size() == kWorthWaking) hasWork_.notify_one();
}

void StateRecorder::finish() {
  if (thread_.joinable()) {
    {
      const std::lock_guard lock(mutex_);
      isFinishing_ = true;
    }
    hasWork_.notify_one();
    thread_.join();
  }
  if (failure_) throw *failure_;
}

void StateRecorder::work() {
  StateChanges changes;
  const MessagePointer message = newMessage("ignition.msgs.SerializedStateMap");
  std::string bytes;
  std::unique_lock lock(mutex_);
  while (true) {
    hasWork_.wait_for(lock, kLongestWait, [this] { return isFinishing_ || waiting_.size() >= kWorthWaking; });
    if (waiting_.empty() && isFinishing_) return;
    while (!waiting_.empty()) {
      std::unique_ptr<StateSnapshot> snapshot = std::move(waiting_.front());
      waiting_.pop_front();
      lock.unlock();
      std::optional<Failure> failure;
      try {
        if (snapshot->everything) entitiesChanged_(*snapshot->everything);
        if (changes.tell(*snapshot, *message)) {
          message->SerializeToString(&bytes);
          writer_.write({snapshot->time.count(), topic_, "ignition.msgs.SerializedStateMap", bytes});
        }
      } catch (const Failure& why) {
        failure = why;
      } catch (const std::exception& why) {
        failure = Failure(why.what());
      }
      lock.lock();
      free_.push_back(std::move(snapshot));
      hasRoom_.notify_one();
      if (!failure) continue;
      failure_ = failure;
      hasRoom_.notify_all();
      return;
    }
  }
}

}  // namespace pongsim::log
