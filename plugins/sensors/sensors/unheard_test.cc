// What lidars and cameras cost without subscribers. It is counted at the library's edge: this program's functions stand
// before those of libpongsim, count, and call them.

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>

#include "pongsim/sensing/beam_scene.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "support/running_world.hh"

namespace pongsim::unheard_test {
namespace {

/// How often each was called by now.
struct LightCalls {
  int updates = 0;
  int casts = 0;
  int colors = 0;
  int depths = 0;
  bool operator==(const LightCalls&) const = default;
};
LightCalls lightCalls;

void PrintTo(const LightCalls& calls, std::ostream* stream) {
  *stream << calls.updates << " updates, " << calls.casts << " casts, " << calls.colors << " + " << calls.depths
          << " pictures";
}

/// @param name As the compiler writes it.
/// @return The library's own function.
template <class Function>
Function* libraryFunction(const char* name) {
  auto* const function = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
  if (function == nullptr) throw std::runtime_error(std::string("the library has no ") + name);
  return function;
}

}  // namespace
}  // namespace pongsim::unheard_test

namespace pongsim {

void BeamScene::update() {
  ++unheard_test::lightCalls.updates;
  unheard_test::libraryFunction<void(BeamScene*)>("_ZN7pongsim9BeamScene6updateEv")(this);
}

void BeamScene::cast(const Sensor& sensor, std::span<const Vector3> directions, double minRange, double maxRange,
                     std::uint32_t visibilityMask, std::span<Echo> echoes) {
  ++unheard_test::lightCalls.casts;
  constexpr const char* kName =
      "_ZN7pongsim9BeamScene4castERKNS_6SensorESt4spanIKN5Eigen6MatrixIdLi3ELi1ELi0ELi3ELi1EEELm18446744073709551615EE"
      "ddjS4_INS_4EchoELm18446744073709551615EE";
  unheard_test::libraryFunction<void(BeamScene*, const Sensor&, std::span<const Vector3>, double, double, std::uint32_t,
                                     std::span<Echo>)>(kName)(this, sensor, directions, minRange, maxRange,
                                                              visibilityMask, echoes);
}

void CameraScene::update() {
  ++unheard_test::lightCalls.updates;
  unheard_test::libraryFunction<void(CameraScene*)>("_ZN7pongsim11CameraScene6updateEv")(this);
}

void CameraScene::drawColors(const PictureView& view, std::span<std::uint8_t> pixels) {
  ++unheard_test::lightCalls.colors;
  constexpr const char* kName =
      "_ZN7pongsim11CameraScene10drawColorsERKNS_11PictureViewESt4spanIhLm18446744073709551615EE";
  unheard_test::libraryFunction<void(CameraScene*, const PictureView&, std::span<std::uint8_t>)>(kName)(this, view,
                                                                                                        pixels);
}

void CameraScene::drawDepths(const PictureView& view, std::span<float> depths) {
  ++unheard_test::lightCalls.depths;
  constexpr const char* kName =
      "_ZN7pongsim11CameraScene10drawDepthsERKNS_11PictureViewESt4spanIfLm18446744073709551615EE";
  unheard_test::libraryFunction<void(CameraScene*, const PictureView&, std::span<float>)>(kName)(this, view, depths);
}

}  // namespace pongsim

namespace pongsim::unheard_test {
namespace {

/// What happens in one reading while somebody listens to one topic of a sensor.
struct Reading {
  const char* sensorType;
  const char* topic;
  const char* messageType;
  LightCalls calls;
};

constexpr const char* kScan = "ignition.msgs.LaserScan";
constexpr const char* kCloud = "ignition.msgs.PointCloudPacked";
constexpr const char* kImage = "ignition.msgs.Image";
constexpr const char* kInfo = "ignition.msgs.CameraInfo";
constexpr const char* kBoxes = "ignition.msgs.AnnotatedAxisAligned2DBox_V";

class LightSensors : public testing::TestWithParam<Reading> {
 protected:
  /// A sensor that is due in every step, with a body that falls before it.
  static std::string content() {
    const bool isCamera = std::string(GetParam().sensorType).find("camera") != std::string::npos;
    return std::string(
               "<plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'/>"
               "<model name='m'><static>true</static><link name='l'><sensor name='s' type='") +
           GetParam().sensorType + "'><topic>t</topic>" +
           (isCamera ? "<camera><image><width>8</width><height>6</height></image></camera>"
                     : "<lidar><scan><horizontal><samples>9</samples></horizontal></scan></lidar>") +
           "</sensor></link></model><model name='b'><pose>3 0 0 0 0 0</pose><link name='l'><visual name='v'><geometry>"
           "<box><size>1 1 1</size></box></geometry></visual></link></model>";
  }
};

TEST_P(LightSensors, CostNothingUnlessSomebodyListens) {
  for (const std::string& said : test::RunningWorld::complaintsAbout(content())) {
    if (said.find("libOSMesa") != std::string::npos) GTEST_SKIP() << said;
  }
  test::RunningWorld world(content());
  lightCalls = {};
  world.step(20);
  EXPECT_EQ(lightCalls, LightCalls{});

  int heard = 0;
  Subscription subscription = world.simulation().transport().node().subscribe(GetParam().topic, GetParam().messageType,
                                                                              [&heard](const Message&) { ++heard; });
  world.step(1);
  EXPECT_EQ(heard, 1);
  EXPECT_EQ(lightCalls, GetParam().calls);

  subscription = {};
  lightCalls = {};
  world.step(20);
  EXPECT_EQ(lightCalls, LightCalls{});
}

INSTANTIATE_TEST_SUITE_P(
    OfEachKind, LightSensors,
    testing::Values(Reading{"gpu_lidar", "/t", kScan, {1, 1, 0, 0}}, Reading{"lidar", "/t", kScan, {1, 1, 0, 0}},
                    Reading{"gpu_ray", "/t", kScan, {1, 1, 0, 0}}, Reading{"ray", "/t", kScan, {1, 1, 0, 0}},
                    Reading{"gpu_lidar", "/t/points", kCloud, {1, 1, 0, 0}},
                    Reading{"camera", "/t", kImage, {1, 0, 1, 0}}, Reading{"camera", "/camera_info", kInfo, {}},
                    Reading{"depth_camera", "/t", kImage, {1, 0, 0, 1}},
                    Reading{"depth_camera", "/t/points", kCloud, {1, 0, 1, 1}},
                    Reading{"rgbd_camera", "/t/image", kImage, {1, 0, 1, 0}},
                    Reading{"rgbd_camera", "/t/depth_image", kImage, {1, 0, 0, 1}},
                    Reading{"rgbd_camera", "/t/points", kCloud, {1, 0, 1, 1}},
                    Reading{"thermal_camera", "/t", kImage, {1, 0, 0, 0}},
                    Reading{"thermal_camera", "/camera_info", kInfo, {}},
                    Reading{"segmentation_camera", "/t/labels_map", kImage, {1, 0, 0, 0}},
                    Reading{"segmentation_camera", "/t/camera_info", kInfo, {}},
                    Reading{"boundingbox_camera", "/t", kBoxes, {1, 0, 0, 0}},
                    Reading{"boundingbox_camera", "/t_image", kImage, {1, 0, 1, 0}},
                    Reading{"boundingbox_camera", "/camera_info", kInfo, {}},
                    Reading{"wide_angle_camera", "/t", kImage, {1, 0, 1, 0}}),
    [](const auto& instance) {
      std::string name = std::string(instance.param.sensorType) + instance.param.topic;
      std::ranges::replace(name, '/', '_');
      return name;
    });

}  // namespace
}  // namespace pongsim::unheard_test
