#pragma once

#include <fastdds/rtps/history/IPayloadPool.h>

#include <deque>
#include <vector>

#include "shared/threads/outbox.hh"
#include "transport/buffer_pool.hh"
#include "transport/locks.hh"
#include "transport/payload.hh"

namespace pongsim::transport {

class Outbox;

/// Payload pool of a writer: samples stay in the outbox's buffers, so that none is copied on its way to DDS. Use it
/// with the writer's lock.
class SentSamples final : public eprosima::fastrtps::rtps::IPayloadPool {
 public:
  using Change = eprosima::fastrtps::rtps::CacheChange_t;

  explicit SentSamples(shared::Outbox& outbox) : outbox_(outbox) {}

  /// Sets the buffer of the next change; it returns to the outbox with the change.
  void setNext(Buffer* sample) { next_ = sample; }

  bool get_payload(std::uint32_t size, Change& change) override;
  bool get_payload(eprosima::fastrtps::rtps::SerializedPayload_t& data, IPayloadPool*& owner, Change& change) override;
  bool release_payload(Change& change) override;

 private:
  shared::Outbox& outbox_;
  Buffer* next_ = nullptr;
  /// In the order of sending, in which most are released.
  std::deque<Buffer*> samples_;
};

/// Payload pool of a reader: samples arrive in buffers whose bytes may be swapped out. Thread-safe.
///
/// A fragmented sample gets its buffer with its first fragment, however few follow. Such buffers are limited to
/// `kMostArriving` bytes in total; further samples wait, since their writer sends them again.
class ReceivedSamples final : public eprosima::fastrtps::rtps::IPayloadPool {
 public:
  using Change = eprosima::fastrtps::rtps::CacheChange_t;

  static constexpr std::size_t kMostArriving = payloadSize(kMaximumMessage);

  /// @return The buffer of a received change. Bytes swapped into it are reused.
  Buffer* bufferOf(const Change& change);

  bool get_payload(std::uint32_t size, Change& change) override;
  bool get_payload(eprosima::fastrtps::rtps::SerializedPayload_t& data, IPayloadPool*& owner, Change& change) override;
  bool release_payload(Change& change) override;

 private:
  struct Sample {
    const Change* change;
    Buffer* buffer;
    std::size_t size;
  };

  Mutex mutex_;
  BufferPool buffers_ GUARDED_BY(mutex_);
  std::vector<Sample> arriving_ GUARDED_BY(mutex_);
  std::size_t arrivingBytes_ GUARDED_BY(mutex_) = 0;
};

}  // namespace pongsim::transport
