#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/camera_world.hh"
#include "support/process.hh"
#include "support/running_world.hh"
#include "support/test_domain.hh"
#include "support/video/decoded_video.hh"
#include "support/working_folder.hh"

namespace pongsim::video {
namespace {

namespace fs = std::filesystem;
using test::RunningWorld;

std::string logRecorder(const std::string& parameters) {
  return "<plugin filename='ignition-gazebo-log-video-recorder-system' "
         "name='ignition::gazebo::systems::LogVideoRecorder'>" +
         parameters + "<width>64</width><height>48</height></plugin>";
}

/// A box that falls, and shines in a colour.
std::string shiningBox(const std::string& name, const std::string& place, const std::string& color) {
  return "<model name='" + name + "'><pose>" + place +
         " 0 0 0</pose><link name='l'><visual name='v'><geometry><box><size>1 1 1</size></box></geometry>"
         "<material><lighting>false</lighting><ambient>" +
         color + "</ambient><diffuse>" + color + "</diffuse></material></visual></link></model>";
}

std::string fallingWith(const std::string& parameters) {
  return "<scene><background>0 1 0 1</background></scene>" + logRecorder(parameters) +
         shiningBox("red", "0 0 20", "1 0 0 1") + shiningBox("blue", "50 0 20", "0 0 1 1");
}

class LogVideo : public test::DrawingTest {
 protected:
  /// @return The statuses of a run.
  static std::vector<std::string> run(const std::string& content, std::uint64_t steps) {
    RunningWorld world(content);
    std::vector<ignition::msgs::StringMsg> statuses;
    world.listen("/log_video_recorder/status", statuses);
    world.step(steps);
    std::vector<std::string> texts;
    for (const ignition::msgs::StringMsg& status : statuses) texts.push_back(status.data());
    return texts;
  }

  /// Expects that the colour of a video is the same from beginning to end, and not only the background.
  static void expectFollowed(const fs::path& file, std::size_t channel, std::size_t frames) {
    const test::DecodedVideo video = test::decodedVideo(file);
    EXPECT_EQ(video.codec, "h264");
    EXPECT_EQ(video.width, 64);
    EXPECT_EQ(video.height, 48);
    ASSERT_EQ(video.frames.size(), frames) << file;
    // at three times its width, a box of 1 m covers more than a twentieth of the picture
    EXPECT_GT(video.frames.front().color[channel], 255 / 20.0);
    EXPECT_NEAR(video.frames.back().color[channel], video.frames.front().color[channel], 3);
    EXPECT_LT(video.frames.back().color[2 - channel], 10);
  }

