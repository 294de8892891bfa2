#include "transport/parcel.hh"

#include <gtest/gtest.h>

#include <vector>

namespace pongsim::transport {

TEST(ParcelPool, ReusesTheParcelsOfAType) {
  ParcelPool pool;
  SpareParcels texts, numbers;
  Parcel* text = pool.take(texts, 10);
  text->message = newMessage("ignition.msgs.StringMsg");
  ++text->users;
  pool.giveBack(text);
  EXPECT_NE(pool.take(texts, 10), text) << "one still uses it";
  pool.giveBack(text);
  EXPECT_NE(pool.take(numbers, 10), text);
  EXPECT_EQ(pool.take(texts, 20), text);
  EXPECT_EQ(text->size, 20U);
  EXPECT_TRUE(text->message);
}

TEST(ParcelPool, FreesWhatABurstHasNeeded) {
  ParcelPool pool;
  SpareParcels spare;
  std::vector<Parcel*> taken;
  for (int i = 0; i < 100; ++i) {
    taken.push_back(pool.take(spare, ParcelPool::kMostSpareBytes / 10));
    taken.back()->message = newMessage("ignition.msgs.StringMsg");
  }
  for (Parcel* parcel : taken) pool.giveBack(parcel);
  EXPECT_EQ(spare.parcels.size(), 9U);
  EXPECT_LE(spare.bytes, ParcelPool::kMostSpareBytes);
  Parcel* large = pool.take(spare, 2 * ParcelPool::kMostSpareBytes);
  EXPECT_EQ(large->size, 2 * ParcelPool::kMostSpareBytes);
  for (int i = 0; i < 8; ++i) pool.take(spare, 1);
  EXPECT_EQ(spare.bytes, 0U);
  pool.giveBack(large);
  EXPECT_EQ(spare.parcels.size(), 1U) << "one is kept, of whatever size";
}

TEST(ParcelPool, GivesBuffersBack) {
  ParcelPool pool;
  Parcel* parcel = pool.takeBytes(100);
  const Buffer* buffer = parcel->bytes;
  EXPECT_EQ(buffer->bytes.size(), 100U);
  pool.giveBack(parcel);
  EXPECT_EQ(pool.takeBytes(100)->bytes, buffer);
}

}  // namespace pongsim::transport
