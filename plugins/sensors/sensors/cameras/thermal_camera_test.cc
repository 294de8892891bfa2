#include <gtest/gtest.h>
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "support/camera_world.hh"
#include "support/fortress_worlds.hh"
#include "support/png_file.hh"
#include "support/temp_folder.hh"

namespace pongsim::thermal_camera_test {
namespace {

using ignition::msgs::Image;
using test::boxOf;
using test::RunningWorld;
using test::seenOn;
using test::smallCamera;
using test::thingAt;

class ThermalCameras : public test::DrawingTest {};

constexpr const char* kAir =
    "<atmosphere type='adiabatic'><temperature>290</temperature><temperature_gradient>0</temperature_gradient>"
    "</atmosphere>";
constexpr const char* kEightBits = "<image><width>64</width><height>48</height><format>L8</format></image>";

std::string thermal(const std::string& content) {
  return "<plugin filename='ignition-gazebo-thermal-system' name='ignition::gazebo::systems::Thermal'>" + content +
         "</plugin>";
}

std::string thermalSensor(const std::string& content) {
  return "<plugin filename='ignition-gazebo-thermal-sensor-system' name='ignition::gazebo::systems::ThermalSensor'>" +
         content + "</plugin>";
}

/// A camera with 8 bits; of two `<image>` elements the first counts.
std::string coarseCamera(const std::string& ofSensor = "") {
  std::string text = smallCamera("thermal_camera", "", ofSensor);
  const std::string fine = "<image><width>64</width><height>48</height></image>";
  text.replace(text.find(fine), fine.size(), kEightBits);
  return text;
}

int valueAt(const Image& image, std::size_t column, std::size_t row) {
  const std::size_t bytes = image.step() / image.width();
  std::uint16_t value = 0;
  std::memcpy(&value, image.data().data() + (row * image.width() + column) * bytes, bytes);
  return value;
}

/// A warm box of 2 m to the left, whose face is 4 m ahead, and a cool one to the right.
std::string twoBoxes(double left, double right) {
  return thingAt("left", "5 2 0", boxOf(2, 2, 2), thermal("<temperature>" + std::to_string(left) + "</temperature>")) +
         thingAt("right", "5 -2 0", boxOf(2, 2, 2),
                 thermal("<temperature>" + std::to_string(right) + "</temperature>"));
}

TEST_F(ThermalCameras, MeasureTemperaturesToTheirResolution) {
  for (const char* type : {"thermal", "thermal_camera"}) {
    const auto images = seenOn<Image>("/cam", kAir + smallCamera(type) + twoBoxes(310.25, 285.5));
    ASSERT_EQ(images.size(), 1U);
    EXPECT_EQ(images[0].pixel_format_type(), ignition::msgs::L_INT16);
    EXPECT_EQ(images[0].step(), 128U);
    ASSERT_EQ(images[0].data().size(), 64U * 48 * 2);
    EXPECT_EQ(images[0].header().data(0).value(0), "m::l::s");
    for (std::size_t row = 0; row < 48; ++row) {
      for (std::size_t column = 0; column < 64; ++column) {
        // the faces are 4 m ahead, from 1 m aside on, and 1 m high and low
        const double y = 4 * (32 - 0.5 - static_cast<double>(column)) / 52;
        const bool isInRow = std::abs(4 * (24 - 0.5 - static_cast<double>(row)) / 52) < 1;
        const bool isAside = std::abs(y) > 1;
        const int expected = isInRow && isAside ? (y > 0 ? 31025 : 28550) : 29000;
        // the boxes' inner sides are seen beside their faces
        if (!isAside && std::abs(y) > 0.6) continue;
        EXPECT_EQ(valueAt(images[0], column, row), expected) << column << ' ' << row;
      }
    }
  }
}

TEST_F(ThermalCameras, HaveEightBitsWithAnotherResolution) {
  const auto images = seenOn<Image>("/cam", kAir + coarseCamera() + twoBoxes(600, 800));
  ASSERT_EQ(images.size(), 1U);
  EXPECT_EQ(images[0].pixel_format_type(), ignition::msgs::L_INT8);
  EXPECT_EQ(images[0].step(), 64U);
  EXPECT_EQ(valueAt(images[0], 10, 24), 200);
  // more than it can show
  EXPECT_EQ(valueAt(images[0], 53, 24), 255);
  EXPECT_EQ(valueAt(images[0], 32, 2), 97);
}

TEST_F(ThermalCameras, ShowTheRangeThatTheirSystemSays) {
  const auto images = seenOn<Image>(
      "/cam",
      kAir + coarseCamera(thermalSensor("<min_temp>280</min_temp><max_temp>400</max_temp><resolution>2</resolution>")) +
          twoBoxes(600, 100));
  ASSERT_EQ(images.size(), 1U);
  EXPECT_EQ(valueAt(images[0], 10, 24), 200);
  EXPECT_EQ(valueAt(images[0], 53, 24), 140);
  EXPECT_EQ(valueAt(images[0], 32, 2), 145);
}

TEST_F(ThermalCameras, SeeTheAirWarmerWhereThingsAreBright) {
  // the range is that between the lowest and the highest place that is seen 100 m ahead: 0.1 K/m
  const std::string air =
      "<atmosphere type='adiabatic'><temperature>290</temperature><temperature_gradient>-0.1</temperature_gradient>"
      "</atmosphere>";
  const double half = 0.1 * 100 * (64 / 52.0) / 2;
  const auto images = seenOn<Image>(
      "/cam", air + smallCamera("thermal") +
                  thingAt("white", "5 2 0", boxOf(2, 2, 2), "<material><diffuse>1 1 1 1</diffuse></material>") +
                  thingAt("blue", "5 -2 0", boxOf(2, 2, 2), "<material><diffuse>0 0 1 1</diffuse></material>"));
  ASSERT_EQ(images.size(), 1U);
  EXPECT_NEAR(valueAt(images[0], 10, 24), 100 * (290 + half), 1);
  EXPECT_NEAR(valueAt(images[0], 53, 24), 100 * (290 - half + 0.114 * 2 * half), 1);
  EXPECT_NEAR(valueAt(images[0], 32, 2), 100 * (290 - half), 1);
}

TEST_F(ThermalCameras, ReadHeatSignatures) {
  const test::TempFolder folder;
  // left half black, right half white, on each side of the box
  const auto file =
      folder.write("heat.png", test::grayPng(8, {0, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 0, 255, 255, 255, 255}));
  const auto heated = [&](const std::string& range) {
    return seenOn<Image>("/cam",
                         kAir + smallCamera("thermal") +
                             thingAt("b", "5 0 0", boxOf(2, 2, 2),
                                     thermal("<heat_signature>" + file.string() + "</heat_signature>" + range)));
  };
  const auto images = heated("<min_temp>300</min_temp><max_temp>340</max_temp>");
  ASSERT_EQ(images.size(), 1U);
  // its face spans 26 pixels: in the middle the colours mix evenly
  EXPECT_EQ(valueAt(images[0], 21, 24), 30000);
  EXPECT_EQ(valueAt(images[0], 42, 24), 34000);
  EXPECT_NEAR(valueAt(images[0], 31, 24) + valueAt(images[0], 32, 24), 64000, 20);
  // without a range it is that of the air
  EXPECT_EQ(valueAt(heated("").at(0), 42, 24), 29000);
  EXPECT_EQ(valueAt(heated("<max_temp>340</max_temp>").at(0), 21, 24), 29000);
}

TEST_F(ThermalCameras, ReadTheInvalidWorldOfFortressAsFortressDoes) {
  // ThermalSensorTest.ThermalSensorSystemInvalidConfig of gz-sim
  const auto folder = test::fortressWorlds();
  if (!folder) GTEST_SKIP() << "no worlds of Fortress";
  RunningWorld world(*folder / "test/thermal_invalid.sdf");
  std::vector<Image> images;
  world.listen("/thermal_camera_invalid/image", images);
  world.step(1);
  ASSERT_EQ(images.size(), 1U);
  EXPECT_EQ(images[0].pixel_format_type(), ignition::msgs::L_INT8);
  EXPECT_EQ(valueAt(images[0], 319, 120) * 3, 600);
  EXPECT_EQ(valueAt(images[0], 0, 120) * 3, 765);
  EXPECT_EQ(valueAt(images[0], 160, 120), 0);
}

TEST_F(ThermalCameras, AreNoisyAsAFractionOfTheirLargestValue) {
  const std::string noise = "<noise><type>gaussian</type><mean>0.1</mean><stddev>0</stddev></noise>";
  const auto images = seenOn<Image>("/cam", kAir + smallCamera("thermal", noise));
  ASSERT_EQ(images.size(), 1U);
  EXPECT_NEAR(valueAt(images[0], 10, 10), 29000 + 6553.5, 1);
}

TEST_F(ThermalCameras, SavePictures) {
  const test::TempFolder folder;
  RunningWorld world(
      test::kSensorsSystem +
      smallCamera("thermal", "<save enabled='true'><path>" + (folder.path() / "new").string() + "</path></save>") +
      twoBoxes(300, 200));
  world.step(2);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "new/s_0.png"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "new/s_1.png"));
}

