#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/regex.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::test {
namespace {

constexpr const char* kWorld = "pong_world.sdf";

/// @return The output of `--hash` after this many steps.
std::string hashAfter(const char* iterations) {
  const Outcome outcome = runToEnd({"run", ownWorld(kWorld), "-z", "0", "--iterations", iterations, "--hash"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_TRUE(Regex("state hash: [0-9a-f]{16}\n").matches(outcome.output)) << outcome.output;
  return outcome.output;
}

TEST(Run, GivesTheSameStateHashTwice) {
  const std::string first = hashAfter("500");
  EXPECT_EQ(hashAfter("500"), first);
  EXPECT_NE(hashAfter("501"), first);
}

TEST(Run, PrintsTheStateHashAsOftenAsAsked) {
  const Outcome outcome =
      runToEnd({"run", ownWorld(kWorld), "-z", "0", "--iterations", "500", "--hash-every", "200", "--hash"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  const Regex::Match found = Regex(
                                 "^state hash after 200: ([0-9a-f]{16})\n"
                                 "state hash after 400: ([0-9a-f]{16})\n(state hash: [0-9a-f]{16}\n)$")
                                 .firstIn(outcome.output);
  ASSERT_EQ(found.size(), 4U) << outcome.output;
  EXPECT_NE(found[1], found[2]);
  EXPECT_EQ("state hash: " + found[1] + "\n", hashAfter("200"));
  EXPECT_EQ(found[3], hashAfter("500"));
}

TEST(Run, MakesFaultsOnPurposeInAnyWorld) {
  const auto with = [](const std::string& fault) {
    return runToEnd({"run", ownWorld(kWorld), "-z", "0", "--iterations", "100", "--hash", "--fault", fault});
  };
  const Outcome wrong = with("stick joint=pong_bot::left_whel_joint");
  EXPECT_EQ(wrong.exitCode, 1);
  EXPECT_NE(wrong.error.find("--fault:1:7: error: there is no joint 'pong_bot::left_whel_joint'\n"
                             "  hint: did you mean 'pong_bot::left_wheel_joint'?"),
            std::string::npos)
      << wrong.error;
  EXPECT_EQ(with("joint=pong_bot::left_wheel_joint").exitCode, 2);
  const Outcome right = with("stick joint=pong_bot::left_wheel_joint from=0.05 to=0.06");
  EXPECT_EQ(right.exitCode, 0) << right.error;
  EXPECT_EQ(right.output, with("stick joint=pong_bot::left_wheel_joint from=0.05 to=0.06").output);
}

TEST(Run, NeedsANumberOfStepsBetweenStateHashes) {
  for (const char* wrong : {"0", "-5", "1.5", "often"}) {
    const Outcome outcome = runToEnd({"run", ownWorld(kWorld), "--hash-every", wrong});
    EXPECT_EQ(outcome.exitCode, 2) << wrong;
    EXPECT_NE(outcome.error.find("--hash-every"), std::string::npos) << outcome.error;
  }
}

/// The environment of a process: address layout, memory content, number of threads, time of day.
struct Surroundings {
  const char* what;
  /// Commands before the program's name.
  std::vector<std::string> launcher;
  std::map<std::string, std::string> environment;
  std::string threads = "1";
};

TEST(Run, GivesTheSameStateHashWhateverSurroundsIt) {
  const std::string expected = hashAfter("1500");
  const Surroundings all[] = {
      {"addresses that are not random", {"setarch", "-R"}, {}},
      {"freed memory overwritten", {}, {{"MALLOC_PERTURB_", "165"}}},
      {"one heap for all", {}, {{"MALLOC_ARENA_MAX", "1"}, {"MALLOC_TOP_PAD_", "1"}}},
      {"another time of day and another tongue", {}, {{"TZ", "Asia/Kathmandu"}, {"LC_ALL", "C.UTF-8"}}},
      {"two threads", {}, {}, "2"},
      {"four threads, freed memory overwritten", {}, {{"MALLOC_PERTURB_", "90"}}, "4"}};
  for (const Surroundings& each : all) {
    std::vector<std::string> arguments = each.launcher;
    const std::vector<std::string> command = {PONGSIM_PROGRAM, "run",  ownWorld(kWorld), "-z",        "0",
                                              "--iterations",  "1500", "--hash",         "--threads", each.threads};
    arguments.insert(arguments.end(), command.begin(), command.end());
    testDomain();
    Process process(arguments, {.environment = each.environment, .folder = {}});
    EXPECT_EQ(process.wait(), 0) << each.what << ": " << process.error();
    EXPECT_EQ(process.output(), expected) << each.what;
  }
}

// without subscribers: the camera renders to save images
TEST(Run, SavesTheSamePicturesWithAnyNumberOfThreads) {
  const TempFolder folder;
  const auto picturesOf = [&folder](const std::string& name, const std::string& threads, const std::string& drawers) {
    const auto world = folder.write(name + ".sdf", R"(<sdf version="1.9"><world name="w">
      <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
      <plugin filename="ignition-gazebo-sensors-system" name="ignition::gazebo::systems::Sensors"/>
      <light name="sun" type="directional"><cast_shadows>true</cast_shadows></light>
      <model name="eye"><static>true</static><link name="l"><sensor name="s" type="camera"><update_rate>50</update_rate>
        <camera><image><width>64</width><height>48</height></image><save enabled="true"><path>)" +
                                                       (folder.path() / name).string() +
                                                       R"(</path></save>
          <noise><type>gaussian</type><stddev>0.02</stddev></noise></camera></sensor></link></model>
      <model name="a"><pose>4 0.8 1 0.3 0.2 0</pose><link name="l"><visual name="v"><geometry><box/></geometry></visual></link>
      </model><model name="b"><pose>4 -0.8 1 0 0.2 0.5</pose><link name="l"><visual name="v"><geometry><sphere/></geometry>
      </visual></link></model></world></sdf>)");
    testDomain();
    Process process({PONGSIM_PROGRAM, "run", world.string(), "-z", "0", "--iterations", "200", "--threads", threads},
                    {.environment = {{"LP_NUM_THREADS", drawers}}, .folder = {}});
    EXPECT_EQ(process.wait(), 0) << process.error();
    std::map<std::string, std::string> pictures;
    if (process.error().find("libOSMesa") != std::string::npos) return pictures;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / name)) {
      std::ifstream file(entry.path(), std::ios::binary);
      pictures[entry.path().filename().string()] = {std::istreambuf_iterator<char>(file), {}};
    }
    return pictures;
  };
  const auto expected = picturesOf("first", "1", "0");
  if (expected.empty()) GTEST_SKIP() << "libosmesa6 is not here";
  EXPECT_EQ(expected.size(), 11U);
  EXPECT_NE(expected.begin()->second, expected.rbegin()->second);
  EXPECT_TRUE(picturesOf("second", "1", "2") == expected);
  EXPECT_TRUE(picturesOf("third", "2", "1") == expected);
}

TEST(Run, EndsWithExitCode0AtSigintAndSigterm) {
  for (int signal : {SIGINT, SIGTERM}) {
    const auto process = startWorld(kWorld);
    process->kill(signal);
    EXPECT_EQ(process->wait(), 0) << process->error();
    EXPECT_EQ(process->output(), "");
  }
}

TEST(Run, EndsAtASignalWhilePaused) {
  const auto process = startWorld(kWorld, {"--paused"});
  process->kill(SIGTERM);
  EXPECT_EQ(process->wait(), 0);
}

TEST(Run, SaysInOneLineWhatItRuns) {
  const Outcome outcome = runToEnd({"run", ownWorld(kWorld), "-r", "--iterations", "1"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_TRUE(Regex("pongsim: world 'pong_world': \\d+ models, step 1 ms, real-time factor 1\n").matches(outcome.error))
      << outcome.error;
}

// As seen by a service manager: ready when the world has been loaded, stopping at its end.
TEST(Run, TellsWhoWaitsForItWhenItIsReadyAndWhenItStops) {
  const TempFolder folder;
  const std::string path = (folder.path() / "notify").string();
  const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  const timeval patience{60, 0};
  setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  const auto next = [socket] {
    char text[256];
    const ssize_t length = recv(socket, text, sizeof text, 0);
    return std::string(text, length < 0 ? 0 : static_cast<std::size_t>(length));
  };

  testDomain();
  Process process({PONGSIM_PROGRAM, "run", ownWorld(kWorld)}, {.environment = {{"NOTIFY_SOCKET", path}}, .folder = {}});
  EXPECT_TRUE(next().starts_with("READY=1\nSTATUS=world 'pong_world': "));
  EXPECT_EQ(
      runToEnd({"service", "-s", "/world/pong_world/control", "--req", "pause: true", "--timeout", "60000"}).exitCode,
      0);
  process.kill(SIGTERM);
  EXPECT_EQ(next(), "STOPPING=1\n");
  EXPECT_EQ(process.wait(), 0) << process.error();
  close(socket);
}

TEST(Run, PutsARobotInUrdfOnTheGround) {
  const TempFolder folder;
  const auto file = folder.write(
      "ball.urdf",
      "<robot name='ball'><origin xyz='0 0 2'/><link name='l'><inertial><mass value='1'/><inertia ixx='1' ixy='0' "
      "ixz='0' "
      "iyy='1' iyz='0' izz='1'/></inertial><collision><geometry><sphere radius='0.5'/></geometry></collision></link>"
      "</robot>");
  const auto process = startWorld(file.string());
  const Outcome pose = runToEnd({"topic", "-et", "/world/default/dynamic_pose/info", "-n", "1"});
  EXPECT_EQ(pose.exitCode, 0) << pose.error;
  EXPECT_NE(pose.output.find("name: \"ball\""), std::string::npos) << pose.output;
}

TEST(Run, SaysNothingAtLevel0) {
  const Outcome outcome = runToEnd({"run", ownWorld(kWorld), "-v", "0", "--iterations", "1"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.error + outcome.output, "");
}

TEST(Run, StandsStillWhilePaused) {
  const auto process = startWorld(kWorld, {"--paused"});
  const Outcome echo = runToEnd({"topic", "-et", "/world/pong_world/stats", "-n", "2"});
  EXPECT_EQ(echo.exitCode, 0) << echo.error;
  EXPECT_NE(echo.output.find("paused: true"), std::string::npos) << echo.output;
  EXPECT_EQ(echo.output.find("iterations"), std::string::npos) << echo.output;
}

TEST(Run, FindsAWorldByItsNameInTheResourcePath) {
  testDomain();
  const Process::Options options{.environment = {{"IGN_GAZEBO_RESOURCE_PATH", ownWorld("")}}, .folder = "/"};
  Process process({PONGSIM_PROGRAM, "run", kWorld, "--iterations", "1", "-z", "0"}, options);
  EXPECT_EQ(process.wait(), 0) << process.error();
}

// as Fortress's tutorials call it, through a link
TEST(Run, IsCalledAsIgnToo) {
  testDomain();
  const TempFolder folder;
  const std::string ign = (folder.path() / "ign").string();
  std::filesystem::create_symlink(PONGSIM_PROGRAM, ign);
  Process runs({ign, "gazebo", "-s", "-r", "-v", "4", ownWorld("pong_world.sdf"), "--iterations", "10"});
  EXPECT_EQ(runs.wait(), 0) << runs.error();
  Process window({ign, "gazebo", "-g", "empty.sdf"});
  EXPECT_EQ(window.wait(), 2);
  EXPECT_TRUE(window.error().starts_with("pongsim: error: '-g' is not supported: pongsim has no GUI"))
      << window.error();
}

}  // namespace
}  // namespace pongsim::test
