#include "shared/threads/buffer_pool.hh"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace pongsim::shared {

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

TEST(BufferPool, FreesWhatABurstNeeded) {
  BufferPool pool;
  const auto burst = [&pool](std::size_t count) {
    std::vector<Buffer*> taken;
    for (std::size_t i = 0; i < count; ++i) taken.push_back(pool.take(i % 2 == 0 ? 16'000 : 1'000));
    for (Buffer* each : taken) pool.giveBack(each);
  };
  burst(1'000);
  EXPECT_EQ(pool.spareBytes(), 500 * (16'384 + 1'024));
  // a steady flow, of which two messages are under way at once
  constexpr std::size_t kFlow = 2 * (16'384 + 1'024);
  for (std::size_t i = 0; i < 12 * BufferPool::kPeriod; i += 4) burst(4);
  EXPECT_EQ(pool.spareBytes(), kFlow);

  std::vector<Buffer*> kept;
  for (int i = 0; i < 2; ++i) kept.insert(kept.end(), {pool.take(16'000), pool.take(1'000)});
  EXPECT_EQ(pool.spareBytes(), 0) << "the flow's own buffers are there";
  for (Buffer* each : kept) pool.giveBack(each);
}

TEST(BufferPool, FreesNothingThatAFlowUsesNowAndThen) {
  BufferPool pool;
  std::vector<Buffer*> taken;
  for (int period = 0; period < 5; ++period) {
    for (int i = 0; i < 100; ++i) taken.push_back(pool.take(5'000));
    for (Buffer* each : taken) pool.giveBack(each);
    taken.clear();
    for (std::size_t i = 0; i < BufferPool::kPeriod / 2; ++i) pool.giveBack(pool.take(10));
    EXPECT_GE(pool.spareBytes(), 100 * 8'192);
  }
}

TEST(Buffer, ExchangesItsBytesAndNothingElse) {
  BufferPool pool;
  Buffer* one = pool.take(3);
  Buffer* other = pool.take(700);
  one->sender = {1};
  const auto* bytes = one->bytes.data();
  one->swapBytes(*other);
  EXPECT_EQ(one->bytes.size(), 700);
  EXPECT_EQ(one->sender, decltype(one->sender){1});
  EXPECT_EQ(other->bytes.data(), bytes);
  EXPECT_EQ(other->sender, decltype(other->sender){});
}

}  // namespace pongsim::shared
