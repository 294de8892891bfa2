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

/// Takes what is published to DDS on a thread of its own, so that nobody who publishes waits for DDS, which holds a
/// writer's lock while it sends to a slow or large audience. Any thread may use it.
class Outbox {
 public:
  /// Somewhere that samples go.
  class Target {
   public:
    virtual ~Target() = default;
    /// Called from the outbox's thread.
    /// @return Whether it keeps the sample, which it then gives back.
    virtual bool send(Buffer* sample) = 0;
    virtual const std::string& topic() const = 0;

   protected:
    /// @return Samples that the outbox has dropped.
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

  /// Sends a sample after all that were added before it. Where more than 10,000 samples or 64 MiB wait, the oldest is
  /// dropped, with a warning now and then.
  /// @param fill Writes the sample to the place of that size which it is given.
  void add(Target& target, std::size_t size, const std::function<void(std::span<std::byte>)>& fill);

  /// @return Room for a sample of so many bytes, to be given back.
  Buffer* take(std::size_t size);
  void giveBack(Buffer* sample);

  /// Waits until all that was added for the target has been sent.
  void flush(Target& target);

 private:
  struct Entry {
    Target* target = nullptr;
    Buffer* buffer = nullptr;
  };

  void run();
  void dropOldest();
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
