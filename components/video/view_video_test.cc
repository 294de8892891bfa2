#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "support/process.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"
#include "support/video/decoded_video.hh"
#include "support/wait_until.hh"

namespace pongsim::video {
namespace {

namespace fs = std::filesystem;

/// A green world in which a red box, as wide as the picture, falls out of it within 0.53 s.
constexpr const char* kWorld = R"(<sdf version='1.9'><world name='w'>
  <scene><background>0 1 0 1</background></scene>
  <model name='box'><pose>3 0 0 0 0 0</pose><link name='l'>
    <visual name='v'><geometry><box><size>0.1 4 1</size></box></geometry>
      <material><lighting>false</lighting><ambient>1 0 0 1</ambient><diffuse>1 0 0 1</diffuse></material></visual>
  </link></model></world></sdf>)";

/// `pongsim view` of that world.
class ViewVideo : public testing::Test {
 protected:
  /// @return Its exit code.
  int view(std::vector<std::string> arguments, bool isOfFile = true) {
    test::testDomain();
    std::vector<std::string> words{PONGSIM_PROGRAM, "view"};
    if (isOfFile) words.push_back(folder_.write("w.sdf", kWorld).string());
    words.insert(words.end(), arguments.begin(), arguments.end());
    for (const char* word : {"--camera", "0 0 0 0 0 0", "--size", "64x32"}) words.emplace_back(word);
    test::Process process(words, {.environment = {}, .folder = folder_.path()});
    const int code = process.wait().value_or(-1);
    error_ = process.error();
    return code;
  }

