#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/bulk.hh"
#include "support/running_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::camera_test {
namespace {

using ignition::msgs::CameraInfo;
using ignition::msgs::Image;
using ignition::msgs::PointCloudPacked;
using test::RunningWorld;

constexpr const char* kSystem =
    "<plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'/>";

/// @return A camera 1 m high that looks along x, its `<sensor>` with that type and content.
/// @param more Elements of its `<camera>`, in place of 32 by 24 pixels.
std::string camera(const std::string& type, const std::string& more = "", const std::string& ofSensor = "") {
  return "<model name='m'><static>true</static><pose>0 0 1 0 0 0</pose><link name='l'><sensor name='s' type='" + type +
         "'><topic>cam" + (type == "rgbd_camera" ? "" : "/it") + "</topic>" + ofSensor + "<camera>" +
         (more.find("<image>") == std::string::npos ? "<image><width>32</width><height>24</height></image>" : "") +
         more + "</camera></sensor></link></model>";
}

/// A red wall whose face is 4 m ahead, left of the line of sight; with a colour that light does not change.
constexpr const char* kWall =
    "<model name='wall'><static>true</static><pose>5 10 1 0 0 0</pose><link name='l'><visual name='v'>"
    "<geometry><box><size>2 20 40</size></box></geometry><material><lighting>false</lighting><ambient>1 0 0 1</ambient>"
    "<diffuse>1 0 0 1</diffuse></material></visual></link></model>"
    "<scene><background>0 0 1 1</background></scene>";

template <class M>
std::vector<M> heardOn(const std::string& topic, const std::string& content, std::uint64_t steps = 1) {
  RunningWorld world(kSystem + content);
  std::vector<M> messages;
  world.listen(topic, messages);
  world.step(steps);
  return messages;
}

/// Skips where there is nothing to draw with.
class Cameras : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const std::string& said : RunningWorld::complaintsAbout(kSystem + camera("camera"))) {
      if (said.find("libOSMesa") != std::string::npos) GTEST_SKIP() << said;
    }
  }
};

std::string colorAt(const Image& image, std::size_t column, std::size_t row) {
  return image.data().substr(row * image.step() + 3 * column, 3);
}

TEST_F(Cameras, PublishWhatTheySee) {
  const auto images = heardOn<Image>("/cam/it", camera("camera") + kWall);
  ASSERT_EQ(images.size(), 1U);
  const Image& image = images[0];
  EXPECT_EQ(image.width(), 32U);
  EXPECT_EQ(image.height(), 24U);
  EXPECT_EQ(image.step(), 96U);
  EXPECT_EQ(image.pixel_format_type(), ignition::msgs::RGB_INT8);
  ASSERT_EQ(image.data().size(), 32U * 24 * 3);
  EXPECT_EQ(colorAt(image, 5, 12), std::string("\xff\0\0", 3));
  EXPECT_EQ(colorAt(image, 25, 12), std::string("\0\0\xff", 3));
  EXPECT_EQ(image.header().data(0).value(0), "m::l::s");
}

TEST_F(Cameras, HaveTheFormatThatTheFileAsksFor) {
  struct Case {
    const char* format;
    ignition::msgs::PixelFormatType type;
    std::string pixel;
  };
  for (const auto& [format, type, pixel] :
       {Case{"B8G8R8", ignition::msgs::BGR_INT8, std::string("\0\0\xff", 3)},
        Case{"L8", ignition::msgs::L_INT8, "\x4c"}, Case{"L16", ignition::msgs::L_INT16, "\x8b\x4c"}}) {
    const auto images =
        heardOn<Image>("/cam/it", camera("camera", std::string("<image><width>32</width><height>24</height><format>") +
                                                       format + "</format></image>") +
                                      kWall);
    ASSERT_EQ(images.size(), 1U) << format;
    EXPECT_EQ(images[0].pixel_format_type(), type);
    EXPECT_EQ(images[0].data().substr(12 * images[0].step() + 5 * pixel.size(), pixel.size()), pixel) << format;
  }
}

