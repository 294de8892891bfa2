#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"

namespace pongsim::test {

inline std::string levelText(const std::string& name, const std::string& center, const std::string& ref) {
  return "<level name='" + name + "'><pose>" + center + " 0 0 0</pose><geometry><box><size>30 30 10</size></box>" +
         "</geometry><buffer>5</buffer><ref>" + ref + "</ref></level>";
}

inline std::string performerText(const std::string& model) {
  return "<performer name='perf_" + model + "'><ref>" + model +
         "</ref><geometry><box><size>1 1 1</size></box></geometry></performer>";
}

/// Fortress's test world of levels: box and sphere, which hang in the air, and tiles 0 to 5, of which the last five are
/// alone in levels of their number.
/// @param more Further content of the world.
inline std::string levelWorld(bool hasPerformers = true, const std::string& more = {}) {
  std::string text =
      "<sdf version='1.9'><world name='levels'><gravity>0 0 0</gravity><light name='sun' type='directional'/>";
  for (const char* name : {"box", "sphere"}) text += "<model name='" + std::string(name) + "'><link name='l'/></model>";
  const std::vector<std::string> places = {"10 0", "40 0", "40 20", "60 -20", "60 0", "60 20"};
  for (std::size_t i = 0; i < places.size(); ++i) {
    text += "<model name='tile_" + std::to_string(i) + "'><static>true</static><pose>" + places[i] +
            " 2.5 0 0 0</pose><link name='l'><collision name='c'><geometry><box><size>19 19 5</size></box></geometry>" +
            "</collision><visual name='v'><geometry><box><size>19 19 5</size></box></geometry></visual></link></model>";
  }
  text += more + "<plugin name='gz::sim' filename='dummy'>";
  if (hasPerformers) text += performerText("box") + performerText("sphere");
  for (std::size_t i = 1; i < places.size(); ++i) {
    const std::string number = std::to_string(i);
    text += levelText("level" + number, places[i] + " 2.5", "tile_" + number);
  }
  return text + "</plugin></world></sdf>";
}

inline std::unique_ptr<Simulation> simulate(const std::string& text, const SimulationOptions& options) {
  Diagnostics diagnostics;
  auto simulation = Simulation::fromText(text, "world.sdf", options, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  return simulation;
}

inline void place(Simulation& simulation, const char* model, const Vector3& position) {
  EXPECT_TRUE(simulation.world().model(model)->setPose({position, Quaternion::Identity()}, AfterMove::kStop));
}

}  // namespace pongsim::test
