#include "video/recording.hh"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "support/temp_folder.hh"
#include "support/video/decoded_video.hh"

namespace pongsim::video {
namespace {

const VideoSettings kSettings{.width = 64, .height = 48};

/// @return An image of one grey.
std::string grey(char brightness) { return std::string(std::size_t{3} * 64 * 48, brightness); }

TEST(Recording, EncodesAllImagesInTheirOrder) {
  const test::TempFolder folder;
  Outcome<std::unique_ptr<Encoder>> encoder = Encoder::create(folder.path() / "a", kSettings);
  ASSERT_TRUE(encoder);
  Recording recording(std::move(*encoder));
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(recording.add(i, grey(static_cast<char>(40 + i))));
  EXPECT_TRUE(recording.complete());
  const test::DecodedVideo video = test::decodedVideo(folder.path() / "a");
  ASSERT_EQ(video.frames.size(), 40U);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(video.frames[i].color[0], 40 + static_cast<double>(i), 4);
}

TEST(Recording, SaysThatAnImageCantBeEncoded) {
  const test::TempFolder folder;
  Outcome<std::unique_ptr<Encoder>> encoder = Encoder::create(folder.path() / "a", kSettings);
  ASSERT_TRUE(encoder);
  {
    Recording recording(std::move(*encoder));
    EXPECT_TRUE(recording.add(0, "too short"));
    EXPECT_EQ(recording.complete().error, "an image has too few pixels");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace pongsim::video
