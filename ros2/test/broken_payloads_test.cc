// What anybody may send, read as each type: it is refused or read, and nothing else happens.
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "ros2/test/all_types.hh"
#include "ros2/types/cdr.hh"

namespace pongsim::ros2::test {
namespace {

constexpr std::size_t kEncapsulation = 4;

/// A payload of small numbers, so that counts of elements may well be right.
std::vector<std::byte> somePayload(std::mt19937& chance) {
  std::vector<std::byte> payload(kEncapsulation + 400);
  payload[1] = std::byte{1};
  for (std::size_t i = kEncapsulation; i < payload.size(); i += 4) payload[i] = static_cast<std::byte>(chance() % 3);
  return payload;
}

TEST(BrokenPayloads, AreRefusedWhereverTheyEnd) {
  forAllTypes([]<class Type>() {
    const std::vector<std::byte> whole = toCdr(Type());
    for (std::size_t size = 0; size < whole.size(); ++size) {
      Type value;
      EXPECT_TRUE(readCdr(std::span(whole).first(size), value).has_value()) << nameOf<Type>() << ", " << size;
    }
  });
}

TEST(BrokenPayloads, ClaimNoMoreMemoryThanTheyHave) {
  forAllTypes([]<class Type>() {
    // each number of the payload says four thousand million in turn
    const std::vector<std::byte> whole = toCdr(Type());
    for (std::size_t at = kEncapsulation; at + 4 <= whole.size(); at += 4) {
      std::vector<std::byte> payload = whole;
      const std::uint32_t many = 4'000'000'000;
      std::memcpy(&payload[at], &many, sizeof many);
      Type value;
      readCdr(payload, value);
      EXPECT_LE(toCdr(value).size(), 64 * payload.size()) << nameOf<Type>();
    }
  });
}

TEST(BrokenPayloads, OfAnyBytesDoNoHarm) {
  std::mt19937 chance(7);
  forAllTypes([&chance]<class Type>() {
    for (int i = 0; i < 100; ++i) {
      std::vector<std::byte> payload = somePayload(chance);
      payload.resize(chance() % payload.size());
      for (std::size_t j = chance() % 8; j > 0 && !payload.empty(); --j) {
        payload[chance() % payload.size()] = static_cast<std::byte>(chance());
      }
      Type value;
      if (!readCdr(payload, value)) {
        // what was read can be written
        EXPECT_EQ(toCdr(value).size(), cdrSize(value));
      }
    }
  });
}

}  // namespace
}  // namespace pongsim::ros2::test
