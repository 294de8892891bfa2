#pragma once

#include <string>
#include <vector>

#include "description/plugin.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/sensing/sensor_settings.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// What a `<sensor>` says.
struct Sensor {
  std::string name;
  SourcePosition position;
  /// As the file has it: "imu".
  std::string type;
  /// Pose in the frame of the link or the joint that holds it.
  Pose X_ParentSensor;
  /// `<topic>`; empty: the one by default.
  std::string topic;
  /// Name of the frame in its messages (`<ignition_frame_id>`); empty: the one by default.
  std::string frame;
  /// Messages a simulated second; zero: one every step.
  double updateRate = 0;
  bool alwaysOn = false;
  /// Its messages are counted and timed in messages of their own.
  bool hasMetrics = false;
  /// What it senses is shown, where a program shows such things.
  bool isVisualized = false;
  SensorSettings settings;
  std::vector<Plugin> plugins;
  /// The whole `<sensor>` element.
  Element sdf;

  bool operator==(const Sensor&) const = default;
};

}  // namespace pongsim::description
