#include "ign/payload.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pongsim::ign {
namespace {

TEST(Payload, IsCountedUntilItsBytesAreFreed) {
  const std::size_t before = Payload::total();
  char* given = nullptr;
  {
    Payload payload(1000);
    EXPECT_EQ(payload.bytes().size(), 1000U);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(payload.bytes().data()) % alignof(std::max_align_t), 0U);
    std::ranges::fill(payload.bytes(), std::byte('x'));
    EXPECT_EQ(Payload::total(), before + 1000);
    Payload other(std::move(payload));
    EXPECT_EQ(Payload::total(), before + 1000);
    given = other.release();
  }
  EXPECT_EQ(Payload::total(), before + 1000);
  EXPECT_EQ(std::count(given, given + 1000, 'x'), 1000);
  Payload::free(given, nullptr);
  EXPECT_EQ(Payload::total(), before);
}

TEST(Payload, MayBeEmpty) {
  const std::size_t before = Payload::total();
  { const Payload payload(0); }
  EXPECT_EQ(Payload::total(), before);
}

}  // namespace
}  // namespace pongsim::ign
