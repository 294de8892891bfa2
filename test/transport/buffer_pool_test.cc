#include "transport/buffer_pool.hh"

#include <gtest/gtest.h>

namespace pongsim::transport {

TEST(BufferPool, UsesBuffersAgain) {
  BufferPool pool;
  Buffer* buffer = pool.take();
  buffer->users = 2;
  pool.giveBack(buffer);
  EXPECT_NE(pool.take(), buffer);
  pool.giveBack(buffer);
  EXPECT_EQ(pool.take(), buffer);
}

TEST(BufferPool, KeepsNoHugeBuffers) {
  BufferPool pool;
  Buffer* buffer = pool.take();
  buffer->bytes.resize(64 << 20);
  pool.giveBack(buffer);
  EXPECT_LT(pool.take()->bytes.capacity(), 64 << 20);
}

}  // namespace pongsim::transport
