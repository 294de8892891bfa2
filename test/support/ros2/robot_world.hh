#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::test {

/// A world without systems, from SDF or URDF text or from a file.
inline std::unique_ptr<Simulation> worldOf(const std::string& text) {
  Diagnostics diagnostics;
  auto simulation = Simulation::fromText(text, "world.sdf", {.loadSystems = false}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::kError) ADD_FAILURE() << format(diagnostic);
  }
  return simulation;
}
inline std::unique_ptr<Simulation> worldOfFile(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  auto simulation = Simulation::fromFile(file, {.loadSystems = false}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::kError) ADD_FAILURE() << format(diagnostic);
  }
  return simulation;
}

/// A model in a world without gravity.
inline std::string inWorld(const std::string& model) {
  return "<sdf version='1.9'><world name='w'><gravity>0 0 0</gravity>" + model + "</world></sdf>";
}

inline void expectNear(const Pose& is, const Pose& expected, double tolerance, const std::string& what) {
  EXPECT_LE((is.position - expected.position).norm(), tolerance) << what;
  EXPECT_LE(is.rotation.angularDistance(expected.rotation), tolerance) << what;
}

}  // namespace pongsim::test
