#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::test {

inline constexpr const char* kSensorsSystem =
    "<plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'/>";

/// @return A camera 1 m high that looks along x, with 64 by 48 pixels, the focal length 52 pixels, and the topic
/// "/cam".
/// @param more Elements of its `<camera>`.
/// @param ofSensor Elements of its `<sensor>`.
inline std::string smallCamera(const std::string& type, const std::string& more = "",
                               const std::string& ofSensor = "") {
  return "<model name='m'><static>true</static><pose>0 0 1 0 0 0</pose><link name='l'><sensor name='s' type='" + type +
         "'><topic>cam</topic>" + ofSensor +
         "<camera><horizontal_fov>1.1033099651</horizontal_fov>"
         "<image><width>64</width><height>48</height></image><clip><near>0.1</near><far>100</far></clip>" +
         more + "</camera></sensor></link></model>";
}

/// @return A visual in a static model at a place relative to that camera.
/// @param geometry "<box><size>1 1 1</size></box>"
/// @param ofVisual Elements of its `<visual>`.
/// @param ofModel Elements of its `<model>`.
inline std::string thingAt(const std::string& name, const std::string& place, const std::string& geometry,
                           const std::string& ofVisual = "", const std::string& ofModel = "") {
  return "<model name='" + name + "'><static>true</static><pose relative_to='m'>" + place +
         " 0 0 0</pose><link name='l'><visual name='v'><geometry>" + geometry + "</geometry>" + ofVisual +
         "</visual></link>" + ofModel + "</model>";
}

inline std::string boxOf(double x, double y, double z) {
  return "<box><size>" + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "</size></box>";
}

inline std::string labelled(int label) {
  return "<plugin filename='ignition-gazebo-label-system' name='ignition::gazebo::systems::Label'><label>" +
         std::to_string(label) + "</label></plugin>";
}

/// @return The messages of a world with these cameras, in its first step.
template <class M>
std::vector<M> seenOn(const std::string& topic, const std::string& content) {
  RunningWorld world(kSensorsSystem + content);
  std::vector<M> messages;
  world.listen(topic, messages);
  world.step(1);
  return messages;
}

/// Skips where there is nothing to draw with.
class DrawingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const std::string& said : RunningWorld::complaintsAbout(kSensorsSystem + smallCamera("camera"))) {
      if (said.find("libOSMesa") != std::string::npos) GTEST_SKIP() << said;
    }
  }
};

}  // namespace pongsim::test