  test::WorkingFolder folder_;
};

TEST_F(LogVideo, FollowsEachModel) {
  EXPECT_EQ(run(fallingWith("<entity>red</entity><entity>blue</entity><end_time>1</end_time>"), 1200),
            std::vector<std::string>{"end"});
  expectFollowed("red.mp4", 0, 25);
  expectFollowed("blue.mp4", 2, 25);
}

TEST_F(LogVideo, RecordsWhatComesIntoARegion) {
  // a box that has fallen by 1 m at 0.452 s
  const std::string region = "<region><min>-1 -1 -99</min><max>1 1 19</max></region><end_time>1</end_time>";
  run(fallingWith(region), 1200);
  EXPECT_FALSE(fs::exists("blue.mp4"));
  expectFollowed("red.mp4", 0, 14);
  fs::remove("red.mp4");
  run(fallingWith(region + "<start_time>0.761</start_time>"), 1200);
  expectFollowed("red.mp4", 0, 6);
}

TEST_F(LogVideo, CompletesItsFilesAtTheEndOfTheRun) {
  RunningWorld world(fallingWith("<entity>red</entity>"));
  world.step(100);
  EXPECT_FALSE(fs::exists("red.mp4"));
  EXPECT_TRUE(world.simulation().finish());
  EXPECT_EQ(test::decodedVideo("red.mp4").frames.size(), 3U);
}

TEST_F(LogVideo, SaysWhatItCouldNotRecord) {
  std::ofstream("red.mp4") << "precious";
  testing::internal::CaptureStderr();
  RunningWorld world(
      fallingWith("<entity>red</entity><entity>ghost</entity><entity>blue</entity><end_time>0.1</end_time>"));
  world.step(200);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("no video of 'red': 'red.mp4' is there already"), std::string::npos) << said;
  EXPECT_NE(said.find("no video of 'ghost': there has been no such model"), std::string::npos) << said;
  EXPECT_TRUE(fs::exists("blue.mp4"));
  EXPECT_EQ(fs::file_size("red.mp4"), 8U);
  EXPECT_NE(world.simulation().finish().error.find("no video of 'red'"), std::string::npos);
}

TEST_F(LogVideo, NeedsSomethingToRecord) {
  const auto complaint = [](const std::string& parameters) {
    const std::vector<std::string> all = RunningWorld::complaintsAbout(logRecorder(parameters));
    return all.size() == 1 ? all[0] : testing::PrintToString(all);
  };
  EXPECT_EQ(complaint(""), "log-video-recorder is left out: it has no <entity> and no <region>");
  EXPECT_EQ(complaint("<entity>a</entity><start_time>2</start_time><end_time>1</end_time>"),
            "log-video-recorder is left out: <end_time> is before <start_time>");
  EXPECT_EQ(complaint("<region><min>0 0 0</min></region>"), "log-video-recorder is left out: a <region> without <max>");
  EXPECT_NE(complaint("<region><min>0 0 x</min><max>1 1 1</max></region>").find("<min>"), std::string::npos);
}

TEST_F(LogVideo, EndsTheRunWhenItIsToldTo) {
  test::testDomain();
  const fs::path file = folder_.path() / "w.sdf";
  std::ofstream(file) << RunningWorld::textOf(
      fallingWith("<entity>red</entity><end_time>0.2</end_time><exit_on_finish>true</exit_on_finish>"));
  test::Process process({PONGSIM_PROGRAM, "run", file.string()}, {.environment = {}, .folder = folder_.path()});
  EXPECT_EQ(process.wait(), 0) << process.error();
  EXPECT_EQ(test::decodedVideo("red.mp4").frames.size(), 5U);
}

#ifdef HAS_LOG
TEST_F(LogVideo, IsAsLongAsTheRecordingThatIsPlayed) {
  const auto log = [](const std::string& className, const std::string& parameter) {
    return "<plugin filename='ignition-gazebo-log-system' name='ignition::gazebo::systems::" + className + "'>" +
           parameter + "</plugin>";
  };
  {
    std::ofstream("w.sdf") << RunningWorld::textOf(log("LogRecord", "<record_path>rec</record_path>") +
                                                   shiningBox("red", "0 0 20", "1 0 0 1"));
    RunningWorld world(fs::path("w.sdf"));
    world.step(500);
    EXPECT_TRUE(world.simulation().finish());
  }
  // the player says that it pauses at the end
  testing::internal::CaptureStderr();
  Diagnostics diagnostics;
  const auto played =
      Simulation::fromText("<sdf version='1.9'><world name='w'><scene><background>0 1 0 1</background></scene>" +
                               logRecorder("<entity>red</entity>") +
                               log("LogPlayback", "<playback_path>rec</playback_path>") + "</world></sdf>",
                           "played.sdf", {.physics = false}, diagnostics);
  ASSERT_NE(played, nullptr);
  for (const Diagnostic& each : diagnostics.all()) ADD_FAILURE() << format(each);
  EXPECT_FALSE(fs::exists("red.mp4"));
  std::vector<std::string> statuses;
  const Subscription status = played->transport().node().subscribe<ignition::msgs::StringMsg>(
      "/log_video_recorder/status", [&](const auto& message) { statuses.push_back(message.data()); });
  played->step(500);
  played->transport().dispatch();
  EXPECT_TRUE(statuses.empty());
  // as the player asks for
  played->stepPaused();
  played->transport().dispatch();
  EXPECT_EQ(statuses, std::vector<std::string>{"end"});
  testing::internal::GetCapturedStderr();
  expectFollowed("red.mp4", 0, 13);
}
#endif

}  // namespace
}  // namespace pongsim::video
