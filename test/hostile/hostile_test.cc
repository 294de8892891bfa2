// Well-formed but hostile messages do a world no lasting harm.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "hostile/attacker.hh"
#include "hostile/siege.hh"

namespace pongsim::hostile {
namespace {

#ifdef __SANITIZE_ADDRESS__
// the sanitizer keeps this much of the freed memory
constexpr std::uint64_t kSomeMemory = (100 + 256) << 20;
#else
constexpr std::uint64_t kSomeMemory = 100 << 20;
#endif

class Hostile : public testing::TestWithParam<std::pair<std::string_view, Attack>> {};

TEST_P(Hostile, NeighboursAreBorne) {
  Siege siege;
  const Figures figures =
      siege.attack({"--rate", "10000", std::string(GetParam().first)}, std::chrono::milliseconds(2000));
  EXPECT_LT(figures.memoryMost, figures.memoryBefore + kSomeMemory);
  EXPECT_LT(figures.memoryAfter, figures.memoryBefore + kSomeMemory);
  EXPECT_GT(figures.steps, 0U) << "the world is not heard";
  EXPECT_GT(figures.messages, 0U) << "the publisher is not heard";
  EXPECT_TRUE(figures.isHeardAfterwards);
  EXPECT_TRUE(figures.isListedAsBefore) << "somebody is left who never was";
  EXPECT_EQ(figures.threadsAfter, figures.threadsBefore);
  EXPECT_EQ(figures.descriptorsAfter, figures.descriptorsBefore);
  EXPECT_TRUE(siege.endsWell()) << siege.complaints();
}

INSTANTIATE_TEST_SUITE_P(Of, Hostile, testing::ValuesIn(attacks().begin(), attacks().end()), [](const auto& tested) {
  std::string name(tested.param.first);
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace pongsim::hostile
