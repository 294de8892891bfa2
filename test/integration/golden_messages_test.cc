// Compares printed messages with those that Fortress printed for the same world: the same fields, in the same places.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"
#include "support/regex.hh"

namespace pongsim::test {
namespace {

std::string textOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// @return The message with its numbers replaced by #: names, nesting and words stay.
std::string shapeOf(const std::string& text) {
  static const Regex kNumber(": -?[0-9][-+.0-9e]*");
  // a whole second has no nanoseconds
  static const Regex kNanoseconds(" *nsec: #\n");
  return kNanoseconds.replaceAll(kNumber.replaceAll(text, ": #"), "");
}

/// @return Likewise without coordinates, which are left out if they happen to be zero.
std::string withoutCoordinates(const std::string& shape) {
  static const Regex kCoordinate(" *[xyzw]: #\n");
  return kCoordinate.replaceAll(shape, "");
}

struct Golden {
  std::string topic;
  std::string file;
  bool hasChanceZeros = false;
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
  // printed after a second, because fields that are zero are left out
  ASSERT_EQ(runToEnd({"topic", "-e", "-t", "/model/vehicle_blue/odometry", "-n", "1"}).exitCode, 0);
  const Outcome echo = runToEnd({"topic", "-e", "-t", GetParam().topic, "-n", "1"});
  ASSERT_EQ(echo.exitCode, 0) << echo.error;
  const std::string ours = shapeOf(echo.output);
  const std::string theirs = shapeOf(textOf(*golden / "messages/moving_robot" / GetParam().file));
  if (GetParam().hasChanceZeros) {
    EXPECT_EQ(withoutCoordinates(ours), withoutCoordinates(theirs));
  } else {
    EXPECT_EQ(ours, theirs);
  }
}

INSTANTIATE_TEST_SUITE_P(
    MovingRobot, GoldenMessages,
    testing::Values(Golden{"/model/vehicle_blue/odometry", "model.vehicle_blue.odometry.txt"},
                    Golden{"/model/vehicle_blue/tf", "model.vehicle_blue.tf.txt"},
                    Golden{"/world/Moving_robot/pose/info", "world.Moving_robot.pose.info.txt", true},
                    Golden{"/world/Moving_robot/dynamic_pose/info", "world.Moving_robot.dynamic_pose.info.txt", true},
                    Golden{"/clock", "clock.txt"}, Golden{"/stats", "stats.txt"},
                    Golden{"/world/Moving_robot/stats", "world.Moving_robot.stats.txt"}),
    [](const auto& instance) { return Regex("[^A-Za-z]").replaceAll(instance.param.topic, "_"); });

/// Compares the responses of services about the same world.
class GoldenReplies : public testing::Test {
 protected:
  void SetUp() override {
    const auto worlds = fortressWorlds();
    const auto golden = goldenData();
    if (!worlds || !golden) GTEST_SKIP() << "Fortress's worlds or its recorded messages are not here";
    folder_ = *golden / "messages/moving_robot";
    world_ = start({"run", (*worlds / "tutorials/moving_robot.sdf").string()});
  }

  static std::string replyOf(const std::string& service) {
    const Outcome call = runToEnd({"service", "-s", service, "--req", "", "--timeout", "60000"});
    EXPECT_EQ(call.exitCode, 0) << call.error;
    return call.output;
  }

  std::filesystem::path folder_;
  std::unique_ptr<Process> world_;
};

TEST_F(GoldenReplies, TellTheSceneWithTheFieldsOfFortress) {
  EXPECT_EQ(withoutCoordinates(shapeOf(replyOf("/world/Moving_robot/scene/info"))),
            withoutCoordinates(shapeOf(textOf(folder_ / "service.scene_info.txt"))));
}

TEST_F(GoldenReplies, DrawTheGraphOfFortress) {
  const auto named = [](const std::string& text) {
    // ids differ; their order determines the rest
    std::map<std::string, std::string> names;
    std::string result;
    const char* const digits = "0123456789";
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t begin = std::min(text.find_first_of(digits, at), text.size());
      const std::size_t end = std::min(text.find_first_not_of(digits, begin), text.size());
      result += text.substr(at, begin - at);
      const std::string id = text.substr(begin, end - begin);
      if (!id.empty()) result += names.try_emplace(id, "#" + std::to_string(names.size())).first->second;
      at = end;
    }
    return result;
  };
  EXPECT_EQ(named(replyOf("/world/Moving_robot/scene/graph")), named(textOf(folder_ / "service.scene_graph.txt")));
}

TEST_F(GoldenReplies, AreThoseOfServicesThatFortressHas) {
  replyOf("/gazebo/worlds");
  const Outcome list = runToEnd({"service", "-l"});
  for (const char* name :
       {"/gazebo/resource_paths/add", "/gazebo/resource_paths/get", "/gazebo/worlds", "/server_control",
        "/world/Moving_robot/control", "/world/Moving_robot/create", "/world/Moving_robot/create_multiple",
        "/world/Moving_robot/level/set_performer", "/world/Moving_robot/light_config", "/world/Moving_robot/remove",
        "/world/Moving_robot/scene/graph", "/world/Moving_robot/scene/info", "/world/Moving_robot/set_physics",
        "/world/Moving_robot/set_pose", "/world/Moving_robot/state", "/world/Moving_robot/state_async"}) {
    EXPECT_NE(textOf(folder_ / "services.txt").find(std::string(name) + "\n"), std::string::npos) << name;
    EXPECT_NE(list.output.find(std::string(name) + "\n"), std::string::npos) << name << "\n" << list.output;
  }
}

TEST_F(GoldenReplies, ComeBesideTheTopicsOfFortress) {
  replyOf("/gazebo/worlds");
  const Outcome list = runToEnd({"topic", "-l"});
  EXPECT_EQ(list.output, textOf(folder_ / "topics.txt"));
}

}  // namespace
}  // namespace pongsim::test
