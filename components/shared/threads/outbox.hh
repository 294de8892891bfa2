#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "shared/threads/buffer_pool.hh"
#include "shared/threads/complaint_limit.hh"

namespace pongsim::shared {

/// Passes published samples to DDS on its own thread, in order, so that publishers never wait for DDS, which holds a
/// writer's lock while it sends to slow or many readers. Thread-safe.
class Outbox {
 public:
  static constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();
  /// Of all samples that wait.
  struct Limits {
    std::size_t samples = 10'000;
    std::size_t bytes = 64 << 20;
  };

  /// A destination of samples.
  class Target {
   public:
    virtual ~Target() = default;
    /// Called on the outbox's thread.
    /// @return Whether it keeps the sample and gives it back later.
    virtual bool send(Buffer* sample) = 0;
    virtual const std::string& topic() const = 0;
    /// @return Maximum number of its samples that wait; beyond that its oldest is dropped.
    virtual std::size_t mostWaiting() const { return kUnlimited; }
    /// @return Whether samples of others are dropped before its own.
    virtual bool isDroppedLast() const { return false; }

   protected:
    /// @return Samples dropped by the outbox.
    std::uint64_t droppedBeforeSending() const { return dropped_; }

   private:
    friend class Outbox;
    /// Guarded by the outbox's mutex: its samples that wait, and whether one is being sent.
    std::size_t waiting_ = 0;
    bool isSending_ = false;
    std::atomic<std::uint64_t> dropped_ = 0;
  };

  explicit Outbox(const Limits& limits);
  /// All targets must have been flushed.
  ~Outbox();
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;

  /// Sends a sample after all earlier ones. Beyond the limits, the oldest is dropped, with an occasional warning; those
  /// of targets that are dropped last only if there are no others.
  /// @param fill Writes the sample.
  void add(Target& target, std::size_t size, const std::function<void(std::span<std::byte>)>& fill);

  /// @return A buffer of that size, to be given back.
  Buffer* take(std::size_t size);
  void giveBack(Buffer* sample);

  /// Waits until all samples of the target were sent.
  void flush(Target& target);

 private:
  struct Sample {
    Target* target = nullptr;
    Buffer* buffer = nullptr;
  };

  void run();
  template <class Condition>
  Sample takeOldest(const Condition& condition);
  void drop(const Sample& sample);
  void tellWhenSent(const Target& target);

  Limits limits_;
  std::mutex mutex_;
  std::condition_variable added_;
  std::condition_variable sent_;
  BufferPool buffers_;
  /// From `first_` on; those before have been taken.
  std::vector<Sample> waiting_;
  std::size_t first_ = 0;
  std::size_t waitingBytes_ = 0;
  ComplaintLimit complaints_;
  bool isOver_ = false;
  std::thread thread_;
};

}  // namespace pongsim::shared
