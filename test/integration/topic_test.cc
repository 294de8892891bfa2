#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"
#include "support/regex.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::test {
namespace {

// Long timeouts, although responses are quick, so that a busy machine does not fail the tests.
const std::vector<std::string> kPatient = {"--timeout", "60"};

Outcome publish(const std::string& topic, const std::string& type, const std::string& text) {
  std::vector<std::string> arguments = {"topic", "-t", topic, "-m", type, "-p", text};
  arguments.insert(arguments.end(), kPatient.begin(), kPatient.end());
  return runToEnd(arguments);
}

/// The pong world, running.
class Topic : public testing::Test {
 protected:
  /// Repeats the command until its output matches: on a busy machine a world may be silent for a second.
  static std::string runUntil(const std::vector<std::string>& arguments, const Regex& wanted) {
    std::string output;
    EXPECT_TRUE(waitUntil([&] { return wanted.isIn(output = runToEnd(arguments).output); })) << output;
    return output;
  }

  std::unique_ptr<Process> world_ = startWorld("pong_world.sdf");
};

TEST_F(Topic, DrivesTheRobotByAKeyPress) {
  const auto odometry = start({"topic", "--echo", "--topic", "/model/pong_bot/odometry"});
  ASSERT_TRUE(odometry->waitForOutput("child_frame_id"));
  const Outcome key = publish("/keyboard/keypress", "ignition.msgs.Int32", "data: 16777235");
  EXPECT_EQ(key.exitCode, 0) << key.error;
  EXPECT_EQ(key.output + key.error, "");
  EXPECT_TRUE(odometry->waitForOutput("position \\{\n    x: (0\\.[1-9]|[1-9]\\d*\\.\\d+\n)")) << odometry->output();
  EXPECT_TRUE(odometry->waitForOutput("linear \\{\n    x: 0\\.(5|49)")) << odometry->output();
}

TEST_F(Topic, DrawsScansAndImagesOnly) {
  const Outcome clock = runToEnd({"topic", "-e", "-t", "/clock", "--plot"});
  EXPECT_EQ(clock.exitCode, 1);
  EXPECT_EQ(clock.error,
            "pongsim: error: --plot draws ignition.msgs.LaserScan and ignition.msgs.Image, not ignition.msgs.Clock\n");
  const Outcome both = runToEnd({"topic", "-e", "-t", "/clock", "--plot", "--json"});
  EXPECT_EQ(both.exitCode, 2);
  EXPECT_EQ(both.error.substr(0, both.error.find('\n')),
            "pongsim: error: options '--plot' and '--json' can't be used together");
}

TEST_F(Topic, ListsWhatIsPublishedSorted) {
  const Outcome list = runToEnd({"topic", "-l"});
  EXPECT_EQ(list.exitCode, 0) << list.error;
  const std::vector<std::string> topics = lines(list.output);
  EXPECT_TRUE(std::is_sorted(topics.begin(), topics.end()));
  for (const char* topic : {"/clock", "/stats", "/model/pong_bot/odometry", "/world/pong_world/clock"}) {
    EXPECT_TRUE(std::binary_search(topics.begin(), topics.end(), topic)) << topic << "\n" << list.output;
  }
  // it only has subscribers
  EXPECT_FALSE(std::binary_search(topics.begin(), topics.end(), "/keyboard/keypress"));
  const std::string all = runToEnd({"topic", "-lv"}).output;
  EXPECT_NE(all.find("\n/keyboard/keypress [ignition.msgs.Int32] 0 publishers, 1 subscriber\n"), std::string::npos)
      << all;
}

TEST_F(Topic, TellsWhoPublishesAndWhoSubscribes) {
  const std::string pid = std::to_string(world_->pid());
  // independent of the machine's speed
  const Regex publisher("^Publishers \\[Process, Message Type, Rate, Messages\\]:\n  " + pid +
                        ", ignition\\.msgs\\.Clock, [1-9][0-9.]* Hz, [1-9]\\d* sent, 0 dropped\n$");
  runUntil({"topic", "-it", "/clock"}, publisher);
  const Regex subscriber("  " + pid + ", ignition\\.msgs\\.Int32, 0\\.0 Hz, 0 received, 0 dropped\n");
  const std::string key = runUntil({"topic", "-i", "-t", "/keyboard/keypress"}, subscriber);
  EXPECT_TRUE(key.starts_with("No publishers on topic [/keyboard/keypress]\nSubscribers ")) << key;
}

TEST_F(Topic, EchoesAsManyMessagesAsAskedFor) {
  const Outcome echo = runToEnd({"topic", "-et", "/world/pong_world/clock", "-n", "3"});
  EXPECT_EQ(echo.exitCode, 0) << echo.error;
  const std::vector<std::string> all = lines(echo.output);
  EXPECT_EQ(std::count(all.begin(), all.end(), "sim {"), 3) << echo.output;
  EXPECT_EQ(std::count(all.begin(), all.end(), ""), 3) << echo.output;
}

TEST_F(Topic, EchoesAsJsonALineEach) {
  const Outcome echo = runToEnd({"topic", "-et", "/clock", "-m", "gz.msgs.Clock", "-n", "2", "--json-output"});
  EXPECT_EQ(echo.exitCode, 0) << echo.error;
  const std::vector<std::string> all = lines(echo.output);
  ASSERT_EQ(all.size(), 2U) << echo.output;
  for (const std::string& line : all) EXPECT_TRUE(line.starts_with("{\"") && line.ends_with("}")) << line;
}

TEST_F(Topic, ListsAsJson) {
  const Outcome list = runToEnd({"topic", "-l", "--json"});
  EXPECT_EQ(list.exitCode, 0) << list.error;
  EXPECT_TRUE(list.output.starts_with("[{\"name\":\"/")) << list.output;
  EXPECT_NE(list.output.find("{\"name\":\"/cmd_vel\",\"types\":[\"ignition.msgs.Twist\"],\"publishers\":1,"
                             "\"subscribers\":"),
            std::string::npos)
      << list.output;
}

TEST_F(Topic, TellsOfOneAsJson) {
  const Outcome info = runToEnd({"topic", "-it", "/clock", "--json"});
  EXPECT_EQ(info.exitCode, 0) << info.error;
  EXPECT_TRUE(info.output.starts_with("{\"name\":\"/clock\",\"publishers\":[{\"pid\":" + std::to_string(world_->pid()) +
                                      ",\"type\":\"ignition.msgs.Clock\",\"hz\":"))
      << info.output;
}

TEST_F(Topic, MeasuresHowLateMessagesCome) {
  const Outcome delay = runToEnd({"topic", "-t", "/model/pong_bot/odometry", "--delay", "-n", "20"});
  EXPECT_EQ(delay.exitCode, 0) << delay.error;
  EXPECT_TRUE(Regex("(delay mean -?\\d+\\.\\d{3} ms, min -?\\d+\\.\\d{3} ms, max "
                    "-?\\d+\\.\\d{3} ms, deviation \\d+\\.\\d{3} ms, \\d+ "
                    "messages\n)+")
                  .matches(delay.output))
      << delay.output;
  const Outcome json = runToEnd({"topic", "-t", "/model/pong_bot/odometry", "--delay", "-n", "5", "--json"});
  EXPECT_TRUE(json.output.starts_with("{\"mean\":")) << json.output << json.error;
  const Outcome none = runToEnd({"topic", "-t", "/cmd_vel", "-m", "Double_V", "--delay", "-n", "1"});
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_EQ(none.error,
            "pongsim: error: ignition.msgs.Double_V has no time stamp in a header\n"
            "  hint: use --hz to measure the rate\n");
}

TEST_F(Topic, EchoesTheValuesAskedFor) {
  const Outcome one = runToEnd({"topic", "-et", "/clock", "--field", "sim.sec", "-n", "2"});
  EXPECT_EQ(one.exitCode, 0) << one.error;
  EXPECT_TRUE(Regex("\\d+\n\\d+\n").matches(one.output)) << one.output;
  const Outcome two = runToEnd({"topic", "-et", "/clock", "--field", "sim.sec", "--field", "sim", "--csv", "-n", "1"});
  EXPECT_TRUE(Regex("sim\\.sec,sim\n\\d+,\\{.*\\}\n").matches(two.output)) << two.output;
  const Outcome all = runToEnd({"topic", "-et", "/model/pong_bot/odometry", "--csv", "-n", "1"});
  const std::vector<std::string> table = lines(all.output);
  ASSERT_EQ(table.size(), 2U) << all.output;
  EXPECT_EQ(std::count(table[0].begin(), table[0].end(), ','), std::count(table[1].begin(), table[1].end(), ','));
  const Outcome wrong = runToEnd({"topic", "-et", "/clock", "--field", "sin"});
  EXPECT_EQ(wrong.exitCode, 1);
  EXPECT_EQ(wrong.error, "pongsim: error: field 'sin' is not in ignition.msgs.Clock\n  hint: did you mean 'sim'?\n");
}

TEST_F(Topic, MeasuresHowOftenAndHowMuchComes) {
  const Outcome rate = runToEnd({"topic", "-t", "/clock", "--hz", "-n", "200"});
  EXPECT_EQ(rate.exitCode, 0) << rate.error;
  EXPECT_TRUE(Regex("^[\\d.]+ Hz, spacing mean .* messages\n").isIn(rate.output)) << rate.output;
  const Outcome bandwidth = runToEnd({"topic", "-t", "/clock", "--bw", "-n", "200"});
  EXPECT_EQ(bandwidth.exitCode, 0) << bandwidth.error;
  EXPECT_TRUE(Regex("^[\\d.]+ kB/s, message mean .* messages\n").isIn(bandwidth.output)) << bandwidth.output;
  const Outcome one = runToEnd({"topic", "-t", "/clock", "--hz", "-n", "1"});
  EXPECT_EQ(one.exitCode, 1);
  EXPECT_EQ(one.error, "pongsim: error: only one message: no rate\n");
}

TEST_F(Topic, WaitsForAValue) {
  const auto wait = start({"topic", "wait", "-t", "/model/pong_bot/odometry", "--field", "pose.position.x > 0.1"});
  EXPECT_EQ(publish("/cmd_vel", "Twist", "linear: {x: 0.5}").exitCode, 0);
  EXPECT_EQ(wait->wait(), 0) << wait->error();
  EXPECT_EQ(runToEnd({"topic", "wait", "-t", "/clock"}).exitCode, 0);
  const Outcome late = runToEnd({"topic", "wait", "-t", "/clock", "--field", "sim.sec < 0", "--timeout", "1"});
  EXPECT_EQ(late.exitCode, 1);
  EXPECT_TRUE(Regex("pongsim: error: none of \\d+ messages on /clock met the condition in time\n").matches(late.error))
      << late.error;
}

TEST_F(Topic, PublishesAgainAndAgain) {
  const auto echo = start({"topic", "-et", "/again", "-m", "Int32", "-n", "4"});
  const Outcome again =
      runToEnd({"topic", "-t", "/again", "-m", "Int32", "-p", "data: 7", "--rate", "50", "-n", "4", "--timeout", "60"});
  EXPECT_EQ(again.exitCode, 0) << again.error;
  EXPECT_EQ(echo->wait(), 0) << echo->error();
  EXPECT_EQ(echo->output(), "data: 7\n\ndata: 7\n\ndata: 7\n\ndata: 7\n\n");
}

// with a short wait, as if other processes were slow to report their topics
TEST_F(Topic, PublishesToWhoIsThereHoweverShortItWaits) {
  ASSERT_EQ(runToEnd({"topic", "-et", "/clock", "-n", "1"}).exitCode, 0);
  const Outcome publish =
      runToEnd({"topic", "-t", "/cmd_vel", "-m", "Twist", "-p", "linear: {x: 0.5}", "--timeout", "0"});
  EXPECT_EQ(publish.exitCode, 0) << publish.error;
  EXPECT_EQ(runToEnd({"topic", "wait", "-t", "/model/pong_bot/odometry", "--field", "pose.position.x > 0.1"}).exitCode,
            0);
}

TEST_F(Topic, PublishesForEverUntilASignal) {
  const auto publisher =
      start({"topic", "-t", "/cmd_vel", "-m", "Twist", "-p", "linear: {x: 0.1}", "--rate", "50", "--timeout", "60"});
  EXPECT_EQ(runToEnd({"topic", "-et", "/cmd_vel", "-n", "3"}).exitCode, 0);
  publisher->kill(SIGINT);
  EXPECT_EQ(publisher->wait(), 0);
  EXPECT_EQ(publisher->error(), "");
}

TEST_F(Topic, PublishesWhatAFileSays) {
  const TempFolder folder;
  const std::string file = (folder.path() / "twist.txt").string();
  std::ofstream(file) << "linear: {x: 0.5}\n";
  const Outcome good = runToEnd({"topic", "-t", "/cmd_vel", "-m", "Twist", "--file", file, "--timeout", "60"});
  EXPECT_EQ(good.exitCode, 0) << good.error;
  std::ofstream(file) << "linear: {x: 0.5}\nangular: {w: 1}\n";
  const Outcome wrong = runToEnd({"topic", "-t", "/cmd_vel", "-m", "Twist", "--file", file});
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_TRUE(wrong.error.starts_with("pongsim: error: " + file + ":2:11: field 'w' is not in ignition.msgs.Vector3d"))
      << wrong.error;
  EXPECT_EQ(runToEnd({"topic", "-t", "/cmd_vel", "-m", "Twist", "--file", file + "x"}).exitCode, 2);
}

TEST_F(Topic, EchoesForAsLongAsAskedFor) {
  const Outcome echo = runToEnd({"topic", "-et", "/clock", "-d", "2"});
  EXPECT_EQ(echo.exitCode, 0) << echo.error;
  EXPECT_NE(echo.output, "");
}

TEST_F(Topic, EchoEndsAtASignal) {
  for (int signal : {SIGINT, SIGTERM}) {
    const auto echo = start({"topic", "-et", "/clock"});
    ASSERT_TRUE(echo->waitForOutput("sim")) << echo->error();
    echo->kill(signal);
    EXPECT_EQ(echo->wait(), 0);
    EXPECT_EQ(echo->error(), "");
  }
}

TEST_F(Topic, FailsWhereItCannotWrite) {
  testDomain();
  for (const char* what : {"-l", "-et /clock"}) {
    Process shell({"sh", "-c", std::string("'") + PONGSIM_PROGRAM + "' topic " + what + " > /dev/full"});
    EXPECT_EQ(shell.wait(), 1);
    EXPECT_TRUE(shell.error().starts_with("pongsim: error: can't write to stdout: ")) << shell.error();
  }
}

TEST_F(Topic, EchoEndsQuietlyWhenNobodyReadsItAnyMore) {
  testDomain();
  Process shell({"sh", "-c", std::string("'") + PONGSIM_PROGRAM + "' topic -et /clock --json-output | head -n 1"});
  EXPECT_EQ(shell.wait(), 0);
  EXPECT_EQ(lines(shell.output()).size(), 1U);
  EXPECT_EQ(shell.error(), "");
}

TEST_F(Topic, EchoNamesTheTypeThatThePublisherHas) {
  const Outcome echo = runToEnd({"topic", "-et", "/clock", "-m", "Twist"});
  EXPECT_EQ(echo.exitCode, 1);
  EXPECT_EQ(echo.error, "pongsim: error: the publisher of /clock has ignition.msgs.Clock, not ignition.msgs.Twist\n");
}

TEST_F(Topic, PublishNamesTheTypeThatTheSubscriberTakes) {
  const Outcome wrong = runToEnd({"topic", "-t", "/cmd_vel", "-m", "Int32", "-p", "data: 1"});
  EXPECT_EQ(wrong.exitCode, 1);
  EXPECT_EQ(wrong.error,
            "pongsim: error: the subscriber of /cmd_vel takes ignition.msgs.Twist, not ignition.msgs.Int32\n");
}

TEST_F(Topic, GuessesTheTopicThatWasMeant) {
  const char* const hint = "\n  hint: did you mean '/keyboard/keypress'?\n";
  const Outcome wrong = runToEnd({"topic", "-t", "/keyboard/keypres", "-m", "Int32", "-p", "data: 1"});
  EXPECT_EQ(wrong.exitCode, 1);
  EXPECT_EQ(wrong.error, std::string("pongsim: error: no subscriber on /keyboard/keypres") + hint);
  const Outcome info = runToEnd({"topic", "-it", "/keyboard/keypres"});
  EXPECT_EQ(info.exitCode, 1);
  EXPECT_EQ(info.error, std::string("pongsim: error: no publishers on /keyboard/keypres") + hint);
}

TEST(TopicAlone, SaysThatNobodyPublishes) {
  const Outcome list = runToEnd({"topic", "-l"});
  EXPECT_EQ(list.exitCode, 0);
  EXPECT_EQ(list.output, "");
  EXPECT_EQ(list.error, "pongsim: no topics with publishers\n");
  EXPECT_EQ(runToEnd({"topic", "-et", "/clock", "-d", "0.1"}).error, "pongsim: error: no publisher on /clock\n");
  EXPECT_EQ(runToEnd({"topic", "-t", "/x", "-m", "Int32", "-p", "", "--timeout", "0.1"}).error,
            "pongsim: error: no subscriber on /x\n");
}

TEST(TopicAlone, EchoWaitsForAPublisherAndSaysSo) {
  const auto echo = start({"topic", "-et", "/clock", "-n", "1"});
  ASSERT_TRUE(echo->waitForError("pongsim: waiting for a publisher on /clock"));
  const auto world = startWorld("pong_world.sdf");
  EXPECT_EQ(echo->wait(), 0) << echo->error();
  EXPECT_NE(echo->output().find("sim {"), std::string::npos);
}

TEST(TopicAlone, DrivesTheTutorialsRobotUnmodified) {
  const auto worlds = fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  const auto world = start({"run", (*worlds / "tutorials/moving_robot.sdf").string()});
  const auto odometry = start({"topic", "-et", "/model/vehicle_blue/odometry"});
  const Outcome drive = publish("/cmd_vel", "ignition.msgs.Twist", "linear: {x: 0.5}, angular: {z: 0.05}");
  EXPECT_EQ(drive.exitCode, 0) << drive.error;
  EXPECT_TRUE(odometry->waitForOutput("position \\{\n    x: (0\\.[1-9]|[1-9]\\d*\\.\\d+\n)"))
      << odometry->output() << world->error();
}

}  // namespace
}  // namespace pongsim::test
