#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "pongsim/message.hh"
#include "transport/buffer_pool.hh"

namespace pongsim::transport {

struct Parcel;

/// Parcels of one message type that nobody uses.
struct SpareParcels {
  std::vector<Parcel*> parcels;
  /// About what they occupy.
  std::size_t bytes = 0;
};

/// A message for subscriptions of this process, which share it: a copy of what was published, or its bytes.
struct Parcel {
  ParticipantId sender{};
  /// Of the message in protobuf's binary form [bytes].
  std::size_t size = 0;
  /// Null: the content is `message`.
  Buffer* bytes = nullptr;
  /// Without `bytes`, the content. Reused, so that a copy into it seldom allocates.
  MessagePointer message;
  std::size_t users = 0;

  // for the pool: where it goes, and its index there
  SpareParcels* spare = nullptr;
  std::size_t index = 0;
};

/// Reuses parcels, so that a steady flow of messages does not allocate. Not thread-safe.
class ParcelPool {
 public:
  /// What the unused parcels of one type may occupy; more are freed.
  static constexpr std::size_t kMostSpareBytes = 1 << 20;

  /// @return A parcel for one user, with any message or none.
  Parcel* take(SpareParcels& spare, std::size_t size);
  /// @return A parcel with a buffer of that size.
  Parcel* takeBytes(std::size_t size);
  /// Ends one use.
  void giveBack(Parcel* parcel);

 private:
  std::vector<std::unique_ptr<Parcel>> all_;
  SpareParcels spareOfBytes_;
  BufferPool buffers_;
};

}  // namespace pongsim::transport
