#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/time.pb.h>
#include <ignition/msgs/video_record.pb.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/ask_service.hh"
#include "support/camera_world.hh"
#include "support/file_size_limit.hh"
#include "support/fortress_worlds.hh"
#include "support/running_world.hh"
#include "support/video/decoded_video.hh"
#include "support/working_folder.hh"

namespace pongsim::video {
namespace {

namespace fs = std::filesystem;
using test::RunningWorld;

constexpr const char* kService = "/world/w/model/m/link/l/sensor/s/record_video";

std::string recorder(const std::string& parameters = "<use_sim_time>true</use_sim_time>") {
  return "<plugin filename='ignition-gazebo-camera-video-recorder-system' "
         "name='ignition::gazebo::systems::CameraVideoRecorder'>" +
         parameters + "</plugin>";
}

/// @param ofSensor Elements of the camera's `<sensor>`.
/// @param ofCamera Elements of its `<camera>`.
std::string worldWith(const std::string& ofSensor, const std::string& ofCamera = "") {
  return "<scene><background>0.2 0.8 0.4 1</background><ambient>1 1 1 1</ambient></scene>" +
         std::string(test::kSensorsSystem) +
         test::smallCamera("camera", ofCamera, "<update_rate>25</update_rate>" + ofSensor);
}

class VideoRecorder : public test::DrawingTest {
 protected:
  /// @return Why the request was refused; empty if it was not.
  static std::string ask(RunningWorld& world, bool starts, const std::string& file = "",
                         const std::string& service = kService, const std::string& format = "") {
    ignition::msgs::VideoRecord request;
    request.set_start(starts);
    request.set_stop(!starts);
    request.set_save_filename(file);
    request.set_format(format);
    ignition::msgs::Boolean reply;
    const CallResult result = test::askService(world.simulation().transport(), service, request, reply);
    EXPECT_EQ(static_cast<bool>(result), reply.data());
    return test::refusalOf(result);
  }

