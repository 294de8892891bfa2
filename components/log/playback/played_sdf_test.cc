#include "log/playback/played_sdf.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

class PlayedSdfTest : public testing::Test {
 protected:
  /// @return The world that is played from a file with two worlds.
  std::string played(std::string_view world) const {
    return playedSdf("<sdf version='1.9'><world name='a'/><world name='b c'/></sdf>", files_, world);
  }

  test::TempFolder folder_;
  PlayedFiles files_{folder_.write("state.tlog", "")};
};

TEST_F(PlayedSdfTest, IsTheWorldThatWasRecordedOfThoseOfTheFile) {
  const std::string text = played("b_c");
  EXPECT_EQ(text.find("\"a\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"b c\""), std::string::npos) << text;
}

TEST_F(PlayedSdfTest, HasAllWorldsWhereNoneHasTheName) {
  const std::string text = played("d");
  EXPECT_NE(text.find("\"a\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"b c\""), std::string::npos) << text;
}

}  // namespace
}  // namespace pongsim::log
