#include "msgs/scene/sensor_message.hh"

#include <ignition/msgs/sensor.pb.h>

#include <cstdint>
#include <variant>

#include "pongsim/messages/fields.hh"

namespace pongsim::msgs {

namespace {

namespace im = ignition::msgs;

im::SensorNoise::Type typeOf(NoiseSettings::Type type) {
  switch (type) {
    case NoiseSettings::Type::kGaussian:
      return im::SensorNoise::GAUSSIAN;
    case NoiseSettings::Type::kGaussianQuantized:
      return im::SensorNoise::GAUSSIAN_QUANTIZED;
    case NoiseSettings::Type::kNone:
      break;
  }
  return im::SensorNoise::NONE;
}

void setNoise(const NoiseSettings& noise, im::SensorNoise& message) {
  message.set_type(typeOf(noise.type));
  message.set_mean(noise.mean);
  message.set_stddev(noise.standardDeviation);
  message.set_bias_mean(noise.biasMean);
  message.set_bias_stddev(noise.biasStandardDeviation);
  message.set_precision(noise.precision);
  message.set_dynamic_bias_stddev(noise.dynamicBiasStandardDeviation);
  message.set_dynamic_bias_correlation_time(noise.dynamicBiasCorrelationTime);
}

/// @param message A message with a noise for each axis.
template <class Message>
void setNoise3(const NoiseSettings3& noise, Message& message) {
  setNoise(noise[0], *message.mutable_x_noise());
  setNoise(noise[1], *message.mutable_y_noise());
  setNoise(noise[2], *message.mutable_z_noise());
}

struct SettingsWriter {
  im::Sensor& message;

  void operator()(const ImuSettings& settings) const {
    setNoise3(settings.angularVelocity, *message.mutable_imu()->mutable_angular_velocity());
    setNoise3(settings.linearAcceleration, *message.mutable_imu()->mutable_linear_acceleration());
    im::IMUSensor::OrientationReferenceFrame& frame = *message.mutable_imu()->mutable_orientation_ref_frame();
    frame.set_localization(settings.localization);
    setVector(rollPitchYawOf(settings.customRotation), *frame.mutable_custom_rpy());
  }

  void operator()(const AltimeterSettings& settings) const {
    setNoise(settings.verticalPosition, *message.mutable_altimeter()->mutable_vertical_position_noise());
    setNoise(settings.verticalVelocity, *message.mutable_altimeter()->mutable_vertical_velocity_noise());
  }

  void operator()(const AirPressureSettings& settings) const {
    message.mutable_air_pressure()->set_reference_altitude(settings.referenceAltitude);
    setNoise(settings.pressure, *message.mutable_air_pressure()->mutable_pressure_noise());
  }

  void operator()(const MagnetometerSettings& settings) const {
    setNoise3(settings.field, *message.mutable_magnetometer());
  }

  void operator()(const LidarSettings& settings) const {
    im::LidarSensor& lidar = *message.mutable_lidar();
    lidar.set_horizontal_samples(static_cast<std::int32_t>(settings.horizontal.samples));
    lidar.set_horizontal_resolution(settings.horizontal.resolution);
    lidar.set_horizontal_min_angle(settings.horizontal.minAngle);
    lidar.set_horizontal_max_angle(settings.horizontal.maxAngle);
    lidar.set_vertical_samples(static_cast<std::int32_t>(settings.vertical.samples));
    lidar.set_vertical_resolution(settings.vertical.resolution);
    lidar.set_vertical_min_angle(settings.vertical.minAngle);
    lidar.set_vertical_max_angle(settings.vertical.maxAngle);
    lidar.set_range_min(settings.minRange);
    lidar.set_range_max(settings.maxRange);
    lidar.set_range_resolution(settings.rangeResolution);
    setNoise(settings.noise, *lidar.mutable_noise());
  }

  void operator()(const CameraSettings& settings) const {
    im::CameraSensor& camera = *message.mutable_camera();
    camera.set_horizontal_fov(settings.horizontalFov);
    camera.mutable_image_size()->set_x(settings.width);
    camera.mutable_image_size()->set_y(settings.height);
    camera.set_near_clip(settings.clip.near);
    camera.set_far_clip(settings.clip.far);
    camera.set_save_enabled(settings.savesPictures);
    camera.set_save_path(settings.savePath);
  }

  void operator()(const LogicalCameraSettings& settings) const {
    im::LogicalCameraSensor& camera = *message.mutable_logical_camera();
    camera.set_near_clip(settings.near);
    camera.set_far_clip(settings.far);
    camera.set_horizontal_fov(settings.horizontalFov);
    camera.set_aspect_ratio(settings.aspectRatio);
  }

