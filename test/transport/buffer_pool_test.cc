#include "transport/buffer_pool.hh"

#include <gtest/gtest.h>

namespace pongsim::transport {

TEST(BufferPool, UsesBuffersAgain) {
  BufferPool pool;
  Buffer* buffer = pool.take(1000);
  EXPECT_EQ(buffer->bytes.size(), 1000);
  buffer->users = 2;
  pool.giveBack(buffer);
  EXPECT_NE(pool.take(1000), buffer);
  pool.giveBack(buffer);
  Buffer* again = pool.take(1024);
  EXPECT_EQ(again, buffer);
  EXPECT_EQ(again->bytes.size(), 1024);
}

TEST(BufferPool, PutsNothingSmallIntoWhatIsLarge) {
  BufferPool pool;
  Buffer* buffer = pool.take(1 << 20);
  pool.giveBack(buffer);
  EXPECT_NE(pool.take(8), buffer);
  EXPECT_EQ(pool.take((1 << 19) + 1), buffer);
}

TEST(BufferPool, KeepsNoHugeBuffers) {
  BufferPool pool;
  Buffer* buffer = pool.take(64 << 20);
  // gone with its room, or still the pool's: nobody else's
  pool.giveBack(buffer);
  Buffer* small = pool.take(0);
  EXPECT_TRUE(small->bytes.empty());
  EXPECT_LT(small->capacity(), 1024);
}

TEST(Buffer, ExchangesItsBytesAndNothingElse) {
  BufferPool pool;
  Buffer* one = pool.take(3);
  Buffer* other = pool.take(700);
  one->sender = {1};
  const auto* bytes = one->bytes.data();
  one->swapBytes(*other);
  EXPECT_EQ(one->bytes.size(), 700);
  EXPECT_EQ(one->sender, ParticipantId{1});
  EXPECT_EQ(other->bytes.data(), bytes);
  EXPECT_EQ(other->sender, ParticipantId{});
}

}  // namespace pongsim::transport
