#pragma once

#include <fastdds/rtps/history/IPayloadPool.h>

#include <deque>
#include <mutex>
#include <vector>

#include "transport/buffer_pool.hh"

namespace pongsim::transport {

class Outbox;

/// Where the samples of a writer are: in the outbox's buffers, so that none is copied on its way to DDS. For the
/// writer's lock.
class SentSamples final : public eprosima::fastrtps::rtps::IPayloadPool {
 public:
  using Change = eprosima::fastrtps::rtps::CacheChange_t;

  explicit SentSamples(Outbox& outbox) : outbox_(outbox) {}

  /// The change that is made next is of this buffer, which goes back to the outbox with it.
  void setNext(Buffer* sample) { next_ = sample; }

  bool get_payload(std::uint32_t size, Change& change) override;
  bool get_payload(eprosima::fastrtps::rtps::SerializedPayload_t& data, IPayloadPool*& owner, Change& change) override;
  bool release_payload(Change& change) override;

 private:
  Outbox& outbox_;
  Buffer* next_ = nullptr;
  /// In the order of sending, in which they mostly go, too.
  std::deque<Buffer*> samples_;
};

/// Where the samples of a reader arrive: in buffers whose bytes may be taken from there. Any thread may use it.
class ReceivedSamples final : public eprosima::fastrtps::rtps::IPayloadPool {
 public:
  using Change = eprosima::fastrtps::rtps::CacheChange_t;

  /// @return The buffer of a change that has arrived. What is exchanged for its bytes is used for later ones.
  Buffer* bufferOf(const Change& change);

  bool get_payload(std::uint32_t size, Change& change) override;
  bool get_payload(eprosima::fastrtps::rtps::SerializedPayload_t& data, IPayloadPool*& owner, Change& change) override;
  bool release_payload(Change& change) override;

 private:
  struct Entry {
    const Change* change;
    Buffer* buffer;
  };

  std::mutex mutex_;
  BufferPool buffers_;
  std::vector<Entry> arriving_;
};

}  // namespace pongsim::transport