  const test::TempFolder folder_;
  std::string error_;
};

TEST_F(ViewVideo, ShowsTheWorldAsItGoesOn) {
  ASSERT_EQ(view({"--video", "fall.mp4", "--for", "1"}), 0) << error_;
  EXPECT_EQ(error_, "pongsim: fall.mp4: 64 x 32 pixels, 25 pictures\n");
  const test::DecodedVideo video = test::decodedVideo(folder_.path() / "fall.mp4");
  EXPECT_EQ(video.codec, "h264");
  ASSERT_EQ(video.frames.size(), 25U);
  EXPECT_NEAR(video.frames[24].time - video.frames[0].time, 0.96, 1e-6);
  // half of the height at 3 m is 0.87 m
  EXPECT_GT(video.frames[0].color[0], 130);
  EXPECT_LT(video.frames[24].color[0], 20);
  // at 0.32 s it has fallen by 0.5 m
  EXPECT_NEAR(video.frames[8].color[0], 255 * (0.87 - 0.5 + 0.5) / (2 * 0.87), 40);
}

TEST_F(ViewVideo, FollowsAModel) {
  ASSERT_EQ(view({"--video", "follow.avi", "--for", "1", "--follow", "box"}), 0) << error_;
  const test::DecodedVideo video = test::decodedVideo(folder_.path() / "follow.avi");
  ASSERT_EQ(video.frames.size(), 25U);
  for (const auto& frame : video.frames) EXPECT_NEAR(frame.color[0], video.frames[0].color[0], 10) << frame.time;
}

TEST_F(ViewVideo, TurnsAroundAModel) {
  ASSERT_EQ(view({"--video", "orbit.mp4", "--for", "1", "--follow", "box", "--orbit"}), 0) << error_;
  const test::DecodedVideo video = test::decodedVideo(folder_.path() / "orbit.mp4");
  ASSERT_EQ(video.frames.size(), 25U);
  // from the side it is narrow
  EXPECT_LT(video.frames[6].color[0], video.frames[0].color[0] / 2);
  EXPECT_NEAR(video.frames[12].color[0], video.frames[0].color[0], 20);
}

TEST_F(ViewVideo, SaysWhatIsWrong) {
  EXPECT_EQ(view({"--video", "fall.gif"}), 1);
  EXPECT_EQ(error_, "pongsim: error: 'fall.gif' ends in none of .mp4, .avi and .ogv\n");
  ASSERT_EQ(view({"--video", "fall.mp4", "--for", "0.04"}), 0) << error_;
  EXPECT_EQ(view({"--video", "fall.mp4", "--for", "0.04"}), 1);
  EXPECT_NE(error_.find("fall.mp4' is there already"), std::string::npos) << error_;
  EXPECT_EQ(view({"--video", "a.mp4", "--follow", "bax"}), 1);
  EXPECT_EQ(error_, "pongsim: error: there is no model or actor 'bax' to look at\n  hint: did you mean 'box'?\n");
  EXPECT_FALSE(fs::exists(folder_.path() / "a.mp4"));
  EXPECT_EQ(view({"--orbit"}), 2);
  EXPECT_EQ(view({"--video", "a.mp4", "--terminal"}), 2);
  EXPECT_EQ(view({"--video", "a.mp4", "--for", "-1"}), 2);
  EXPECT_EQ(view({"--video", "a.mp4", "--depth", "--labels"}), 2);
}

TEST_F(ViewVideo, ShowsARunningWorld) {
  // before the camera for half of the time
  const std::string world = std::string(kWorld).substr(0, std::string(kWorld).find("<model")) + R"(<actor name='a'>
    <link name='l'><visual name='v'><geometry><box><size>0.1 4 4</size></box></geometry><material>
      <lighting>false</lighting><ambient>1 0 0 1</ambient><diffuse>1 0 0 1</diffuse></material></visual></link>
    <script><trajectory id='0' type='walk' tension='1'>
      <waypoint><time>0</time><pose>3 0 0 0 0 0</pose></waypoint>
      <waypoint><time>0.5</time><pose>3 0 0 0 0 0</pose></waypoint>
      <waypoint><time>0.51</time><pose>3 0 90 0 0 0</pose></waypoint>
      <waypoint><time>1</time><pose>3 0 90 0 0 0</pose></waypoint>
    </trajectory></script></actor></world></sdf>)";
  test::testDomain();
  test::Process run({PONGSIM_PROGRAM, "run", folder_.write("a.sdf", world).string()});
  ASSERT_TRUE(run.waitForError("pongsim: world '")) << run.error();
  ASSERT_EQ(view({"--video", "now.mp4", "--for", "3", "--timeout", "60000"}, false), 0) << error_;
  const test::DecodedVideo video = test::decodedVideo(folder_.path() / "now.mp4");
  const auto isRed = [](const test::DecodedVideo::Frame& frame) { return frame.color[0] > frame.color[1]; };
  EXPECT_TRUE(std::ranges::any_of(video.frames, isRed));
  EXPECT_FALSE(std::ranges::all_of(video.frames, isRed));
  EXPECT_LT(video.frames.back().time, 3.1);

  EXPECT_EQ(view({"--thermal"}, false), 2);
  EXPECT_EQ(view({"--labels"}, false), 2);
}

TEST_F(ViewVideo, OfARunningWorldEndsWithIt) {
  test::testDomain();
  test::Process run({PONGSIM_PROGRAM, "run", folder_.write("w.sdf", kWorld).string()});
  ASSERT_TRUE(run.waitForError("pongsim: world '")) << run.error();
  const fs::path video = folder_.path() / "cut.mp4";
  test::Process view({PONGSIM_PROGRAM, "view", "--video", video.string(), "--for", "3600", "--timeout", "10000",
                      "--camera", "0 0 0 0 0 0", "--size", "64x32"});
  // the first pictures are in it
  ASSERT_TRUE(test::waitUntil([&] {
    std::error_code error;
    const auto size = fs::file_size(video.string() + ".part", error);
    return !error && size > 0;
  })) << view.error();
  run.kill(SIGINT);
  EXPECT_EQ(view.wait(), 1);
  EXPECT_TRUE(view.error().starts_with("pongsim: error: world 'w' has ended\npongsim: " + video.string() + ": 64 x 32"))
      << view.error();
  EXPECT_FALSE(test::decodedVideo(video).frames.empty());
}

}  // namespace
}  // namespace pongsim::video
