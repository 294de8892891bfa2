#include "pongsim/control/pid.hh"

#include <gtest/gtest.h>

#include <limits>

#include "pongsim/declaration.hh"

namespace pongsim {
namespace {

TEST(Pid, TakesTheErrorBackInProportion) {
  Pid pid({.p = 2, .commandOffset = 1});
  EXPECT_EQ(pid.update(3, 0.1), 1 - 6);
}

TEST(Pid, SumsUpTheError) {
  Pid pid({.i = 2, .iMin = -1, .iMax = 1});
  EXPECT_DOUBLE_EQ(pid.update(1, 0.1), -0.2);
  EXPECT_DOUBLE_EQ(pid.update(1, 0.1), -0.4);
  for (int i = 0; i < 10; ++i) pid.update(1, 0.1);
  EXPECT_EQ(pid.update(1, 0.1), -1);
  pid.reset();
  EXPECT_DOUBLE_EQ(pid.update(1, 0.1), -0.2);
}

TEST(Pid, HoldsAgainstTheChangeOfTheError) {
  Pid pid({.d = 0.5});
  EXPECT_DOUBLE_EQ(pid.update(1, 0.1), -5);
  EXPECT_DOUBLE_EQ(pid.update(1, 0.1), 0);
  EXPECT_DOUBLE_EQ(pid.update(0.8, 0.1), 1);
}

TEST(Pid, KeepsItsCommandWithinBoundsUnlessTheyAreTheWrongWayRound) {
  EXPECT_EQ(Pid({.p = 10, .commandMin = -2, .commandMax = 3}).update(-1, 0.1), 3);
  EXPECT_EQ(Pid({.p = 10, .commandMin = -2, .commandMax = 3}).update(1, 0.1), -2);
  EXPECT_EQ(Pid({.p = 10, .commandMin = 0, .commandMax = -1}).update(1, 0.1), -10);
}

TEST(Pid, DoesNothingWithoutTimeOrWithoutAnError) {
  Pid pid({.p = 10, .commandOffset = 5});
  EXPECT_EQ(pid.update(1, 0), 0);
  EXPECT_EQ(pid.update(std::numeric_limits<double>::quiet_NaN(), 0.1), 0);
}

TEST(Pid, ReadsItsSettings) {
  Element sdf;
  for (const auto& [name, text] : {std::pair("a_p_gain", "3"), std::pair("a_cmd_max", "7"), std::pair("p_gain", "9")}) {
    sdf.children.emplace_back();
    sdf.children.back().name = name;
    sdf.children.back().text = text;
  }
  PidSettings prefixed{.i = 2}, bare;
  Declaration declaration;
  declarePid(declaration, prefixed, "N m", "a_");
  declarePid(declaration, bare, "N m");
  Diagnostics diagnostics;
  EXPECT_TRUE(declaration.read(sdf, "pid", diagnostics));
  EXPECT_EQ(prefixed.p, 3);
  EXPECT_EQ(prefixed.i, 2);
  EXPECT_EQ(prefixed.commandMax, 7);
  EXPECT_EQ(bare.p, 9);
  sdf.children[0].text = "nan";
  EXPECT_FALSE(declaration.read(sdf, "pid", diagnostics));
}

}  // namespace
}  // namespace pongsim