  /// For types whose settings have no field in the message.
  template <class Other>
  void operator()(const Other&) const {}
};

NoiseSettings noiseOf(const im::SensorNoise& message) {
  NoiseSettings noise;
  if (message.type() == im::SensorNoise::GAUSSIAN) noise.type = NoiseSettings::Type::kGaussian;
  if (message.type() == im::SensorNoise::GAUSSIAN_QUANTIZED) noise.type = NoiseSettings::Type::kGaussianQuantized;
  noise.mean = message.mean();
  noise.standardDeviation = message.stddev();
  noise.biasMean = message.bias_mean();
  noise.biasStandardDeviation = message.bias_stddev();
  noise.precision = message.precision();
  noise.dynamicBiasStandardDeviation = message.dynamic_bias_stddev();
  noise.dynamicBiasCorrelationTime = message.dynamic_bias_correlation_time();
  return noise;
}

template <class Message>
NoiseSettings3 noise3Of(const Message& message) {
  return {noiseOf(message.x_noise()), noiseOf(message.y_noise()), noiseOf(message.z_noise())};
}

ImuSettings imuOf(const im::IMUSensor& message) {
  ImuSettings imu;
  imu.angularVelocity = noise3Of(message.angular_velocity());
  imu.linearAcceleration = noise3Of(message.linear_acceleration());
  imu.localization = message.orientation_ref_frame().localization();
  const im::Vector3d& angles = message.orientation_ref_frame().custom_rpy();
  imu.customRotation = fromRollPitchYaw(angles.x(), angles.y(), angles.z());
  return imu;
}

LidarSettings lidarOf(const im::LidarSensor& message) {
  LidarSettings lidar;
  lidar.horizontal = {static_cast<std::uint32_t>(message.horizontal_samples()), message.horizontal_resolution(),
                      message.horizontal_min_angle(), message.horizontal_max_angle()};
  lidar.vertical = {static_cast<std::uint32_t>(message.vertical_samples()), message.vertical_resolution(),
                    message.vertical_min_angle(), message.vertical_max_angle()};
  lidar.minRange = message.range_min();
  lidar.maxRange = message.range_max();
  lidar.rangeResolution = message.range_resolution();
  lidar.noise = noiseOf(message.noise());
  return lidar;
}

CameraSettings cameraOf(const im::CameraSensor& message) {
  CameraSettings camera;
  camera.horizontalFov = message.horizontal_fov();
  // ignore pixel counts that are impossible
  const auto pixels = [](double count) { return count >= 0 && count < 1e9 ? static_cast<std::uint32_t>(count) : 0; };
  camera.width = pixels(message.image_size().x());
  camera.height = pixels(message.image_size().y());
  camera.clip = {message.near_clip(), message.far_clip()};
  camera.savesPictures = message.save_enabled();
  camera.savePath = message.save_path();
  return camera;
}

SensorSettings settingsOf(const im::Sensor& message) {
  if (message.has_imu()) return imuOf(message.imu());
  if (message.has_altimeter()) {
    return AltimeterSettings{noiseOf(message.altimeter().vertical_position_noise()),
                             noiseOf(message.altimeter().vertical_velocity_noise())};
  }
  if (message.has_air_pressure()) {
    return AirPressureSettings{message.air_pressure().reference_altitude(),
                               noiseOf(message.air_pressure().pressure_noise())};
  }
  if (message.has_magnetometer()) return MagnetometerSettings{noise3Of(message.magnetometer())};
  if (message.has_lidar()) return lidarOf(message.lidar());
  if (message.has_camera()) return cameraOf(message.camera());
  if (message.has_logical_camera()) {
    const im::LogicalCameraSensor& camera = message.logical_camera();
    return LogicalCameraSettings{camera.near_clip(), camera.far_clip(), camera.horizontal_fov(), camera.aspect_ratio()};
  }
  return {};
}

}  // namespace

void setSensor(const description::Sensor& sensor, im::Sensor& message) {
  message.Clear();
  message.set_name(sensor.name);
  message.set_type(sensor.type);
  message.set_always_on(sensor.alwaysOn);
  message.set_update_rate(sensor.updateRate);
  message.set_visualize(sensor.isVisualized);
  message.set_topic(sensor.topic);
  setPose(sensor.X_ParentSensor, *message.mutable_pose());
  std::visit(SettingsWriter{message}, sensor.settings);
}

description::Sensor sensorOf(const im::Sensor& message) {
  description::Sensor sensor;
  sensor.name = message.name();
  sensor.type = message.type();
  sensor.alwaysOn = message.always_on();
  sensor.updateRate = message.update_rate();
  sensor.isVisualized = message.visualize();
  sensor.topic = message.topic();
  const im::Quaternion& rotation = message.pose().orientation();
  const im::Vector3d& position = message.pose().position();
  sensor.X_ParentSensor = {{position.x(), position.y(), position.z()},
                           Quaternion(rotation.w(), rotation.x(), rotation.y(), rotation.z())};
  sensor.settings = settingsOf(message);
  return sensor;
}

}  // namespace pongsim::msgs
