#include "plugin/world_check.hh"

#include <gtest/gtest.h>

#include <string>

namespace pongsim::plugin {
namespace {

description::Plugin named(const std::string& filename) {
  description::Plugin made;
  made.filename = filename;
  return made;
}

description::Model model(const std::string& filename) {
  description::Model made;
  made.plugins = {named(filename)};
  description::Sensor imu;
  imu.name = "imu";
  imu.type = "imu";
  made.links.emplace_back().sensors.push_back(imu);
  return made;
}

TEST(WorldCheck, SaysWhatAWorldLacks) {
  description::World world;
  world.plugins = {named("ignition-gazebo-physics-system"), named("libMyVeryOwnPlugin.so")};
  world.models = {model("libFleetReferee.so")};
  Diagnostics diagnostics;
  checkPlugins(world, diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 2U);
  EXPECT_EQ(diagnostics.all()[0].message,
            "2 plugins were not found: they are left out: 'libMyVeryOwnPlugin.so', 'libFleetReferee.so'");
  EXPECT_EQ(diagnostics.all()[1].message, "sensor 'imu' (imu) publishes nothing: no plugin of the world simulates it");
}

TEST(WorldCheck, SaysNothingOfTheSensorsOfAModelAlone) {
  Diagnostics diagnostics;
  checkPlugins(model("libFleetReferee.so"), diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "plugin 'libFleetReferee.so' was not found: it is left out");
}

}  // namespace
}  // namespace pongsim::plugin