TEST_F(Cameras, SayWhatTheirLensIs) {
  const auto infos = heardOn<CameraInfo>(
      "/cam/camera_info", camera("camera",
                                 "<horizontal_fov>1.2</horizontal_fov><optical_frame_id>eye</optical_frame_id>"
                                 "<distortion><k1>-0.1</k1><p2>0.02</p2></distortion>"));
  ASSERT_EQ(infos.size(), 1U);
  const CameraInfo& info = infos[0];
  EXPECT_NEAR(info.intrinsics().k(0), 16 / std::tan(0.6), 1e-9);
  EXPECT_NEAR(info.intrinsics().k(4), 16 / std::tan(0.6), 1e-9);
  EXPECT_EQ(info.intrinsics().k(2), 16);
  EXPECT_EQ(info.intrinsics().k(5), 12);
  EXPECT_EQ(info.projection().p_size(), 12);
  EXPECT_EQ(info.distortion().k(0), -0.1);
  EXPECT_EQ(info.distortion().k(3), 0.02);
  EXPECT_EQ(info.header().data(0).value(0), "eye");
}

TEST_F(Cameras, MeasureDepthsAsLidarsDo) {
  // one beam through the middle of each pixel of the middle row but one
  const std::string ball =
      "<model name='ball'><static>true</static><pose>3 -0.2 1 0 0 0</pose><link name='l'><visual name='v'>"
      "<geometry><sphere><radius>0.7</radius></sphere></geometry></visual></link></model>";
  RunningWorld world(kSystem + camera("depth_camera", "<horizontal_fov>1</horizontal_fov>") + kWall + ball +
                     "<model name='n'><static>true</static><pose>0 0 1 0 0 0</pose><link name='l'>"
                     "<sensor name='s' type='gpu_lidar'><topic>scan</topic><lidar><scan><horizontal>"
                     "<samples>2001</samples><min_angle>-0.5</min_angle><max_angle>0.5</max_angle></horizontal></scan>"
                     "<range><min>0.1</min><max>100</max></range></lidar></sensor></link></model>");
  std::vector<Image> images;
  std::vector<ignition::msgs::LaserScan> scans;
  world.listen("/cam/it", images);
  world.listen("/scan", scans);
  world.step(1);
  ASSERT_EQ(images.size(), 1U);
  ASSERT_EQ(scans.size(), 1U);
  ASSERT_EQ(images[0].pixel_format_type(), ignition::msgs::R_FLOAT32);
  ASSERT_EQ(images[0].step(), 128U);
  const double focal = 16 / std::tan(0.5);
  for (int column = 0; column < 32; ++column) {
    float depth = 0;
    std::memcpy(&depth, images[0].data().data() + 12 * 128 + column * 4, 4);
    // what the lidar sees within half a pixel to either side; the row's middle is half a pixel below the horizon
    double least = INFINITY, most = 0;
    for (int i = 0; i < 2001; ++i) {
      const double angle = -0.5 + i * 0.0005;
      if (std::abs(16 - focal * std::tan(angle) - column - 0.5) > 0.55) continue;
      const double ahead = scans[0].ranges(i) * std::cos(angle);
      least = std::min(least, ahead);
      most = std::max(most, ahead);
    }
    EXPECT_GE(depth, least * 0.997) << column;
    EXPECT_LE(depth, most * 1.003 + 0.003) << column;
  }
}

TEST_F(Cameras, PublishPointsWithColors) {
  const auto clouds = heardOn<PointCloudPacked>("/cam/points", camera("rgbd_camera") + kWall);
  ASSERT_EQ(clouds.size(), 1U);
  const PointCloudPacked& cloud = clouds[0];
  ASSERT_EQ(cloud.field_size(), 4);
  EXPECT_EQ(cloud.field(3).name(), "rgb");
  EXPECT_EQ(cloud.field(3).offset(), 16U);
  EXPECT_FALSE(cloud.is_dense());
  const char* point = cloud.data().data() + (12 * 32 + 5) * 32;
  float place[3];
  std::memcpy(place, point, sizeof place);
  const double focal = 16 / std::tan(1.047 / 2);
  EXPECT_NEAR(place[0], 4, 1e-4);
  EXPECT_NEAR(place[1], 4 * 10.5 / focal, 1e-4);
  EXPECT_NEAR(place[2], -4 * 0.5 / focal, 1e-4);
  EXPECT_EQ(std::string(point + 16, 3), std::string("\0\0\xff", 3));
}

