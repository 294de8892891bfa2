#pragma once

#include <string>
#include <vector>

#include "description/plugin.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/sensing/sensor_settings.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// A `<sensor>`.
struct Sensor {
  std::string name;
  SourcePosition position;
  /// As in the file: "imu".
  std::string type;
  /// Pose in the frame of its parent link or joint.
  Pose X_ParentSensor;
  /// `<topic>`; empty: the default topic.
  std::string topic;
  /// Frame name in its messages (`<ignition_frame_id>`); empty: the default frame.
  std::string frame;
  /// Messages per simulated second; zero: one every step.
  double updateRate = 0;
  bool alwaysOn = false;
  /// Whether its message rates are published as metrics.
  bool hasMetrics = false;
  /// Whether its data is displayed, by programs that can.
  bool isVisualized = false;
  SensorSettings settings;
  std::vector<Plugin> plugins;
  /// The whole `<sensor>` element.
  Element sdf;

  bool operator==(const Sensor&) const = default;
};

}  // namespace pongsim::description
