#include <gtest/gtest.h>
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/camera_world.hh"

namespace pongsim::wide_angle_test {
namespace {

using ignition::msgs::CameraInfo;
using ignition::msgs::Image;
using test::RunningWorld;
using test::seenOn;

class WideAngleCameras : public test::DrawingTest {};

/// A camera at the origin that looks along x, with 101 by 81 pixels.
std::string wideCamera(const std::string& lens, double fov = 3, const std::string& more = "") {
  return "<model name='m'><static>true</static><link name='l'><sensor name='s' type='wideanglecamera'>"
         "<topic>cam/it</topic><camera><horizontal_fov>" +
         std::to_string(fov) +
         "</horizontal_fov><image><width>101</width><height>81</height></image>"
         "<clip><near>0.1</near><far>100</far></clip>" +
         (lens.empty() ? "" : "<lens>" + lens + "</lens>") + more + "</camera></sensor></link></model>";
}

/// A white ball of 0.25 m, 5 m away, before black.
/// @param angle From the line of sight [rad].
/// @param around Direction in the image, from the right downwards [rad].
std::string ballAt(double angle, double around) {
  const Vector3 place =
      5 * Vector3(std::cos(angle), -std::sin(angle) * std::cos(around), -std::sin(angle) * std::sin(around));
  return "<scene><background>0 0 0 1</background></scene><model name='ball'><static>true</static><pose>" +
         std::to_string(place.x()) + " " + std::to_string(place.y()) + " " + std::to_string(place.z()) +
         " 0 0 0</pose><link name='l'><visual name='v'><geometry><sphere><radius>0.25</radius></sphere></geometry>"
         "<material><lighting>false</lighting><diffuse>1 1 1 1</diffuse></material></visual></link></model>";
}

/// @return The centre of what is bright, from the middle of the image; and how bright it is in all, in pixels.
std::pair<Eigen::Vector2d, double> brightPlace(const Image& image) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0;
  for (std::size_t i = 0; i < image.data().size(); i += 3) {
    const double share = static_cast<std::uint8_t>(image.data()[i]) / 255.0;
    const auto pixel = static_cast<double>(i / 3);
    sum += share * Eigen::Vector2d(std::fmod(pixel, 101) - 50, std::floor(pixel / 101) - 40);
    weight += share;
  }
  return {sum / std::max(weight, 1e-9), weight};
}

std::string lensOf(const std::string& type, const std::string& more = "<cutoff_angle>3.2</cutoff_angle>") {
  return "<type>" + type + "</type>" + more;
}

struct Lens {
  const char* type;
  double (*radius)(double angle);
  double fov;
};

constexpr Lens kLenses[] = {
    {"gnomonical", [](double angle) { return std::tan(angle); }, 2},
    {"stereographic", [](double angle) { return 2 * std::tan(angle / 2); }, 4},
    {"equidistant", [](double angle) { return angle; }, 5},
    {"equisolid_angle", [](double angle) { return 2 * std::sin(angle / 2); }, 4},
    {"orthographic", [](double angle) { return std::sin(angle); }, 3},
};

TEST_F(WideAngleCameras, ShowThingsWhereTheirLensMapsThem) {
  for (const Lens& lens : kLenses) {
    for (const double share : {0.4, 0.9}) {
      for (const double around : {0.0, 0.7, 4.0}) {
        const double angle = share * lens.fov / 2;
        const double expected = 50.5 * lens.radius(angle) / lens.radius(lens.fov / 2);
        // below or above the image
        if (std::abs(expected * std::sin(around)) > 35) continue;
        const auto images = seenOn<Image>("/cam/it", wideCamera(lensOf(lens.type), lens.fov) + ballAt(angle, around));
        ASSERT_EQ(images.size(), 1U);
        const auto [place, weight] = brightPlace(images[0]);
        ASSERT_GT(weight, 0.5) << lens.type << ' ' << angle;
        EXPECT_NEAR(place.x(), expected * std::cos(around), 0.5) << lens.type << ' ' << angle << ' ' << around;
        EXPECT_NEAR(place.y(), expected * std::sin(around), 0.5) << lens.type << ' ' << angle << ' ' << around;
      }
    }
  }
}

TEST_F(WideAngleCameras, HaveCustomFunctions) {
  // r = c1 f fun(angle / c2 + c3), in halves of the width
  const std::string custom = lensOf(
      "custom",
      "<scale_to_hfov>false</scale_to_hfov><cutoff_angle>3</cutoff_angle><custom_function><c1>0.8</c1><c2>1.5</c2>"
      "<c3>0</c3><f>0.9</f><fun>sin</fun></custom_function>");
  for (const double angle : {0.2, 0.8, 1.5}) {
    const auto images = seenOn<Image>("/cam/it", wideCamera(custom) + ballAt(angle, 0));
    ASSERT_EQ(images.size(), 1U);
    EXPECT_NEAR(brightPlace(images[0]).first.x(), 50.5 * 0.8 * 0.9 * std::sin(angle / 1.5), 0.5) << angle;
  }
}

TEST_F(WideAngleCameras, SeeNothingBeyondTheirCutOffAngle) {
  const auto brightness = [](double angle, const std::string& more) {
    return brightPlace(seenOn<Image>("/cam/it", wideCamera(lensOf("equidistant", more), 3) + ballAt(angle, 0)).at(0))
        .second;
  };
  const std::string cutoff = "<cutoff_angle>1</cutoff_angle>";
  EXPECT_GT(brightness(0.85, cutoff), 1);
  EXPECT_EQ(brightness(1.1, cutoff), 0);
  EXPECT_GT(brightness(1.1, ""), 1);
}

TEST_F(WideAngleCameras, AreStereographicUnlessTheySayOtherwise) {
  const auto images = seenOn<Image>("/cam/it", wideCamera("", 3) + ballAt(1, 0));
  ASSERT_EQ(images.size(), 1U);
  EXPECT_NEAR(brightPlace(images[0]).first.x(), 50.5 * std::tan(0.5) / std::tan(0.75), 0.5);
}

TEST_F(WideAngleCameras, ShowEverySideWithoutSeams) {
  // in a white room
  const std::string room =
      "<model name='room'><static>true</static><link name='l'><visual name='v'><geometry><box><size>8 8 8</size></box>"
      "</geometry><material><lighting>false</lighting><double_sided>true</double_sided><diffuse>1 1 1 1</diffuse>"
      "</material></visual></link></model>";
  for (const int edge : {16, 100}) {
    const auto images =
        seenOn<Image>("/cam/it", wideCamera(lensOf("equidistant", "<cutoff_angle>3.2</cutoff_angle><env_texture_size>" +
                                                                      std::to_string(edge) + "</env_texture_size>"),
                                            4) +
                                     room);
    ASSERT_EQ(images.size(), 1U);
    for (const char value : images[0].data()) ASSERT_EQ(static_cast<std::uint8_t>(value), 255) << edge;
  }
}

TEST_F(WideAngleCameras, SayTheFocalLengthInTheMiddle) {
  const auto infos = seenOn<CameraInfo>("/cam/camera_info", wideCamera(lensOf("equidistant"), 3));
  ASSERT_EQ(infos.size(), 1U);
  EXPECT_NEAR(infos[0].intrinsics().k(0), 50.5 / 1.5, 1e-6);
  EXPECT_EQ(infos[0].distortion().model(), CameraInfo::Distortion::EQUIDISTANT);
  EXPECT_EQ(infos[0].distortion().k_size(), 4);
}

TEST_F(WideAngleCameras, ThatCantBeAreLeftOutWithAWarning) {
  for (const auto& [lens, fov, said] :
       {std::tuple(lensOf("gnomonical"), 3.5, "can't show a field of view of 3.5"),
        std::tuple(lensOf("custom", "<custom_function><c2>0</c2></custom_function>"), 1.0, "its <c2> is zero"),
        std::tuple(lensOf("custom", "<scale_to_hfov>false</scale_to_hfov><custom_function><f>0</f></custom_function>"),
                   1.0, "is not above zero"),
        std::tuple(lensOf("equidistant", "<env_texture_size>100000</env_texture_size>"), 1.0,
                   "has an <env_texture_size> above 4000")}) {
    const auto complaints = RunningWorld::complaintsAbout(test::kSensorsSystem + wideCamera(lens, fov));
    ASSERT_EQ(complaints.size(), 1U) << lens;
    EXPECT_NE(complaints[0].find("camera 'm::l::s' has a"), std::string::npos) << complaints[0];
    EXPECT_NE(complaints[0].find(said), std::string::npos) << complaints[0];
  }
}

}  // namespace
}  // namespace pongsim::wide_angle_test