TEST_F(Cameras, OfBothKindsSpeakBehindTheirTopic) {
  RunningWorld world(
      kSystem + camera("rgbd_camera", "<depth_camera><clip><near>1</near><far>3</far></clip></depth_camera>") + kWall);
  std::vector<Image> images, depths;
  std::vector<CameraInfo> infos;
  world.listen("/cam/image", images);
  world.listen("/cam/depth_image", depths);
  world.listen("/cam/camera_info", infos);
  world.step(1);
  ASSERT_EQ(images.size(), 1U);
  ASSERT_EQ(depths.size(), 1U);
  ASSERT_EQ(infos.size(), 1U);
  float depth = 0;
  std::memcpy(&depth, depths[0].data().data() + 12 * 128 + 5 * 4, 4);
  // the wall is farther than the clip planes of its depths
  EXPECT_EQ(depth, INFINITY);
  EXPECT_EQ(colorAt(images[0], 5, 12), std::string("\xff\0\0", 3));
}

TEST_F(Cameras, ShowWhatALensBends) {
  // barrel distortion draws inwards what is seen aside; the edge is the one of the far side
  const auto edgeOf = [](const std::string& more) {
    const auto images = heardOn<Image>(
        "/cam/it",
        camera("camera", "<image><width>160</width><height>24</height></image>" + more) +
            "<model name='b'><static>true</static><pose>4 11.8 1 0 0 0</pose><link name='l'><visual name='v'>"
            "<geometry><box><size>0.1 20 40</size></box></geometry></visual></link></model>"
            "<scene><background>0 0 0 1</background><ambient>1 1 1 1</ambient></scene>");
    std::size_t column = 0;
    while (column < 160 && colorAt(images.at(0), column, 12)[0] != 0) ++column;
    return static_cast<double>(column);
  };
  const double focal = 80 / std::tan(1.047 / 2), x = 1.8 / 4.05;
  EXPECT_NEAR(edgeOf(""), 80 - focal * x, 1);
  EXPECT_NEAR(edgeOf("<distortion><k1>-0.3</k1></distortion>"), 80 - focal * x * (1 - 0.3 * x * x), 1);
}

TEST_F(Cameras, AreNoisyByTheirOwnStream) {
  const std::string noisy = camera("camera", "<noise><type>gaussian</type><mean>0</mean><stddev>0.05</stddev></noise>");
  const auto images = heardOn<Image>("/cam/it", noisy + kWall, 2);
  ASSERT_EQ(images.size(), 2U);
  EXPECT_NE(images[0].data(), images[1].data());
  EXPECT_EQ(images[0].data(), heardOn<Image>("/cam/it", noisy + kWall)[0].data());
}

TEST_F(Cameras, HaveNoQuantizedNoise) {
  const std::string noise = "<noise><type>gaussian_quantized</type><mean>0.2</mean><precision>0.1</precision></noise>";
  // of which there is a warning
  const test::TempFolder folder;
  RunningWorld world(folder.write("noisy.sdf", RunningWorld::textOf(kSystem + camera("camera", noise) + kWall)));
  std::vector<Image> images;
  world.listen("/cam/it", images);
  world.step(1);
  ASSERT_EQ(images.size(), 1U);
  EXPECT_EQ(images[0].data(), heardOn<Image>("/cam/it", camera("camera", "") + kWall).at(0).data());
}

std::vector<float> depthsIn(const Image& image) {
  std::vector<float> depths(image.data().size() / sizeof(float));
  std::memcpy(depths.data(), image.data().data(), image.data().size());
  return depths;
}