TEST_F(ThermalCameras, SeeWhatIsInsertedAndNotWhatIsRemoved) {
  RunningWorld world(test::kSensorsSystem + std::string(kAir) + smallCamera("thermal"));
  std::vector<Image> images;
  world.listen("/cam", images);
  world.step(1);
  Diagnostics diagnostics;
  const auto model = world.simulation().insertText(
      "<sdf version='1.9'><model name='hot'><static>true</static><pose>5 0 1 0 0 0</pose><link name='l'>"
      "<visual name='v'><geometry><box><size>2 2 2</size></box></geometry>" +
          thermal("<temperature>400</temperature>") + "</visual></link></model></sdf>",
      "hot", {}, diagnostics);
  ASSERT_TRUE(model) << format(diagnostics.all().at(0));
  EXPECT_TRUE(diagnostics.all().empty());
  world.step(1);
  EXPECT_TRUE(world.simulation().remove(*model));
  world.step(1);
  ASSERT_EQ(images.size(), 3U);
  EXPECT_EQ(valueAt(images[0], 32, 24), 29000);
  EXPECT_EQ(valueAt(images[1], 32, 24), 40000);
  EXPECT_EQ(valueAt(images[2], 32, 24), 29000);
}

}  // namespace
}  // namespace pongsim::thermal_camera_test
