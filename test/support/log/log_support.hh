#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "pongsim/simulation.hh"

namespace pongsim::test {

/// @return The `<plugin>` of one of the log systems.
inline std::string plugin(const std::string& className, const std::string& parameters) {
  return "<plugin filename='ignition-gazebo-log-system' name='ignition::gazebo::systems::" + className + "'>" +
         parameters + "</plugin>";
}

/// @return A world "w" in SDF, with physics and the given content.
inline std::string worldText(const std::string& content) {
  return "<sdf version='1.9'><world name='w'><plugin filename='ignition-gazebo-physics-system' "
         "name='ignition::gazebo::systems::Physics'/>" +
         content + "</world></sdf>";
}

/// @return A model with a box link, from which another link hangs on a hinge.
inline std::string pendulum(const std::string& name, const std::string& pose) {
  const std::string shape =
      "<inertial><mass>1</mass></inertial><collision name='c'><geometry><box><size>0.1 0.1 0.1</size></box></geometry>"
      "</collision><visual name='v'><geometry><box><size>0.1 0.1 0.1</size></box></geometry></visual>";
  return "<model name='" + name + "'><pose>" + pose + "</pose><link name='top'>" + shape +
         "</link><link name='arm'><pose>0 0.3 0 0 0 0</pose>" + shape +
         "</link><joint name='hold' type='fixed'><parent>world</parent><child>top</child></joint>"
         "<joint name='hinge' type='revolute'><pose "
         "relative_to='top'/><parent>top</parent><child>arm</child><axis><xyz>1 0 0</xyz></axis>"
         "</joint></model>";
}

/// @param options Further options of the run.
inline std::unique_ptr<Simulation> load(const std::filesystem::path& file, const SimulationOptions& options = {}) {
  Diagnostics diagnostics;
  std::unique_ptr<Simulation> simulation = Simulation::fromFile(file, options, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  return simulation;
}

}  // namespace pongsim::test