  static std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  test::WorkingFolder folder_;
};

TEST_F(VideoRecorder, RecordsWhatTheCameraSees) {
  RunningWorld world(worldWith(recorder()));
  std::vector<ignition::msgs::Time> lengths;
  world.listen("/cam/stats", lengths);
  world.step(100);
  EXPECT_EQ(ask(world, true, "videos/a.mp4"), "");
  world.step(1000);
  EXPECT_FALSE(fs::exists("videos/a.mp4"));
  EXPECT_EQ(ask(world, false), "");
  const test::DecodedVideo video = test::decodedVideo("videos/a.mp4");
  EXPECT_EQ(video.codec, "h264");
  EXPECT_EQ(video.width, 64);
  EXPECT_EQ(video.height, 48);
  ASSERT_EQ(video.frames.size(), 25U);
  EXPECT_NEAR(video.frames.back().time, 0.96, 1e-6);
  const std::vector<double> color{0.2 * 255, 0.8 * 255, 0.4 * 255};
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(video.frames[12].color[c], color[c], 5);
  ASSERT_EQ(lengths.size(), 25U);
  EXPECT_EQ(lengths.back().nsec(), 960'000'000);
  // the camera is not read any more
  world.step(1000);
  EXPECT_EQ(lengths.size(), 25U);
}

TEST_F(VideoRecorder, WritesTheSameBytesForTheSameRun) {
  const std::string noise = "<noise><type>gaussian</type><mean>0</mean><stddev>0.1</stddev></noise>";
  for (const char* file : {"a.mp4", "b.mp4"}) {
    RunningWorld world(worldWith(recorder(), noise));
    EXPECT_EQ(ask(world, true, file), "");
    world.step(300);
    EXPECT_EQ(ask(world, false), "");
  }
  EXPECT_GT(bytesOf("a.mp4").size(), 1000U);
  EXPECT_EQ(bytesOf("a.mp4"), bytesOf("b.mp4"));
}

TEST_F(VideoRecorder, GoesOnWhereTheWorldIsReset) {
  RunningWorld world(worldWith(recorder()));
  EXPECT_EQ(ask(world, true, "a.mp4"), "");
  world.step(400);
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  world.step(400);
  EXPECT_EQ(ask(world, false), "");
  EXPECT_GE(test::decodedVideo("a.mp4").frames.size(), 19U);
}

TEST_F(VideoRecorder, CompletesItsFileAtTheEndOfTheRun) {
  RunningWorld world(worldWith(recorder("")));
  EXPECT_EQ(ask(world, true), "");
  world.step(100);
  EXPECT_TRUE(world.simulation().finish());
  std::vector<std::string> names;
  for (const auto& each : fs::directory_iterator(folder_.path())) names.push_back(each.path().filename());
  ASSERT_EQ(names.size(), 1U);
  EXPECT_TRUE(names[0].starts_with("m_l_s_20")) << names[0];
  EXPECT_TRUE(names[0].ends_with(".mp4")) << names[0];
}

TEST_F(VideoRecorder, WritesNothingElsewhere) {
  RunningWorld world(worldWith(recorder()));
  std::ofstream("there.mp4") << "precious";
  const std::string here = fs::canonical(folder_.path()).string();
  EXPECT_EQ(ask(world, true, "../a.mp4"), "'../a.mp4' is not in '" + here + "', where videos are written");
  EXPECT_EQ(ask(world, true, "/tmp/a.mp4"), "'/tmp/a.mp4' is not in '" + here + "', where videos are written");
  EXPECT_EQ(ask(world, true, "there.mp4"), "'there.mp4' is there already");
  EXPECT_EQ(ask(world, true, "a.sh"), "'a.sh' does not end in .mp4");
  EXPECT_EQ(ask(world, true, "a.mp4", kService, "gif"), "'gif' is no video format: there are mp4, ogv and avi");
  EXPECT_EQ(bytesOf("there.mp4"), "precious");
  EXPECT_EQ(ask(world, false), "");
  EXPECT_EQ(ask(world, true, "a.mp4"), "");
  EXPECT_EQ(ask(world, true, "b.mp4"), "it already records '" + here + "/a.mp4'");
}

TEST_F(VideoRecorder, WritesIntoTheFolderThatTheWorldNames) {
  const test::TempFolder other;
  RunningWorld world(worldWith(recorder("<folder>" + other.path().string() + "</folder>")));
  EXPECT_EQ(ask(world, true, "a.avi", kService, "AVI"), "");
  world.step(100);
  EXPECT_EQ(ask(world, false), "");
  EXPECT_EQ(test::decodedVideo(other.path() / "a.avi").codec, "mpeg4");
}

TEST_F(VideoRecorder, SaysThatTheDiskIsFullAndTheRestGoesOn) {
  RunningWorld world(worldWith(recorder("<use_sim_time>true</use_sim_time><bitrate>50000000</bitrate>"),
                               "<noise><type>gaussian</type><mean>0</mean><stddev>0.3</stddev></noise>"));
  EXPECT_EQ(ask(world, true, "a.mp4"), "");
  testing::internal::CaptureStderr();
  {
    const test::FileSizeLimit full(100'000);
    world.step(3000);
    // also where the images are in time, but not the file
    EXPECT_NE(ask(world, false), "");
  }
  const std::string said = testing::internal::GetCapturedStderr();
  const std::string why = "'" + fs::canonical(folder_.path()).string() + "/a.mp4' can't be written: File too large";
  EXPECT_NE(said.find("camera 'm::l::s': " + why + "; the recording has ended"), std::string::npos) << said;
  EXPECT_TRUE(fs::is_empty(folder_.path()));
  EXPECT_EQ(ask(world, true, "b.mp4"), "");
  world.step(100);
  EXPECT_EQ(ask(world, false), "");
  EXPECT_TRUE(fs::exists("b.mp4"));
  EXPECT_NE(world.simulation().finish().error.find(why), std::string::npos);
}

TEST_F(VideoRecorder, IsForColourCameras) {
  const auto complaint = [](const std::string& content) {
    const std::vector<std::string> all = RunningWorld::complaintsAbout(content);
    return all.size() == 1 ? all[0] : testing::PrintToString(all);
  };
  EXPECT_EQ(complaint(std::string(test::kSensorsSystem) + test::smallCamera("depth_camera", "", recorder())),
            "camera-video-recorder of m is left out: 'l::s' is no camera of the model");
  EXPECT_NE(complaint(recorder()).find("belongs in"), std::string::npos);
  EXPECT_EQ(complaint("<model name='m'><link name='l'/>" + recorder() + "</model>"),
            "camera-video-recorder of m is left out: no <sensor> is given");
}

TEST(PluginsInSensors, AreReportedWhereTheyDoNotBelongThere) {
  const auto complaints = [](const std::string& filename, const std::string& name) {
    return RunningWorld::complaintsAbout(
        test::kSensorsSystem +
        test::smallCamera("camera", "", "<plugin filename='" + filename + "' name='" + name + "'/>"));
  };
  EXPECT_EQ(complaints("ignition-gazebo-diff-drive-system", "ignition::gazebo::systems::DiffDrive"),
            std::vector<std::string>{"diff-drive is left out: it does not belong in a <sensor>"});
  EXPECT_EQ(complaints("libnosuchthing.so", "n"),
            std::vector<std::string>{"plugin 'libnosuchthing.so' was not found: it is left out"});
}

/// As Fortress's own test of the system tells it.
TEST_F(VideoRecorder, OfFortressTestWorldRecords) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "test/camera_video_record.sdf");
  EXPECT_EQ(ask(world, true, "test.mp4", "/camera/record_video", "mp4"), "");
  world.step(200);
  EXPECT_EQ(ask(world, false, "", "/camera/record_video"), "");
  const test::DecodedVideo video = test::decodedVideo("test.mp4");
  EXPECT_EQ(video.width, 1280);
  EXPECT_EQ(video.height, 800);
  EXPECT_GT(video.frames.size(), 1U);
}

}  // namespace
}  // namespace pongsim::video
