#include "pongsim/program/nearest_word.hh"

#include <gtest/gtest.h>

namespace pongsim {
namespace {

constexpr std::string_view kJoints[] = {"left_wheel_joint", "right_wheel_joint", "caster_wheel", "x"};

TEST(NearestWord, FindsAMissingASwappedAndAWrongLetter) {
  EXPECT_EQ(nearestWord("left_weel_joint", kJoints), "left_wheel_joint");
  EXPECT_EQ(nearestWord("rigth_wheel_joint", kJoints), "right_wheel_joint");
  EXPECT_EQ(nearestWord("kaster_wheel", kJoints), "caster_wheel");
  EXPECT_EQ(nearestWord("xx", kJoints), "x");
}

TEST(NearestWord, TakesCaseLightly) { EXPECT_EQ(nearestWord("CASTER_WHEEL", kJoints), "caster_wheel"); }

TEST(NearestWord, FindsNothingWhereNothingIsNear) {
  EXPECT_EQ(nearestWord("antenna", kJoints), "");
  EXPECT_EQ(nearestWord("y", kJoints), "");
  EXPECT_EQ(nearestWord("", kJoints), "");
  EXPECT_EQ(nearestWord(std::string(100'000, 'a'), kJoints), "");
}

TEST(DidYouMean, IsAQuestionOrNothing) {
  EXPECT_EQ(didYouMean("caster_wheal", kJoints), "did you mean 'caster_wheel'?");
  EXPECT_EQ(didYouMean("antenna", kJoints), "");
}

}  // namespace
}  // namespace pongsim
