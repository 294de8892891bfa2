#include "description/model_sensors.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pongsim::description {
namespace {

Sensor sensorNamed(const std::string& name) {
  Sensor sensor;
  sensor.name = name;
  return sensor;
}

TEST(ModelSensors, AreThoseOfLinksJointsAndNestedModels) {
  Model inner;
  inner.links.emplace_back().sensors = {sensorNamed("inner")};
  Model model;
  model.models = {inner};
  model.joints.emplace_back().sensors = {sensorNamed("joint")};
  model.links.emplace_back().sensors = {sensorNamed("a"), sensorNamed("b")};
  std::vector<std::string> names;
  forEachSensor(model, [&](const Sensor& sensor) { names.push_back(sensor.name); });
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b", "joint", "inner"}));
}

}  // namespace
}  // namespace pongsim::description
