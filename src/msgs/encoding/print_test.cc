#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "pongsim/message.hh"
#include "support/fortress_worlds.hh"

namespace pongsim {
namespace {

MessagePointer parsed(const char* type, const std::string& text) {
  MessagePointer message = newMessage(type);
  const std::optional<MessageError> error = parseMessage(text, *message);
  EXPECT_FALSE(error) << error->message;
  return message;
}

TEST(MessageText, PutsEachFieldOnALineAndLeavesOutDefaults) {
  EXPECT_EQ(messageText(*parsed("Twist", "linear: {x: 0.5, y: 0}")), "linear {\n  x: 0.5\n}\n");
  EXPECT_EQ(messageText(*parsed("Int32", "data: 0")), "");
}

TEST(MessageText, IsReadBackAsTheSameMessage) {
  const auto message = parsed("Model", "name: 'a\\n\"b' pose {position {x: 0.1 y: -1e-300}} link {name: 'l'} link {}");
  EXPECT_EQ(parsed("Model", messageText(*message))->SerializeAsString(), message->SerializeAsString());
}

TEST(MessageText, IsWhatFortressPrints) {
  const auto golden = test::goldenData();
  if (!golden) GTEST_SKIP() << "no recorded data of Fortress here";
  const struct {
    const char* file;
    const char* type;
  } cases[] = {{"model.vehicle_blue.odometry.txt", "Odometry"},
               {"model.vehicle_blue.tf.txt", "Pose_V"},
               {"clock.txt", "Clock"},
               {"world.Moving_robot.stats.txt", "WorldStatistics"}};
  for (const auto& [file, type] : cases) {
    std::ostringstream text;
    text << std::ifstream(*golden / "messages/moving_robot" / file).rdbuf();
    // each message is followed by an empty line
    const std::string first = text.str().substr(0, text.str().find("\n\n") + 1);
    ASSERT_FALSE(first.empty()) << file;
    EXPECT_EQ(messageText(*parsed(type, first)), first) << file;
  }
}

TEST(MessageJson, IsOneLineWithCamelCaseNamesAndLargeNumbersAsStrings) {
  EXPECT_EQ(messageJson(*parsed("WorldStatistics", "sim_time {sec: 5} iterations: 12 paused: false")),
            R"({"simTime":{"sec":"5"},"iterations":"12"})");
  EXPECT_EQ(messageJson(*parsed("StringMsg", R"(data: "a\nb")")), R"({"data":"a\nb"})");
  EXPECT_EQ(messageJson(*parsed("Empty", "")), "{}");
}

}  // namespace
}  // namespace pongsim
