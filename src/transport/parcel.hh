#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/message.hh"
#include "transport/buffer_pool.hh"

namespace pongsim::transport {

class DispatchQueue;
class Parcel;

/// Parcels of one message type that nobody uses.
struct SpareParcels {
  std::vector<Parcel*> parcels;
  /// About what they occupy.
  std::size_t bytes = 0;
};

/// A message for subscriptions of this process, which share it.
class Parcel {
 public:
  ParticipantId sender{};
  /// The queue of the world that published it in its own step or dispatch; null where it comes from outside.
  const DispatchQueue* origin = nullptr;
  /// The message in protobuf's binary form.
  Buffer* bytes = nullptr;
  std::size_t users = 0;

  /// @return The message, parsed by the first call; null if the bytes are not of that type. Thread-safe.
  const Message* parsed(const std::string& type);

 private:
  friend class ParcelPool;
  enum class State { kUnread, kBeingRead, kRead, kUnreadable };

  std::size_t occupiedBytes() const;

  std::atomic<State> state_ = State::kUnread;
  /// Reused, so that parsing seldom allocates.
  MessagePointer message_;
  std::size_t messageSize_ = 0;
  /// Where it returns to, and its index in the pool.
  SpareParcels* spare_ = nullptr;
  std::size_t index_ = 0;
};

/// Reuses parcels, so that a steady flow of messages does not allocate. Not thread-safe.
class ParcelPool {
 public:
  /// What the unused parcels of one type may occupy; more are freed.
  static constexpr std::size_t kMostSpareBytes = 1 << 20;

  /// @return A parcel for one user, with a buffer of that size.
  Parcel* take(SpareParcels& spare, std::size_t size);
  /// Ends one use.
  void giveBack(Parcel* parcel);

 private:
  std::vector<std::unique_ptr<Parcel>> all_;
  BufferPool buffers_;
};

}  // namespace pongsim::transport
