// What the program prints beside what Fortress printed for the same world: the same fields, in the same places.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::test {
namespace {

std::string textOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// @return The message with its numbers replaced by #: names, nesting and words stay.
std::string shapeOf(const std::string& text) {
  static const std::regex kNumber(": -?[0-9][-+.0-9e]*");
  // a time that is a whole second has no nanoseconds
  static const std::regex kNanoseconds(" *nsec: #\n");
  return std::regex_replace(std::regex_replace(text, kNumber, ": #"), kNanoseconds, "");
}

struct Golden {
  std::string topic;
  std::string file;
};

void PrintTo(const Golden& golden, std::ostream* stream) { *stream << golden.topic; }

class GoldenMessages : public testing::TestWithParam<Golden> {};

TEST_P(GoldenMessages, HaveTheFieldsOfFortress) {
  const auto worlds = fortressWorlds();
  const auto golden = goldenData();
  if (!worlds || !golden) GTEST_SKIP() << "Fortress's worlds or its recorded messages are not here";
  const auto world = start({"run", (*worlds / "tutorials/moving_robot.sdf").string()});
  const Outcome drive = runToEnd({"topic", "-t", "/cmd_vel", "-m", "ignition.msgs.Twist", "-p",
                                  "linear: {x: 0.5}, angular: {z: 0.05}", "--timeout", "60"});
  ASSERT_EQ(drive.exitCode, 0) << drive.error << world->error();
  // comes after a second, before which fields of whole seconds would be left out
  ASSERT_EQ(runToEnd({"topic", "-e", "-t", "/model/vehicle_blue/odometry", "-n", "1"}).exitCode, 0);
  const Outcome echo = runToEnd({"topic", "-e", "-t", GetParam().topic, "-n", "1"});
  ASSERT_EQ(echo.exitCode, 0) << echo.error;
  EXPECT_EQ(shapeOf(echo.output), shapeOf(textOf(*golden / "messages/moving_robot" / GetParam().file)));
}

INSTANTIATE_TEST_SUITE_P(MovingRobot, GoldenMessages,
                         testing::Values(Golden{"/model/vehicle_blue/odometry", "model.vehicle_blue.odometry.txt"},
                                         Golden{"/model/vehicle_blue/tf", "model.vehicle_blue.tf.txt"},
                                         Golden{"/clock", "clock.txt"}, Golden{"/stats", "stats.txt"},
                                         Golden{"/world/Moving_robot/stats", "world.Moving_robot.stats.txt"}),
                         [](const auto& instance) {
                           return std::regex_replace(instance.param.topic, std::regex("[^A-Za-z]"), "_");
                         });

}  // namespace
}  // namespace pongsim::test
