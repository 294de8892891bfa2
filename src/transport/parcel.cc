#include "transport/parcel.hh"

#include <thread>
#include <utility>

#include "msgs/encoding/bytes.hh"

namespace pongsim::transport {

const Message* Parcel::parsed(const std::string& type) {
  State state = State::kUnread;
  if (state_.compare_exchange_strong(state, State::kBeingRead, std::memory_order_acquire)) {
    state = State::kUnreadable;
    try {
      if (!message_) message_ = newMessage(type);
      messageSize_ = bytes->bytes.size();
      if (message_ && msgs::parseBytes(bytes->bytes, *message_)) state = State::kRead;
    } catch (...) {
      state_.store(State::kUnread, std::memory_order_release);
      throw;
    }
    state_.store(state, std::memory_order_release);
  } else if (state == State::kBeingRead) {
    // by the thread of another transport that shares the bus, for microseconds
    std::this_thread::yield();
    return parsed(type);
  }
  return state == State::kRead ? message_.get() : nullptr;
}

std::size_t Parcel::occupiedBytes() const { return sizeof(Parcel) + messageSize_; }

Parcel* ParcelPool::take(SpareParcels& spare, std::size_t size) {
  Buffer* buffer = buffers_.take(size);
  Parcel* parcel = nullptr;
  if (spare.parcels.empty()) {
    // giving back must not allocate
    if (spare.parcels.capacity() <= all_.size()) spare.parcels.reserve(2 * all_.size() + 1);
    parcel = all_.emplace_back(std::make_unique<Parcel>()).get();
    parcel->spare_ = &spare;
    parcel->index_ = all_.size() - 1;
  } else {
    parcel = spare.parcels.back();
    spare.parcels.pop_back();
    spare.bytes -= parcel->occupiedBytes();
  }
  parcel->bytes = buffer;
  parcel->users = 1;
  parcel->sender = kThisProcess;
  parcel->origin = nullptr;
  parcel->state_.store(Parcel::State::kUnread, std::memory_order_relaxed);
  return parcel;
}

void ParcelPool::giveBack(Parcel* parcel) {
  if (--parcel->users > 0) return;
  buffers_.giveBack(std::exchange(parcel->bytes, nullptr));
  SpareParcels& spare = *parcel->spare_;
  const std::size_t bytes = parcel->occupiedBytes();
  if (spare.parcels.empty() || spare.bytes + bytes <= kMostSpareBytes) {
    spare.bytes += bytes;
    spare.parcels.push_back(parcel);
    return;
  }
  const std::size_t index = parcel->index_;
  std::swap(all_[index], all_.back());
  all_[index]->index_ = index;
  all_.pop_back();
}

}  // namespace pongsim::transport
