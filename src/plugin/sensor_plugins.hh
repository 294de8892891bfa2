#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "description/plugin.hh"
#include "description/sensor.hh"
#include "pongsim/declaration.hh"
#include "pongsim/diagnostic.hh"

namespace pongsim::plugin {

/// @param system "imu"
/// @param className "Imu"
/// @return A plugin with the names of one of Fortress's systems.
description::Plugin fortressPlugin(std::string_view system, std::string_view className);

/// @return The plugin of Fortress, or of later releases, that simulates sensors of this type; without a filename if no
/// plugin does.
description::Plugin sensorPlugin(std::string_view sensorType);

/// Finds sensors that publish nothing, because no system of their world simulates their type. Fortress doesn't warn of
/// them.
class SensorCheck {
 public:
  /// Notes what a system of the world simulates.
  void add(const Declaration& system);
  /// Notes a sensor of the world.
  void add(const description::Sensor& sensor);
  /// Warns once of all sensors that no system simulates, if pongsim has a system that could.
  void report(Diagnostics& diagnostics) const;

 private:
  std::set<std::string, std::less<>> simulated_;
  std::vector<const description::Sensor*> sensors_;
};

}  // namespace pongsim::plugin
