#include "base/arena.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pongsim::base {
namespace {

std::uintptr_t addressOf(const void* memory) { return reinterpret_cast<std::uintptr_t>(memory); }

TEST(Arena, GivesObjectsMemoryOfTheirOwnCloseTogether) {
  Arena arena;
  // more than one block of 2 MiB
  std::vector<std::uintptr_t> places;
  for (int i = 0; i < 5000; ++i) {
    void* const memory = arena.allocate(1000);
    std::memset(memory, 255, 1000);
    places.push_back(addressOf(memory));
    EXPECT_EQ(places.back() % Arena::kAlignment, 0U);
  }
  EXPECT_EQ(places[1] - places[0], 1024U);
  std::ranges::sort(places);
  for (std::size_t i = 1; i < places.size(); ++i) ASSERT_GE(places[i] - places[i - 1], 1000U);
}

TEST(Arena, UsesFreedMemoryAgainForTheSameSize) {
  Arena arena;
  void* const small = arena.allocate(100);
  void* const large = arena.allocate(500);
  arena.free(small, 100);
  EXPECT_NE(arena.allocate(500), small);
  EXPECT_EQ(arena.allocate(120), small);
  arena.free(large, 500);
  EXPECT_EQ(arena.allocate(500), large);
}

TEST(Arena, RefusesWhatIsTooLarge) {
  Arena arena;
  EXPECT_NE(arena.allocate(Arena::kLargest), nullptr);
  EXPECT_THROW(arena.allocate(Arena::kLargest + 1), std::bad_alloc);
}

TEST(Arena, MakesObjectsAndFreesTheirMemory) {
  Arena arena;
  const auto counted = std::make_shared<int>(7);
  struct Holder {
    explicit Holder(std::shared_ptr<int> number) : held(std::move(number)) {}
    std::shared_ptr<int> held;
  };
  Arena::Pointer<Holder> holder = arena.make<Holder>(counted);
  EXPECT_EQ(*holder->held, 7);
  EXPECT_EQ(counted.use_count(), 2);
  const std::uintptr_t place = addressOf(holder.get());
  holder.reset();
  EXPECT_EQ(counted.use_count(), 1);
  EXPECT_EQ(addressOf(arena.make<Holder>(counted).get()), place);
}

TEST(Arena, FreesTheMemoryOfWhatCannotBeMade) {
  Arena arena;
  struct Refusing {
    explicit Refusing(bool refuses) {
      if (refuses) throw std::invalid_argument("not this one");
    }
    double number = 1;
  };
  const std::uintptr_t place = addressOf(arena.make<Refusing>(false).get());
  EXPECT_THROW(arena.make<Refusing>(true), std::invalid_argument);
  EXPECT_EQ(addressOf(arena.make<Refusing>(false).get()), place);
}

}  // namespace
}  // namespace pongsim::base
