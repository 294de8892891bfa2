#pragma once

#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

#include <cstddef>
#include <span>
#include <vector>

#include "pongsim/node.hh"
#include "pongsim/sensing/beam_scene.hh"
#include "pongsim/sensing/noise_set.hh"
#include "pongsim/sensing/sensor.hh"
#include "surroundings.hh"

namespace pongsim {

/// What the lidars of a world share.
using LidarSurroundings = Surroundings<BeamScene>;

/// One lidar: a sensor of a `SensorSystem`.
class LidarSensor {
 public:
  using Message = ignition::msgs::LaserScan;
  using Shared = LidarSurroundings;
  static constexpr const char* kTypes[] = {"gpu_lidar", "lidar", "gpu_ray", "ray"};
  static constexpr const char* kSuffix = "/scan";
  static constexpr const char* kText =
      "Publishes what the world's lidars see: how far it is along each of their beams.";

  /// @throws Error if it has too many beams.
  LidarSensor(const Sensor& sensor, const World& world, NoiseSet& noises, Message& message, LidarSurroundings& shared);

  bool isReady() const { return surroundings_.hasPower(sensor_); }
  void measure(Message& message);
  bool isHeardElsewhere() const { return points_.hasSubscribers(); }
  /// Publishes the points of a scan.
  void publishElsewhere(const Message& message);

 private:
  void writePoints(const Message& scan, std::span<std::byte> to) const;

  Sensor sensor_;
  LidarSettings settings_;
  LidarSurroundings& surroundings_;
  Noise& noise_;
  bool hasNoise_;
  /// Directions of the beams in the sensor frame, row by row from the lowest one.
  std::vector<Vector3> directions_;
  std::vector<Echo> echoes_;
  Publisher points_;
  ignition::msgs::PointCloudPacked cloud_;
};

}  // namespace pongsim