std::string depthNoise(double mean, double deviation) {
  return "<clip><near>0.1</near><far>50</far></clip><noise><type>gaussian</type><mean>" + std::to_string(mean) +
         "</mean><stddev>" + std::to_string(deviation) + "</stddev></noise>";
}

TEST_F(Cameras, OfDepthsAreNoisyInMetres) {
  const std::string noisy = camera("depth_camera", depthNoise(0.5, 0.1));
  const auto images = heardOn<Image>("/cam/it", noisy + kWall, 2);
  ASSERT_EQ(images.size(), 2U);
  EXPECT_NE(images[0].data(), images[1].data());
  EXPECT_EQ(images[0].data(), heardOn<Image>("/cam/it", noisy + kWall)[0].data());
  // the wall is 4 m ahead on the left, on the right is nothing, which stays so
  double sum = 0, squares = 0, count = 0;
  const std::vector<float> depths = depthsIn(images[0]);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (i % 32 >= 16) {
      EXPECT_EQ(depths[i], INFINITY) << i;
      continue;
    }
    const double error = static_cast<double>(depths[i]) - 4;
    sum += error;
    squares += error * error;
    ++count;
  }
  EXPECT_NEAR(sum / count, 0.5, 0.03);
  EXPECT_NEAR(std::sqrt(squares / count - sum * sum / count / count), 0.1, 0.02);
}

TEST_F(Cameras, ClipDepthsBehindTheirNoise) {
  for (const auto& [mean, found] : {std::pair(-10.0, -INFINITY), std::pair(60.0, INFINITY)}) {
    const auto images = heardOn<Image>("/cam/it", camera("depth_camera", depthNoise(mean, 0)) + kWall);
    ASSERT_EQ(images.size(), 1U);
    EXPECT_EQ(depthsIn(images[0])[12 * 32 + 5], static_cast<float>(found));
  }
}

TEST_F(Cameras, MovePointsByTheNoiseOfTheirDepths) {
  // along each axis, as Fortress does; the same whether somebody listens to the colours, too
  for (const bool areColorsHeard : {false, true}) {
    RunningWorld world(kSystem + camera("rgbd_camera", depthNoise(0, 0.1)) + kWall);
    std::vector<Image> images, depthImages;
    std::vector<PointCloudPacked> clouds;
    if (areColorsHeard) world.listen("/cam/image", images);
    world.listen("/cam/depth_image", depthImages);
    world.listen("/cam/points", clouds);
    world.step(1);
    ASSERT_EQ(depthImages.size(), 1U);
    ASSERT_EQ(clouds.size(), 1U);
    EXPECT_EQ(depthImages[0].data(),
              heardOn<Image>("/cam/depth_image", camera("rgbd_camera", depthNoise(0, 0.1)) + kWall)[0].data());
    const std::vector<float> depths = depthsIn(depthImages[0]);
    const double focal = 16 / std::tan(1.047 / 2);
    for (std::size_t column = 0; column < 32; ++column) {
      const std::size_t pixel = 12 * 32 + column;
      float place[3];
      std::memcpy(place, clouds[0].data().data() + pixel * 32, sizeof place);
      EXPECT_EQ(place[0], depths[pixel]);
      if (column >= 16) {
        EXPECT_EQ(place[1], INFINITY);
        EXPECT_EQ(place[2], INFINITY);
        continue;
      }
      const double shift = static_cast<double>(depths[pixel]) - 4;
      EXPECT_NEAR(place[1], 4 * (15.5 - static_cast<double>(column)) / focal + shift, 1e-4);
      EXPECT_NEAR(place[2], -4 * 0.5 / focal + shift, 1e-4);
    }
  }
}

TEST_F(Cameras, WaitForTheirTrigger) {
  RunningWorld world(kSystem + camera("camera", "<triggered>true</triggered><trigger_topic>now</trigger_topic>") +
                     kWall);
  std::vector<Image> images;
  world.listen("/cam/it", images);
  world.step(3);
  EXPECT_TRUE(images.empty());
  world.tell("/now", ignition::msgs::Boolean());
  world.step(3);
  EXPECT_EQ(images.size(), 1U);
}

