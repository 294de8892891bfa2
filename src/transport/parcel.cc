#include "transport/parcel.hh"

#include <utility>

namespace pongsim::transport {

namespace {

std::size_t occupiedBytes(const Parcel& parcel) { return sizeof(Parcel) + (parcel.message ? parcel.size : 0); }

}  // namespace

Parcel* ParcelPool::take(SpareParcels& spare, std::size_t size) {
  Parcel* parcel = nullptr;
  if (spare.parcels.empty()) {
    // giving back must not allocate
    if (spare.parcels.capacity() <= all_.size()) spare.parcels.reserve(2 * all_.size() + 1);
    parcel = all_.emplace_back(std::make_unique<Parcel>()).get();
    parcel->spare = &spare;
    parcel->index = all_.size() - 1;
  } else {
    parcel = spare.parcels.back();
    spare.parcels.pop_back();
    spare.bytes -= occupiedBytes(*parcel);
  }
  parcel->size = size;
  parcel->users = 1;
  parcel->sender = kThisProcess;
  return parcel;
}

Parcel* ParcelPool::takeBytes(std::size_t size) {
  Buffer* buffer = buffers_.take(size);
  Parcel* parcel = take(spareOfBytes_, size);
  parcel->bytes = buffer;
  return parcel;
}

void ParcelPool::giveBack(Parcel* parcel) {
  if (--parcel->users > 0) return;
  if (parcel->bytes != nullptr) buffers_.giveBack(std::exchange(parcel->bytes, nullptr));
  SpareParcels& spare = *parcel->spare;
  const std::size_t bytes = occupiedBytes(*parcel);
  if (spare.parcels.empty() || spare.bytes + bytes <= kMostSpareBytes) {
    spare.bytes += bytes;
    spare.parcels.push_back(parcel);
    return;
  }
  const std::size_t index = parcel->index;
  std::swap(all_[index], all_.back());
  all_[index]->index = index;
  all_.pop_back();
}

}  // namespace pongsim::transport
