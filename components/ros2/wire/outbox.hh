#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <thread>

#include "ros2/wire/buffers.hh"
#include "ros2/wire/guid.hh"

namespace pongsim::ros2 {

/// Passes samples to DDS on its own thread, in order, so that the simulation never waits for DDS, which holds a
/// writer's lock while it sends. Any thread may use it.
class Outbox {
 public:
  /// A destination of samples.
  class Target {
   public:
    virtual ~Target() = default;
    /// Called from the outbox's thread. Takes ownership of the buffer.
    virtual void send(Buffer* buffer, const SampleId& related) = 0;
    /// @return Maximum number of its samples in the queue; beyond that, the oldest is dropped.
    virtual std::size_t mostWaiting() const = 0;

   protected:
    std::uint64_t droppedBeforeSending() const { return dropped_; }

   private:
    friend class Outbox;
    /// Samples in the outbox. Guarded by the outbox's mutex, like the next member.
    std::size_t waiting_ = 0;
    bool isSending_ = false;
    std::atomic<std::uint64_t> dropped_ = 0;
  };

  Outbox();
  /// All targets must have been flushed.
  ~Outbox();
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;

  /// Sends a buffer of `buffers()` after all that were added before.
  void add(Target& target, Buffer* buffer, const SampleId& related);
  Buffers& buffers() { return buffers_; }
  /// Waits until everything added for the target has been sent.
  void flush(Target& target);

 private:
  struct Entry {
    Target* target = nullptr;
    Buffer* buffer = nullptr;
    SampleId related;
  };
  void run();
  void dropOldestOf(const Target& target);

  Buffers buffers_;
  std::mutex mutex_;
  std::condition_variable added_;
  std::condition_variable sent_;
  std::deque<Entry> waiting_;
  bool isOver_ = false;
  std::thread thread_;
};

}  // namespace pongsim::ros2
