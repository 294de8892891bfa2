#include "transport/parcel.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace pongsim::transport {
namespace {

constexpr const char* kParcelType = "ignition.msgs.StringMsg";

class ParcelPoolTest : public testing::Test {
 protected:
  Parcel* parcelOf(const std::string& text, SpareParcels& spare) {
    ignition::msgs::StringMsg message;
    message.set_data(text);
    Parcel* parcel = pool_.take(spare, message.ByteSizeLong());
    message.SerializeToArray(parcel->bytes->bytes.data(), static_cast<int>(parcel->bytes->bytes.size()));
    return parcel;
  }

  ParcelPool pool_;
  SpareParcels texts_, others_;
};

}  // namespace

TEST_F(ParcelPoolTest, ReusesTheParcelsOfAType) {
  Parcel* parcel = parcelOf("hello", texts_);
  const Message* message = parcel->parsed(kParcelType);
  const Buffer* buffer = parcel->bytes;
  ++parcel->users;
  pool_.giveBack(parcel);
  EXPECT_NE(pool_.take(texts_, 10), parcel) << "one still uses it";
  pool_.giveBack(parcel);
  EXPECT_NE(pool_.take(others_, 1000), parcel);
  EXPECT_EQ(parcelOf("again", texts_), parcel);
  EXPECT_EQ(parcel->bytes, buffer);
  EXPECT_EQ(parcel->parsed(kParcelType), message);
  EXPECT_EQ(message->ShortDebugString(), "data: \"again\"");
}

TEST_F(ParcelPoolTest, IsParsedOnceForAllThreads) {
  Parcel* parcel = parcelOf(std::string(100'000, 'x'), texts_);
  std::vector<const Message*> seen(8);
  std::vector<std::thread> threads;
  for (const Message*& each : seen) threads.emplace_back([&each, parcel] { each = parcel->parsed(kParcelType); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(seen.front());
  EXPECT_EQ(std::ranges::count(seen, seen.front()), 8);
}

TEST_F(ParcelPoolTest, SaysWhenBytesAreNoMessage) {
  Parcel* parcel = pool_.take(texts_, 5);
  std::ranges::fill(parcel->bytes->bytes, std::byte{0xff});
  EXPECT_EQ(parcel->parsed(kParcelType), nullptr);
  EXPECT_EQ(parcel->parsed(kParcelType), nullptr);
  pool_.giveBack(parcel);
  EXPECT_TRUE(parcelOf("good", texts_)->parsed(kParcelType));
}

TEST_F(ParcelPoolTest, FreesWhatABurstHasNeeded) {
  std::vector<Parcel*> taken;
  const std::string text(ParcelPool::kMostSpareBytes / 10, 'x');
  for (int i = 0; i < 100; ++i) {
    taken.push_back(parcelOf(text, texts_));
    taken.back()->parsed(kParcelType);
  }
  for (Parcel* parcel : taken) pool_.giveBack(parcel);
  EXPECT_EQ(texts_.parcels.size(), 9U);
  EXPECT_LE(texts_.bytes, ParcelPool::kMostSpareBytes);
  for (int i = 0; i < 9; ++i) pool_.take(texts_, 1);
  EXPECT_EQ(texts_.bytes, 0U);
  Parcel* large = parcelOf(std::string(2 * ParcelPool::kMostSpareBytes, 'x'), texts_);
  large->parsed(kParcelType);
  pool_.giveBack(large);
  EXPECT_EQ(texts_.parcels.size(), 1U) << "one is kept, of whatever size";
}

}  // namespace pongsim::transport
