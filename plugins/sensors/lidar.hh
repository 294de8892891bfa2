#pragma once

#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

#include <vector>

#include "pongsim/beam_scene.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/noise_set.hh"
#include "pongsim/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

/// What the lidars of a world share: what there is to be seen, and where to speak of it.
class LidarSurroundings {
 public:
  LidarSurroundings(const World& world, Node& node) : scene_(world), node_(node) {}

  void observe(const StepInfo&) { isOfNow_ = false; }
  void rebuild(Diagnostics& diagnostics) { scene_.rebuild(diagnostics); }

  Node& node() { return node_; }
  /// @return The scene with everything where it is in this step.
  BeamScene& now() {
    if (!isOfNow_) scene_.update();
    isOfNow_ = true;
    return scene_;
  }

 private:
  BeamScene scene_;
  Node& node_;
  bool isOfNow_ = false;
};

/// One lidar: a sensor of a `SensorSystem`.
class LidarSensor {
 public:
  using Message = ignition::msgs::LaserScan;
  using Shared = LidarSurroundings;
  static constexpr const char* kTypes[] = {"gpu_lidar", "lidar", "gpu_ray", "ray"};
  static constexpr const char* kSuffix = "/scan";
  static constexpr const char* kText =
      "Publishes what the world's lidars see: how far it is along each of their beams.";

  /// @throws Error where it has too many beams.
  LidarSensor(const Sensor& sensor, const World& world, NoiseSet& noises, Message& message, LidarSurroundings& shared);

  void measure(Message& message);
  bool isHeardElsewhere() const { return points_.hasSubscribers(); }
  /// Publishes the points that a scan tells of.
  void publishElsewhere(const Message& message);

 private:
  void fillIn(const Message& scan, ignition::msgs::PointCloudPacked& cloud) const;

  Sensor sensor_;
  LidarSettings settings_;
  LidarSurroundings& surroundings_;
  Noise& noise_;
  bool hasNoise_;
  /// Of the beams in the sensor frame, row by row from the lowest one.
  std::vector<Vector3> directions_;
  std::vector<Echo> echoes_;
  Publisher points_;
  ignition::msgs::PointCloudPacked cloud_;
};

}  // namespace pongsim