TEST_F(Cameras, SavePictures) {
  const test::TempFolder folder;
  RunningWorld world(
      kSystem + camera("camera", "<save enabled='true'><path>" + (folder.path() / "new").string() + "</path></save>"));
  world.step(2);
  for (const char* name : {"s_0.png", "s_1.png"}) {
    std::ifstream file(folder.path() / "new" / name, std::ios::binary);
    char signature[4] = {};
    file.read(signature, 4);
    EXPECT_EQ(std::string(signature, 4), "\x89PNG") << name;
  }
}

TEST_F(Cameras, LeaveTheStateAsItIs) {
  const auto hashAfter = [](bool isHeard) {
    RunningWorld world(
        kSystem + camera("camera") + kWall +
        "<model name='top'><pose>3 0 3 0.3 0.2 0</pose><link name='l'><collision name='c'><geometry><box>"
        "<size>1 1 1</size></box></geometry></collision><visual name='v'><geometry><box><size>1 1 1</size>"
        "</box></geometry></visual></link></model>");
    std::vector<Image> images;
    if (isHeard) world.listen("/cam/it", images);
    world.step(50);
    return world.simulation().stateHash();
  };
  EXPECT_EQ(hashAfter(true), hashAfter(false));
}

/// Who takes what of a picture: how often it was asked for its pixels, and what they were.
struct Taken {
  int asks = 0;
  std::vector<std::vector<std::byte>> pictures;
};

Subscription take(RunningWorld& world, Taken& taken, int times) {
  return world.simulation().transport().node().subscribeAtOnce("/cam/it", "ignition.msgs.Image",
                                                               [&taken, times](const Message&, const Bulk* bulk) {
                                                                 for (int i = 0; i < times; ++i, ++taken.asks)
                                                                   bulk->write(taken.pictures.emplace_back(bulk->size));
                                                               });
}

TEST_F(Cameras, DrawTheSameForOneWhoTakesItAndForMany) {
  const std::string content = kSystem + camera("camera", "", "<update_rate>10</update_rate>") + kWall +
                              "<model name='top'><pose>3 0 3 0.3 0.2 0</pose><link name='l'><visual name='v'>"
                              "<geometry><box><size>1 1 1</size></box></geometry></visual></link></model>";
  RunningWorld world(content);
  Taken one, two, none;
  {
    const Subscription first = take(world, one, 1), second = take(world, two, 2), third = take(world, none, 0);
    world.step(300);
  }
  ASSERT_EQ(one.asks, 4);
  ASSERT_EQ(two.asks, 8);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(two.pictures[2 * i], one.pictures[i]);
    EXPECT_EQ(two.pictures[2 * i + 1], one.pictures[i]);
  }
  RunningWorld again(content);
  Taken alone;
  const Subscription only = take(again, alone, 1);
  again.step(300);
  EXPECT_EQ(alone.pictures, one.pictures);
  EXPECT_NE(alone.pictures.front(), alone.pictures.back());
}

TEST_F(Cameras, ThatCantBeAreLeftOutWithAWarning) {
  struct Case {
    const char* content;
    const char* said;
  };
  for (const auto& [content, said] :
       {Case{"<image><width>100000</width><height>100000</height></image>", "more than 16000000 pixels"},
        Case{"<image><width>8</width><height>8</height><format>BAYER_RGGB8</format></image>", "<format>"},
        Case{"<triggered>true</triggered>", "has no <trigger_topic>"}, Case{"<save enabled='true'/>", "no <path>"},
        Case{"<horizontal_fov>3.2</horizontal_fov>", "too wide for a pinhole camera"}}) {
    const std::vector<std::string> complaints = RunningWorld::complaintsAbout(kSystem + camera("camera", content));
    ASSERT_EQ(complaints.size(), 1U) << content;
    EXPECT_NE(complaints[0].find("camera 'm::l::s'"), std::string::npos) << complaints[0];
    EXPECT_NE(complaints[0].find(said), std::string::npos) << complaints[0];
  }
}

}  // namespace
}  // namespace pongsim::camera_test
