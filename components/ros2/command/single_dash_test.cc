#include "ros2/command/single_dash.hh"

#include <gtest/gtest.h>

namespace pongsim::ros2 {
namespace {

using Words = std::vector<std::string>;

Words changed(const Words& words) {
  static constexpr std::string_view kWithValue[] = {"world", "string", "x", "Y"};
  static constexpr std::string_view kFlags[] = {"allow_renaming"};
  return withTwoDashes(words, {kWithValue, kFlags});
}

TEST(SingleDash, AnOptionTakesTheNextWordWhateverItIs) {
  EXPECT_EQ(changed({"create", "-world", "w", "-x", "-1.5", "-Y", "-.5"}),
            (Words{"create", "--world=w", "--x=-1.5", "--Y=-.5"}));
  EXPECT_EQ(changed({"--string", "<sdf a='-x'/>", "-world", "-x"}), (Words{"--string=<sdf a='-x'/>", "--world=-x"}));
  EXPECT_EQ(changed({"-world=w", "--x=2", "-string", ""}), (Words{"--world=w", "--x=2", "--string="}));
}

TEST(SingleDash, AnOptionAtTheEndHasNoValue) { EXPECT_EQ(changed({"-world"}), (Words{"--world"})); }

TEST(SingleDash, FlagsAreOnOrOff) {
  EXPECT_EQ(changed({"-allow_renaming", "-x", "1"}), (Words{"--allow_renaming", "--x=1"}));
  EXPECT_EQ(changed({"-allow_renaming=true"}), (Words{"--allow_renaming"}));
  EXPECT_EQ(changed({"-allow_renaming", "true"}), (Words{"--allow_renaming"}));
  EXPECT_EQ(changed({"-allow_renaming", "false"}), (Words{"--allow_renaming"}));
  EXPECT_EQ(changed({"-allow_renaming=false", "--noallow_renaming"}), Words{});
  EXPECT_EQ(changed({"-allow_renaming=perhaps"}), (Words{"-allow_renaming=perhaps"}));
}

TEST(SingleDash, AllElseStays) {
  EXPECT_EQ(changed({"create", "-wrld", "w", "--domain", "5", "-h", "-", "--"}),
            (Words{"create", "-wrld", "w", "--domain", "5", "-h", "-", "--"}));
}

}  // namespace
}  // namespace pongsim::ros2
