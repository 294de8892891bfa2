#include <gtest/gtest.h>
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "pongsim/sensing/label_colors.hh"
#include "support/camera_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::segmentation_camera_test {
namespace {

using ignition::msgs::Image;
using test::boxOf;
using test::labelled;
using test::RunningWorld;
using test::seenOn;
using test::smallCamera;
using test::thingAt;

class SegmentationCameras : public test::DrawingTest {};

constexpr const char* kPanoptic = "<segmentation_type>panoptic</segmentation_type>";

LabelColor colorAt(const Image& image, std::size_t column, std::size_t row) {
  LabelColor color;
  for (std::size_t i = 0; i < 3; ++i) {
    color[i] = static_cast<std::uint8_t>(image.data()[row * image.step() + 3 * column + i]);
  }
  return color;
}

/// Two cars to the left and to the right, whose faces are 4 m ahead, before an unlabelled wall.
std::string street() {
  return thingAt("car1", "5 2 0", boxOf(2, 2, 2), "", labelled(40)) +
         thingAt("car2", "5 -2 0", boxOf(2, 2, 2), labelled(40)) + thingAt("wall", "20 0 0", boxOf(1, 90, 90));
}

TEST_F(SegmentationCameras, ShowLabelsToThePixel) {
  for (const char* type : {"segmentation", "segmentation_camera"}) {
    const auto labels = seenOn<Image>("/cam/labels_map", smallCamera(type) + street());
    const auto colors = seenOn<Image>("/cam/colored_map", smallCamera(type) + street());
    ASSERT_EQ(labels.size(), 1U);
    ASSERT_EQ(colors.size(), 1U);
    EXPECT_EQ(labels[0].pixel_format_type(), ignition::msgs::RGB_INT8);
    EXPECT_EQ(labels[0].step(), 192U);
    ASSERT_EQ(labels[0].data().size(), 64U * 48 * 3);
    EXPECT_EQ(labels[0].header().data(0).value(0), "m::l::s");
    const LabelColor car = LabelPalette().colorOf(40);
    for (std::size_t row = 0; row < 48; ++row) {
      for (std::size_t column = 0; column < 64; ++column) {
        const double y = std::abs(4 * (32 - 0.5 - static_cast<double>(column)) / 52);
        const double z = std::abs(4 * (24 - 0.5 - static_cast<double>(row)) / 52);
        // the inner sides of the boxes, up to 6 m ahead, are seen beside their faces
        const bool isCar = y > 1 ? z < 1 : y * 6 / 4 > 1 && z < y;
        // the edges of the inner sides go through the centres of pixels
        if (y < 1 && std::abs(z - y) < 0.01) continue;
        EXPECT_EQ(colorAt(labels[0], column, row), (isCar ? LabelColor{40, 40, 40} : LabelColor())) << column << row;
        EXPECT_EQ(colorAt(colors[0], column, row), (isCar ? car : LabelColor())) << column << ' ' << row;
      }
    }
  }
}

TEST_F(SegmentationCameras, CountInstances) {
  const auto labels = seenOn<Image>("/cam/labels_map", smallCamera("segmentation", kPanoptic) + street());
  const auto colors = seenOn<Image>("/cam/colored_map", smallCamera("segmentation", kPanoptic) + street());
  ASSERT_EQ(labels.size(), 1U);
  ASSERT_EQ(colors.size(), 1U);
  // in descending order of names
  EXPECT_EQ(colorAt(labels[0], 10, 24), (LabelColor{2, 0, 40}));
  EXPECT_EQ(colorAt(labels[0], 53, 24), (LabelColor{1, 0, 40}));
  EXPECT_EQ(colorAt(labels[0], 32, 24), LabelColor());
  EXPECT_EQ(colorAt(colors[0], 10, 24), LabelPalette().colorOf(40 * 65'536 + 2));
  EXPECT_EQ(colorAt(colors[0], 53, 24), LabelPalette().colorOf(40 * 65'536 + 1));
  EXPECT_EQ(colorAt(colors[0], 32, 24), LabelColor());
}

TEST_F(SegmentationCameras, SeeLabelsOfNestedModelsAndActors) {
  const std::string visual = "<visual name='v'><geometry>" + boxOf(2, 2, 2) + "</geometry></visual>";
  const std::string content = "<model name='outer'><static>true</static><pose relative_to='m'>5 2 0 0 0 0</pose>" +
                              labelled(7) + "<link name='l'/><model name='inner'><link name='l'>" + visual +
                              "</link></model>" + "<model name='other'><pose>0 -4 0 0 0 0</pose>" + labelled(8) +
                              "<link name='l'>" + visual + "</link></model>" +
                              "</model><actor name='a'><pose>5 0 3.5 0 0 0</pose><link name='l'>" + visual + "</link>" +
                              labelled(9) + "</actor>";
  const auto labels = seenOn<Image>("/cam/labels_map", smallCamera("segmentation") + content);
  ASSERT_EQ(labels.size(), 1U);
  EXPECT_EQ(colorAt(labels[0], 10, 24), (LabelColor{7, 7, 7}));
  EXPECT_EQ(colorAt(labels[0], 53, 24), (LabelColor{8, 8, 8}));
  EXPECT_EQ(colorAt(labels[0], 32, 1), (LabelColor{9, 9, 9}));
}

TEST_F(SegmentationCameras, SaveSamplesBehindThoseOfEarlierRuns) {
  const test::TempFolder folder;
  const auto run = [&] {
    RunningWorld world(
        test::kSensorsSystem +
        smallCamera("segmentation", "<save enabled='true'><path>" + folder.path().string() + "</path></save>") +
        street());
    world.step(2);
  };
  run();
  run();
  for (const char* name : {"images/image", "colored_maps/colored", "labels_maps/labels"}) {
    for (const char* number : {"0000000", "0000001", "0000002", "0000003"}) {
      EXPECT_TRUE(std::filesystem::exists(folder.path() / (std::string(name) + "_" + number + ".png")))
          << name << number;
    }
  }
}

TEST_F(SegmentationCameras, SpeakBelowTheirTopic) {
  RunningWorld world(test::kSensorsSystem + smallCamera("segmentation") + street());
  std::vector<Image> labels, colors;
  std::vector<ignition::msgs::CameraInfo> infos;
  world.listen("/cam/labels_map", labels);
  world.listen("/cam/colored_map", colors);
  world.listen("/cam/camera_info", infos);
  world.step(2);
  EXPECT_EQ(labels.size(), 2U);
  EXPECT_EQ(colors.size(), 2U);
  ASSERT_EQ(infos.size(), 2U);
  EXPECT_NEAR(infos[0].intrinsics().k(0), 52, 1e-4);
}

}  // namespace
}  // namespace pongsim::segmentation_camera_test
