#include <gtest/gtest.h>
#include <ignition/msgs/image.pb.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::free_space_explorer_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters) {
  return "<model name='m'><static>true</static><pose>0 0 0.5 0 0 0</pose><link name='head'/>"
         "<plugin filename='gz-sim-free-space-explorer-system' name='gz::sim::systems::FreeSpaceExplorer'>" +
         parameters + "</plugin></model>";
}

constexpr const char* kMap =
    "<sensor_link>head</sensor_link><width>21</width><height>21</height><resolution>1</resolution>";

void start(RunningWorld& world) { world.tellText("/start", "ignition.msgs.Boolean", "data: true"); }

/// A scan with four beams: ahead, to the left, behind, to the right.
void scan(RunningWorld& world, const std::string& ranges, const std::string& rest = "range_max: 5") {
  world.tellText("/scan", "ignition.msgs.LaserScan",
                 "angle_min: 0 angle_step: 1.5707963267948966 count: 4 " + rest + " ranges: [" + ranges + "]");
  world.step(1);
}

Vector3 place(RunningWorld& world) { return world.model("m").pose().position; }

TEST(FreeSpaceExplorer, MovesToWhereMostIsUnknown) {
  RunningWorld world(worldWith(kMap));
  std::vector<ignition::msgs::Image> images;
  world.listen("/scan_image", images);
  scan(world, "5, 2, 2, 2");
  EXPECT_TRUE(images.empty());
  start(world);
  // only ahead there is nothing
  scan(world, "inf, 2, 2, 2");
  ASSERT_EQ(images.size(), 1U);
  EXPECT_EQ(images[0].width(), 21U);
  EXPECT_EQ(images[0].step(), 63U);
  EXPECT_EQ(images[0].data().size(), 3U * 21 * 21);
  EXPECT_GT(place(world).x(), 3);
  EXPECT_NEAR(place(world).y(), 0, 1e-9);
  EXPECT_NEAR(place(world).z(), 0.5, 1e-12);
}

TEST(FreeSpaceExplorer, SeesInTheDirectionOfItsLink) {
  std::string text = worldWith(kMap);
  text.replace(text.find("<link name='head'/>"), 19,
               "<link name='head'><pose>0 0 0 0 0 1.5707963267948966</pose></link>");
  RunningWorld world(text);
  start(world);
  scan(world, "inf, 2, 2, 2");
  EXPECT_GT(place(world).y(), 3);
  EXPECT_NEAR(place(world).x(), 0, 1e-9);
}

TEST(FreeSpaceExplorer, RestsOnceNothingUnknownCanBeReached) {
  RunningWorld world(worldWith("<sensor_link>head</sensor_link><width>3</width><height>3</height>"));
  start(world);
  // eight beams to the cells around, all of them walls
  world.tellText("/scan", "ignition.msgs.LaserScan",
                 "angle_step: 0.7853981633974483 count: 8 range_max: 9 ranges: [1, 1.4, 1, 1.4, 1, 1.4, 1, 1.4]");
  world.step(1);
  EXPECT_NEAR(place(world).norm(), 0.5, 1e-9);
}

TEST(FreeSpaceExplorer, GoesOnAfterScansThatMakeNoSense) {
  RunningWorld world(worldWith(kMap));
  start(world);
  for (const char* rest : {"range_max: inf", "range_max: nan", "range_max: -1", "range_max: 0"})
    scan(world, "1, 1, 1, 1", rest);
  scan(world, "nan, -1, nan, -inf");
  world.tellText("/scan", "ignition.msgs.LaserScan", "angle_step: 1 count: 1000 range_max: 5");
  world.step(1);
  EXPECT_NEAR(place(world).norm(), 0.5, 1e-9);
  scan(world, "inf, 2, 2, 2", "range_max: 1e300");
  EXPECT_TRUE(place(world).allFinite());
}

// the rooms of the example: 9.7 m by 5.7 m inside, of which a wall of 0.3 m by 4 m takes a part
TEST(FreeSpaceExplorer, MapsTwoRooms) {
  RunningWorld world(test::projectFolder() / "plugins/tasks/free-space-explorer/free_space_explorer.sdf");
  std::vector<ignition::msgs::Image> images;
  world.listen("/scan_image", images);
  world.tellText("/start_exploration", "ignition.msgs.Boolean", "data: true");
  world.step(3000);
  ASSERT_FALSE(images.empty());
  const std::string& data = images.back().data();
  const double free = static_cast<double>(std::ranges::count(data, static_cast<char>(255))) / 3 / 16;
  EXPECT_NEAR(free, 9.7 * 5.7 - 0.3 * 4, 6);
  // it has been in the other room
  EXPECT_GT(std::ranges::count(data, static_cast<char>(0)) / 3, 100);
}

TEST(FreeSpaceExplorer, GoesOnWithTheSameBitsFromASavedStateAndBeginsAnewAfterAReset) {
  const auto file = test::projectFolder() / "plugins/tasks/free-space-explorer/free_space_explorer.sdf";
  RunningWorld world(file);
  world.tellText("/start_exploration", "ignition.msgs.Boolean", "data: true");
  world.step(120);
  RunningWorld other(file);
  test::expectSameBitsFromSavedState<ignition::msgs::Image>(world, other, 200, "/scan_image");
  test::resetWorld(other);
  other.step(200);
  EXPECT_NEAR(other.model("explorer").pose().position.x(), -2, 1e-12);
}

TEST(FreeSpaceExplorer, IsLeftOutWithTheReason) {
  const std::string left = "free-space-explorer of m is left out: ";
  for (const auto& [parameters, message] : std::vector<std::pair<std::string, std::string>>{
           {"", "<sensor_link> 'link' is not a link of model 'm'"},
           {"<sensor_link>eye</sensor_link>", "<sensor_link> 'eye' is not a link of model 'm'"},
           {"<sensor_link>head</sensor_link><width>0</width>", "<width> must be at least 1"},
           {"<sensor_link>head</sensor_link><resolution>0</resolution>", "<resolution> must be above zero"},
           {"<sensor_link>head</sensor_link><width>2000000000</width><height>2000000000</height>",
            "the map has more than a million cells"}}) {
    EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(parameters)), std::vector{left + message});
  }
}

}  // namespace
}  // namespace pongsim::free_space_explorer_test
