#include "msgs/scene/sensor_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/sensor.pb.h>

#include <vector>

namespace pongsim::msgs {
namespace {

NoiseSettings noise(double mean) {
  return {NoiseSettings::Type::kGaussianQuantized, mean, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
}

TEST(SensorMessage, KeepsTheSettingsOfEachType) {
  LidarSettings lidar;
  lidar.horizontal = {.samples = 12, .resolution = 2, .minAngle = -1, .maxAngle = 1};
  lidar.maxRange = 30;
  lidar.noise = noise(7);
  const NoiseSettings3 three{noise(1), noise(2), noise(3)};
  const std::vector<SensorSettings> all = {
      ImuSettings{three, {noise(4), noise(5), noise(6)}, true, "CUSTOM", Quaternion::Identity()},
      AltimeterSettings{noise(1), noise(2)},
      AirPressureSettings{12, noise(1)},
      MagnetometerSettings{three},
      lidar,
      LogicalCameraSettings{0.5, 5, 1.5, 2}};
  for (const SensorSettings& settings : all) {
    description::Sensor sensor;
    sensor.name = "s";
    sensor.type = "t";
    sensor.updateRate = 30;
    sensor.topic = "/t";
    sensor.X_ParentSensor.position = {1, 2, 3};
    sensor.settings = settings;
    ignition::msgs::Sensor message;
    setSensor(sensor, message);
    EXPECT_EQ(sensorOf(message), sensor) << settings.index();
  }
}

TEST(SensorMessage, TellsOfACameraWhatItHasPlaceFor) {
  description::Sensor sensor;
  CameraSettings camera;
  camera.width = 640;
  camera.clip = {0.2, 50};
  sensor.settings = camera;
  ignition::msgs::Sensor message;
  setSensor(sensor, message);
  const description::Sensor again = sensorOf(message);
  const auto& found = std::get<CameraSettings>(again.settings);
  EXPECT_EQ(found.width, 640U);
  EXPECT_EQ(found.clip, camera.clip);
  message.mutable_camera()->mutable_image_size()->set_x(1e300);
  EXPECT_EQ(std::get<CameraSettings>(sensorOf(message).settings).width, 0U);
}

TEST(SensorMessage, HasNoSettingsOfTypesThatHaveNone) {
  description::Sensor sensor;
  sensor.type = "rfid";
  ignition::msgs::Sensor message;
  setSensor(sensor, message);
  EXPECT_EQ(sensorOf(message).settings.index(), 0U);
}

}  // namespace
}  // namespace pongsim::msgs
