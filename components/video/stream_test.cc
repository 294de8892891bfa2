#include "video/stream.hh"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "support/temp_folder.hh"
#include "support/video/decoded_video.hh"

namespace pongsim::video {
namespace {

constexpr int kSide = 16;
constexpr std::size_t kImageSize = std::size_t{3} * kSide * kSide;

/// What a program writes: an image of one colour for each frame.
std::string streamOf(const std::vector<std::int64_t>& frames) {
  std::string bytes;
  for (const std::int64_t frame : frames) {
    bytes.append(reinterpret_cast<const char*>(&frame), sizeof frame);
    bytes.append(kImageSize, static_cast<char>(20 * frame));
  }
  return bytes;
}

/// Encodes what comes through a pipe.
/// @return Why it is not complete.
std::string encode(const std::string& bytes, const std::filesystem::path& file) {
  Outcome<std::unique_ptr<Encoder>> encoder = Encoder::create(file, {.width = kSide, .height = kSide, .rate = 10});
  EXPECT_TRUE(encoder) << encoder.error;
  int ends[2] = {-1, -1};
  EXPECT_EQ(::pipe(ends), 0);
  std::jthread writer([&] {
    for (const char& byte : bytes) EXPECT_EQ(::write(ends[1], &byte, 1), 1);
    ::close(ends[1]);
  });
  std::string error = encodeStream(ends[0], kImageSize, **encoder).error;
  writer.join();
  ::close(ends[0]);
  return error;
}

test::DecodedVideo videoOf(const std::string& bytes) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "video.mp4";
  EXPECT_EQ(encode(bytes, file), "");
  return test::decodedVideo(file);
}

TEST(VideoStream, ShowsEachImageInItsFrame) {
  const test::DecodedVideo video = videoOf(streamOf({0, 1, 4}));
  ASSERT_EQ(video.frames.size(), 3U);
  EXPECT_NEAR(video.frames[1].time - video.frames[0].time, 0.1, 1e-6);
  EXPECT_NEAR(video.frames[2].time - video.frames[0].time, 0.4, 1e-6);
  EXPECT_NEAR(video.frames[2].color[0], 80, 4);
}

TEST(VideoStream, IsCompleteWhereTheLastImageIsCutOff) {
  EXPECT_EQ(videoOf(streamOf({0, 1, 2}).substr(0, 3 * (8 + kImageSize) - 1)).frames.size(), 2U);
}

TEST(VideoStream, MakesNoVideoWithoutPictures) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "video.mp4";
  EXPECT_EQ(encode("", file), "'" + file.string() + "' would have no pictures");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace pongsim::video
