#include "transport/network/sample_pool.hh"

#include <fastdds/rtps/common/CacheChange.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "shared/threads/outbox.hh"
#include "transport/payload.hh"

namespace pongsim::transport {

namespace {

using eprosima::fastrtps::rtps::CacheChange_t;
using eprosima::fastrtps::rtps::IPayloadPool;
using eprosima::fastrtps::rtps::octet;
using eprosima::fastrtps::rtps::SerializedPayload_t;

const octet* dataOf(const Buffer* buffer) { return reinterpret_cast<const octet*>(buffer->bytes.data()); }

}  // namespace

TEST(SentSamples, LieInTheOutboxesBuffersAndGoBackThere) {
  shared::Outbox outbox({});
  SentSamples pool(outbox);
  CacheChange_t first, second;
  EXPECT_FALSE(pool.get_payload(100, first)) << "there is none";
  Buffer* one = outbox.take(100);
  Buffer* two = outbox.take(100);
  pool.setNext(one);
  ASSERT_TRUE(pool.get_payload(100, first));
  pool.setNext(two);
  ASSERT_TRUE(pool.get_payload(100, second));
  EXPECT_EQ(first.serializedPayload.data, dataOf(one));
  EXPECT_EQ(second.serializedPayload.data, dataOf(two));

  EXPECT_TRUE(pool.release_payload(second));
  EXPECT_EQ(second.serializedPayload.data, nullptr) << "which the library would free";
  EXPECT_EQ(outbox.take(100), two);
  EXPECT_TRUE(pool.release_payload(first));
  EXPECT_EQ(outbox.take(100), one);
}

TEST(ReceivedSamples, MayHaveTheirBytesTaken) {
  ReceivedSamples pool;
  CacheChange_t change;
  ASSERT_TRUE(pool.get_payload(1000, change));
  Buffer* buffer = pool.bufferOf(change);
  ASSERT_NE(buffer, nullptr);
  EXPECT_EQ(buffer->bytes.size(), 1000);
  EXPECT_EQ(change.serializedPayload.data, dataOf(buffer));
  EXPECT_EQ(change.serializedPayload.max_size, 1000);

  Buffer mine;
  mine.resize(1024);
  buffer->swapBytes(mine);
  EXPECT_EQ(change.serializedPayload.data, dataOf(&mine));
  EXPECT_TRUE(pool.release_payload(change));
  EXPECT_EQ(change.serializedPayload.data, nullptr);
  EXPECT_EQ(pool.bufferOf(change), nullptr);
}

TEST(ReceivedSamples, AreCopiedWhereTheyCameInOnePacket) {
  ReceivedSamples pool;
  octet bytes[] = {1, 2, 3, 4};
  SerializedPayload_t packet;
  packet.data = bytes;
  packet.length = packet.max_size = sizeof bytes;
  IPayloadPool* owner = nullptr;
  CacheChange_t change;
  ASSERT_TRUE(pool.get_payload(packet, owner, change));
  EXPECT_EQ(owner, nullptr);
  EXPECT_EQ(change.serializedPayload.length, 4);
  EXPECT_TRUE(std::equal(std::begin(bytes), std::end(bytes), change.serializedPayload.data));
  EXPECT_TRUE(pool.release_payload(change));
  packet.data = nullptr;
}

TEST(ReceivedSamples, AreNotLargerThanAMessageMayBe) {
  ReceivedSamples pool;
  CacheChange_t change;
  EXPECT_FALSE(pool.get_payload(0xffffffff, change));
  EXPECT_EQ(change.serializedPayload.data, nullptr);
}

TEST(ReceivedSamples, WaitWhereThoseThatArriveHaveNoRoom) {
  ReceivedSamples pool;
  CacheChange_t first, second;
  ASSERT_TRUE(pool.get_payload(ReceivedSamples::kMostArriving, first));
  EXPECT_FALSE(pool.get_payload(1, second));
  EXPECT_TRUE(pool.release_payload(first));
  ASSERT_TRUE(pool.get_payload(1, second));
  EXPECT_TRUE(pool.release_payload(second));
}

}  // namespace pongsim::transport
