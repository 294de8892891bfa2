#include "transport/network/sample_pool.hh"

#include <fastdds/rtps/common/CacheChange.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "transport/payload.hh"

namespace pongsim::transport {

namespace {

namespace rtps = eprosima::fastrtps::rtps;

// The library stores the list of missing fragments in the memory of the fragments, rounded up by at most this.
constexpr std::size_t kFragmentNote = 8;

void setPayload(rtps::CacheChange_t& change, Buffer* buffer, rtps::IPayloadPool* owner) {
  change.serializedPayload.data = reinterpret_cast<rtps::octet*>(buffer->bytes.data());
  change.serializedPayload.max_size = static_cast<std::uint32_t>(buffer->bytes.size());
  change.serializedPayload.pos = 0;
  change.payload_owner(owner);
}

/// The library frees what it finds there.
void clearPayload(rtps::CacheChange_t& change) {
  change.serializedPayload.data = nullptr;
  change.serializedPayload.length = 0;
  change.serializedPayload.max_size = 0;
  change.serializedPayload.pos = 0;
  change.payload_owner(nullptr);
}

}  // namespace

bool SentSamples::get_payload(std::uint32_t, Change& change) {
  Buffer* sample = std::exchange(next_, nullptr);
  if (sample == nullptr) return false;
  setPayload(change, sample, this);
  samples_.push_back(sample);
  return true;
}

/// Only readers take what others have.
bool SentSamples::get_payload(rtps::SerializedPayload_t&, IPayloadPool*&, Change&) { return false; }

bool SentSamples::release_payload(Change& change) {
  const auto* data = reinterpret_cast<const std::byte*>(change.serializedPayload.data);
  const auto found = std::ranges::find(samples_, data, [](const Buffer* each) { return each->bytes.data(); });
  if (found == samples_.end()) return false;
  outbox_.giveBack(*found);
  samples_.erase(found);
  clearPayload(change);
  return true;
}

Buffer* ReceivedSamples::bufferOf(const Change& change) {
  const Lock lock(mutex_);
  const auto found = std::ranges::find(arriving_, &change, &Sample::change);
  return found == arriving_.end() ? nullptr : found->buffer;
}

bool ReceivedSamples::get_payload(std::uint32_t size, Change& change) {
  const Lock lock(mutex_);
  if (size > kMostArriving - arrivingBytes_) return false;
  Buffer* buffer = buffers_.take(size + kFragmentNote);
  buffer->bytes = buffer->bytes.first(size);
  setPayload(change, buffer, this);
  arriving_.push_back({&change, buffer, size});
  arrivingBytes_ += size;
  return true;
}

bool ReceivedSamples::get_payload(rtps::SerializedPayload_t& data, IPayloadPool*&, Change& change) {
  if (!get_payload(data.length, change)) return false;
  change.serializedPayload.length = data.length;
  change.serializedPayload.encapsulation = data.encapsulation;
  if (data.length > 0) std::memcpy(change.serializedPayload.data, data.data, data.length);
  return true;
}

bool ReceivedSamples::release_payload(Change& change) {
  {
    const Lock lock(mutex_);
    const auto found = std::ranges::find(arriving_, &change, &Sample::change);
    if (found == arriving_.end()) return false;
    buffers_.giveBack(found->buffer);
    arrivingBytes_ -= found->size;
    arriving_.erase(found);
  }
  clearPayload(change);
  return true;
}

}  // namespace pongsim::transport
