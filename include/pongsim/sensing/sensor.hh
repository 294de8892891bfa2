#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "pongsim/declaration.hh"
#include "pongsim/element.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/sensing/sensor_settings.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Handle to a `<sensor>` of a running world. Copies refer to the same sensor. Must not outlive its `Simulation`.
class PONGSIM_API Sensor {
 public:
  SensorId id() const { return id_; }
  /// @return Whether it exists. If not, all other functions but `id` and `isSetAside` throw `Gone`.
  bool exists() const;
  /// @return Whether its model is in an unloaded level (`Model::isSetAside`).
  bool isSetAside() const;
  std::string_view name() const;
  /// @return Its type as in the file: "imu". That of a custom sensor which a system of pongsim simulates is a type of
  /// its own: "dvl", "environmental_sensor" or, for a vector, "environmental_vector_sensor". A camera for bounding
  /// boxes in space is a "boundingbox_camera_3d".
  std::string_view type() const;
  /// @return Its name with all its parents but the world: "model::link::sensor".
  std::string scopedName() const;
  /// @return Its link; for a sensor on a joint, the joint's child.
  Link link() const;
  /// @return Its joint; nothing for a sensor on a link.
  std::optional<Joint> joint() const;
  /// @return Pose of the sensor frame in the frame of `link()`; constant.
  Pose poseInLink() const;
  /// @return Pose of the sensor frame in the world frame.
  Pose pose() const;
  /// @return Velocity of the sensor frame's origin, world frame [m/s].
  Vector3 linearVelocity() const;
  /// @return Messages per simulated second, as in the file; zero: one per step.
  double updateRate() const;
  bool isAlwaysOn() const;
  /// @return Whether the file enables `SensorTopic`'s metrics.
  bool hasMetrics() const;
  /// @return `<topic>` of the file, else "/world/W/model/M/link/L/sensor/S" and `suffix`, which begins with a slash.
  std::string topic(std::string_view suffix) const;
  /// @return The topic of readings that a system has declared, cleaned (`cleanTopic`).
  std::string topic(const SensorReadings& readings) const;
  /// @return Its frame name in messages: `<ignition_frame_id>`, else `scopedName()`.
  std::string frameName() const;
  /// @return The settings of its type, such as `settings<ImuSettings>()`; null for a sensor of another type.
  template <class Settings>
  const Settings* settings() const {
    return std::get_if<Settings>(&allSettings());
  }
  /// @return The whole `<sensor>` element.
  const Element& sdf() const;

 private:
  friend class Link;
  friend class Joint;
  friend class World;
  Sensor(sim::Access& access, SensorId id) : access_(&access), id_(id) {}
  const SensorSettings& allSettings() const;
  sim::Access* access_;
  SensorId id_;
};

}  // namespace pongsim
