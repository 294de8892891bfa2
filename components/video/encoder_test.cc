#include "video/encoder.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/temp_folder.hh"
#include "support/video/decoded_video.hh"

namespace pongsim::video {
namespace {

namespace fs = std::filesystem;

using Color = std::array<int, 3>;
constexpr std::array<Color, 4> kColors{{{220, 30, 40}, {30, 200, 60}, {40, 50, 210}, {128, 128, 128}}};

std::vector<std::uint8_t> plain(const VideoSettings& settings, const Color& color) {
  std::vector<std::uint8_t> image;
  for (int i = 0; i < settings.width * settings.height; ++i) {
    for (const int each : color) image.push_back(static_cast<std::uint8_t>(each));
  }
  return image;
}

/// Each colour for two frames.
void encodeColors(const fs::path& place, const VideoSettings& settings) {
  Outcome<std::unique_ptr<Encoder>> encoder = Encoder::create(place, settings);
  ASSERT_TRUE(encoder) << encoder.error;
  for (std::size_t i = 0; i < kColors.size(); ++i) {
    EXPECT_EQ((*encoder)->add(static_cast<std::int64_t>(2 * i), plain(settings, kColors[i])).error, "");
  }
  EXPECT_EQ((*encoder)->complete().error, "");
}

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Formats : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Formats, ShowTheImagesAtTheirTimes) {
  const test::TempFolder folder;
  const fs::path file = folder.path() / "video";
  encodeColors(file, {.width = 64, .height = 48, .format = GetParam().first, .rate = 20});
  const test::DecodedVideo video = test::decodedVideo(file);
  EXPECT_EQ(video.codec, GetParam().second);
  EXPECT_EQ(video.width, 64);
  EXPECT_EQ(video.height, 48);
  for (std::size_t i = 0; i < kColors.size(); ++i) {
    const double time = video.frames.at(0).time + 0.1 * static_cast<double>(i);
    const auto shown = std::ranges::find_if(
        video.frames, [time](const test::DecodedVideo::Frame& frame) { return std::abs(frame.time - time) < 1e-6; });
    ASSERT_NE(shown, video.frames.end()) << time;
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(shown->color[c], kColors[i][c], 6) << i;
  }
  EXPECT_NEAR(video.frames.back().time - video.frames[0].time, 0.3, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(All, Formats,
                         testing::Values(std::pair{"mp4", "h264"}, std::pair{"avi", "mpeg4"},
                                         std::pair{"ogv", "theora"}));

TEST(Encoder, WritesTheSameBytesForTheSameImages) {
  const test::TempFolder folder;
  for (const char* name : {"a", "b"}) encodeColors(folder.path() / name, {.width = 64, .height = 48});
  EXPECT_GT(bytesOf(folder.path() / "a").size(), 500U);
  EXPECT_EQ(bytesOf(folder.path() / "a"), bytesOf(folder.path() / "b"));
}

TEST(Encoder, LeavesOutTheLastRowAndColumnOfOddImages) {
  const test::TempFolder folder;
  encodeColors(folder.path() / "a", {.width = 35, .height = 17});
  const test::DecodedVideo video = test::decodedVideo(folder.path() / "a");
  EXPECT_EQ(video.width, 34);
  EXPECT_EQ(video.height, 16);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(video.frames.at(1).color[c], kColors[1][c], 6);
}

TEST(Encoder, ReadsAllPixels) {
  const test::TempFolder folder;
  for (const auto& [pixels, bytes] : {std::pair{Pixels::kGrey, std::vector<std::uint8_t>{77}},
                                      {Pixels::kGrey16, {0, 77}},
                                      {Pixels::kBgr, {77, 77, 77}}}) {
    const VideoSettings settings{.width = 32, .height = 32, .pixels = pixels};
    const fs::path file = folder.path() / std::to_string(static_cast<int>(pixels));
    Outcome<std::unique_ptr<Encoder>> encoder = Encoder::create(file, settings);
    ASSERT_TRUE(encoder) << encoder.error;
    std::vector<std::uint8_t> image;
    for (int i = 0; i < 32 * 32; ++i) image.insert(image.end(), bytes.begin(), bytes.end());
    EXPECT_TRUE((*encoder)->add(0, image));
    EXPECT_TRUE((*encoder)->complete());
    EXPECT_NEAR(test::decodedVideo(file).frames.at(0).color[0], 77, 4);
  }
}

TEST(Encoder, RefusesWhatIsNoVideo) {
  const test::TempFolder folder;
  EXPECT_EQ(Encoder::create(folder.path() / "a", {.width = 1, .height = 48}).error,
            "a video has at least 2 x 2 pixels");
  EXPECT_EQ(Encoder::create(folder.path() / "a", {.width = 8, .height = 8, .format = "gif"}).error,
            "there is no video format 'gif'");
  const VideoSettings settings{.width = 64, .height = 48};
  Outcome<std::unique_ptr<Encoder>> encoder = Encoder::create(folder.path() / "b", settings);
  EXPECT_EQ((*encoder)->add(0, plain({.width = 8, .height = 8}, kColors[0])).error, "an image has too few pixels");
}

}  // namespace
}  // namespace pongsim::video
