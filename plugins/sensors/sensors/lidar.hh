#pragma once

#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

#include <cstddef>
#include <span>
#include <vector>

#include "pongsim/node.hh"
#include "pongsim/sensing/beam_scene.hh"
#include "pongsim/sensing/noise.hh"
#include "pongsim/sensing/sensor_system.hh"
#include "surroundings.hh"

namespace pongsim {

/// What the lidars of a world share.
using LidarSurroundings = Surroundings<BeamScene>;

/// One lidar.
class LidarSensor final : public SensorOf<ignition::msgs::LaserScan> {
 public:
  /// Of its default topic.
  static constexpr const char* kSuffix = "/scan";

  /// @throws Error if it has too many beams.
  LidarSensor(const SensorContext& context, LidarSurroundings& surroundings);

  bool isReady() override { return surroundings_.hasPower(sensor_); }
  void measure() override;
  bool isHeardElsewhere() const override { return points_.hasSubscribers(); }
  /// Publishes the points of the scan.
  void publishElsewhere() override;

 private:
  void writePoints(std::span<std::byte> to) const;

  Sensor sensor_;
  LidarSettings settings_;
  LidarSurroundings& surroundings_;
  Noise& noise_;
  /// Directions of the beams in the sensor frame, row by row from the lowest one.
  std::vector<Vector3> directions_;
  std::vector<Echo> echoes_;
  Publisher points_;
  ignition::msgs::PointCloudPacked cloud_;
};

}  // namespace pongsim
