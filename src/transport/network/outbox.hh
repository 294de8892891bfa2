#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "transport/buffer_pool.hh"
#include "transport/complaint_limit.hh"

namespace pongsim::transport {

/// Passes published samples to DDS on its own thread, so that publishers never wait for DDS, which holds a writer's
/// lock while it sends to slow or many readers. Thread-safe.
class Outbox {
 public:
  /// A destination of samples.
  class Target {
   public:
    virtual ~Target() = default;
    /// Called on the outbox's thread.
    /// @return Whether it keeps the sample and gives it back later.
    virtual bool send(Buffer* sample) = 0;
    virtual const std::string& topic() const = 0;
    /// @return Whether samples of others are dropped before its own.
    virtual bool isDroppedLast() const { return false; }

   protected:
    /// @return Samples dropped by the outbox.
    std::uint64_t droppedBeforeSending() const { return dropped_; }

   private:
    friend class Outbox;
    /// In the outbox or being sent; guarded by the outbox's mutex.
    std::size_t pending_ = 0;
    std::atomic<std::uint64_t> dropped_ = 0;
  };

  Outbox();
  /// All targets must have been flushed.
  ~Outbox();
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;

  /// Sends a sample after all earlier ones. If more than 10,000 samples or 64 MiB wait, the oldest is dropped, with an
  /// occasional warning; those of targets that are dropped last only if there are no others.
  /// @param fill Writes the sample.
  void add(Target& target, std::size_t size, const std::function<void(std::span<std::byte>)>& fill);

  /// @return A buffer of that size, to be given back.
  Buffer* take(std::size_t size);
  void giveBack(Buffer* sample);

  /// Waits until all samples of the target were sent.
  void flush(Target& target);

 private:
  struct Entry {
    Target* target = nullptr;
    Buffer* buffer = nullptr;
  };

  void run();
  Entry takeOldest();
  void drop(const Entry& entry);
  void done(const Entry& entry, bool isKept);

  std::mutex mutex_;
  std::condition_variable added_;
  std::condition_variable sent_;
  BufferPool buffers_;
  std::vector<Entry> waiting_;
  /// Those before it were dropped.
  std::size_t first_ = 0;
  std::size_t waitingBytes_ = 0;
  ComplaintLimit complaints_;
  bool isOver_ = false;
  std::thread thread_;
};

}  // namespace pongsim::transport
