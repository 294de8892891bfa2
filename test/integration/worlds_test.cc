// Several worlds in one file, run by the actual program.

#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"
#include "support/process.hh"
#include "support/regex.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::test::worlds_test {
namespace {

constexpr const char* kThree = "three_worlds.sdf";
constexpr const char* kTimeout = "60000";

/// @return A world with the rover of diff-drive's example, under the name "rover_WORLD".
std::string roverWorld(const std::string& name, const std::string& stepSize) {
  std::ifstream file(projectFolder() / "plugins/drives/diff-drive/diff_drive.sdf");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t begin = text.find("<world name="), end = text.find("</sdf>");
  text = text.substr(begin, end - begin);
  text = Regex("diff_drive\"").replaceAll(text, name + "\"");
  text = Regex("\"rover\"").replaceAll(text, "\"rover_" + name + "\"");
  return text.insert(text.find('>') + 1,
                     "<physics name='p' type='ignored'><max_step_size>" + stepSize + "</max_step_size></physics>");
}

class SeveralWorlds : public testing::Test {
 protected:
  std::string write(const std::string& worlds) const {
    return folder_.write("worlds.sdf", "<sdf version=\"1.9\">\n" + worlds + "</sdf>\n").string();
  }
  std::string writeRovers() const {
    return write(roverWorld("maze", "0.001") + roverWorld("yard", "0.004") + roverWorld("lab", "0.001"));
  }

  const TempFolder folder_;
};

/// @return The output of `pongsim world stats` for a world.
std::string stateOf(const std::string& world) {
  const Outcome stats = runToEnd({"world", "stats", "-w", world, "-n", "1", "--timeout", kTimeout});
  EXPECT_EQ(stats.exitCode, 0) << stats.error;
  return stats.output;
}

TEST_F(SeveralWorlds, AreSaidInALineEach) {
  const Outcome outcome = runToEnd({"run", ownWorld(kThree), "--iterations", "1"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.error,
            "pongsim: world 'fine': 2 models, step 1 ms, real-time factor 1\n"
            "pongsim: world 'coarse': 2 models, step 4 ms, real-time factor 1\n"
            "pongsim: world 'fast': 2 models, step 1 ms, as fast as possible\n");
}

// three DiffDrives, each driven separately
TEST_F(SeveralWorlds, HaveTopicsAndServicesOfTheirOwn) {
  const auto process = start({"run", writeRovers()});
  ASSERT_TRUE(process->waitForError("world 'lab'")) << process->error();
  for (const char* world : {"maze", "yard", "lab"}) {
    const std::string rover = "/model/rover_" + std::string(world);
    const Outcome drive =
        runToEnd({"topic", "-t", rover + "/cmd_vel", "-m", "Twist", "-p", "linear: {x: 0.5}", "--timeout", "60"});
    EXPECT_EQ(drive.exitCode, 0) << drive.error;
    const Outcome far =
        runToEnd({"topic", "wait", "-t", rover + "/odometry", "--field", "pose.position.x > 0.05", "--timeout", "60"});
    EXPECT_EQ(far.exitCode, 0) << far.error;
    if (std::string(world) != "maze") continue;
    const Outcome other =
        runToEnd({"topic", "-et", "/model/rover_yard/odometry", "-n", "1", "--field", "twist.linear.x"});
    EXPECT_EQ(other.exitCode, 0) << other.error;
    EXPECT_LT(std::abs(std::stod(other.output)), 1e-6);
  }
  EXPECT_EQ(runToEnd({"world", "pause", "-w", "yard", "--timeout", kTimeout}).exitCode, 0);
  EXPECT_NE(stateOf("yard").find(", paused"), std::string::npos);
  EXPECT_NE(stateOf("maze").find(", running"), std::string::npos);
  const Outcome list = runToEnd({"service", "-s", "/gazebo/worlds", "--req", "", "--timeout", kTimeout});
  EXPECT_EQ(list.output, "data: \"maze\"\ndata: \"yard\"\ndata: \"lab\"\n\n") << list.error;
  const Outcome removed = runToEnd({"service", "-s", "/world/lab/create", "--timeout", kTimeout, "--req",
                                    "name: 'box', sdf: '<sdf version=\"1.9\"><model name=\"m\"><link "
                                    "name=\"l\"/></model></sdf>'"});
  EXPECT_EQ(removed.exitCode, 0) << removed.error;
  process->kill(SIGINT);
  EXPECT_EQ(process->wait(), 0) << process->error();
}

TEST_F(SeveralWorlds, AreNamedWhereACommandMeansOne) {
  const auto process = start({"run", ownWorld(kThree), "--paused"});
  ASSERT_TRUE(process->waitForError("world 'fast'")) << process->error();
  EXPECT_NE(stateOf("fast").find(" 0 iterations, paused"), std::string::npos);
  const Outcome step = runToEnd({"world", "step", "25", "-w", "coarse", "--timeout", kTimeout});
  EXPECT_EQ(step.exitCode, 0) << step.error;
  EXPECT_NE(stateOf("coarse").find("simulated 0.100 s"), std::string::npos);
  EXPECT_NE(stateOf("fine").find("simulated 0.000 s"), std::string::npos);

  const Outcome either = runToEnd({"world", "pause", "--timeout", kTimeout});
  EXPECT_EQ(either.exitCode, 1);
  EXPECT_EQ(either.error,
            "pongsim: error: several worlds are running: coarse, fast, fine\n  hint: choose with -w WORLD\n");
  // like `ign model`
  const Outcome models = runToEnd({"model", "--list", "--timeout", kTimeout});
  EXPECT_EQ(models.exitCode, 0);
  EXPECT_NE(models.output.find("- cart_fine\n"), std::string::npos) << models.output;
  EXPECT_EQ(models.error,
            "pongsim: several worlds are running: coarse, fast, fine; using fine (choose with -w WORLD)\n");
  const Outcome chosen = runToEnd({"model", "--list", "-w", "coarse", "--timeout", kTimeout});
  EXPECT_NE(chosen.output.find("- cart_coarse\n"), std::string::npos) << chosen.output;
}

TEST_F(SeveralWorlds, HaveTheSameBitsWhateverRunsBesideThem) {
  const std::string file = writeRovers();
  const std::vector<std::string> options = {"-z", "0", "--iterations", "400", "--hash", "--seed", "7"};
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"run", file});
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runToEnd(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    return lines(outcome.output);
  };
  const std::vector<std::string> all = run({});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(run({"--threads", "2"}), all);
  const std::string names[] = {"maze", "yard", "lab"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string before = "state hash of " + names[i] + ": ";
    ASSERT_TRUE(all[i].starts_with(before)) << all[i];
    EXPECT_EQ(run({"-w", names[i]}), std::vector<std::string>{"state hash: " + all[i].substr(before.size())});
  }
}

TEST_F(SeveralWorlds, EndAtASignalWhereverTheyAre) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto process = start({"run", ownWorld(kThree)});
    ASSERT_TRUE(process->waitForError("world 'fast'"));
    process->kill(signal);
    EXPECT_EQ(process->wait(), 0) << process->error();
  }
  const auto process = start({"run", ownWorld(kThree), "--paused"});
  ASSERT_TRUE(process->waitForError("world 'fast'"));
  const Outcome stop = runToEnd({"service", "-s", "/server_control", "--req", "stop: true", "--timeout", kTimeout});
  EXPECT_EQ(stop.exitCode, 0) << stop.error;
  EXPECT_EQ(process->wait(), 0) << process->error();
}

TEST_F(SeveralWorlds, AreAllReadForMistakes) {
  const std::string file = write(
      "<world name='good'/>\n"
      "<world name='bad'><model name='m'><link name='l'/><joint name='j' type='fixed'><parent>world</parent>"
      "<child>nosuch</child></joint></model></world>\n"
      "<world name='worse'><physics type='ode'><max_step_size>-1</max_step_size></physics></world>\n");
  const Outcome outcome = runToEnd({"run", file, "--iterations", "1"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.error.find("worlds.sdf:3:"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("worlds.sdf:4:"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("pongsim: 2 errors\n"), std::string::npos) << outcome.error;
}

TEST_F(SeveralWorlds, MustHaveNamesOfTheirOwn) {
  const Outcome same = runToEnd({"run", write("<world name='a'/>\n<world name='a'/>\n")});
  EXPECT_EQ(same.exitCode, 1);
  EXPECT_NE(same.error.find("worlds.sdf:3:1: error: world 'a' has the same name as another world of this file"),
            std::string::npos)
      << same.error;
  const Outcome topics = runToEnd({"run", write("<world name='a b'/>\n<world name='a_b'/>\n")});
  EXPECT_EQ(topics.exitCode, 1);
  EXPECT_NE(topics.error.find(
                "worlds.sdf:3:1: error: the topics of world 'a_b' collide with those of world 'a b': /world/a_b/..."),
            std::string::npos)
      << topics.error;
  const Outcome none = runToEnd({"run", ownWorld(kThree), "-w", "maze"});
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_NE(none.error.find("error: there is no world 'maze' in this file"), std::string::npos) << none.error;
  EXPECT_NE(none.error.find("hint: it has 'fine', 'coarse', 'fast'"), std::string::npos) << none.error;
}

/// @return A world with a failing system.
std::string faultyWorld(const std::string& name, const std::string& fault) {
  return "<world name='" + name +
         "'><plugin filename='ignition-gazebo-physics-system' name='ignition::gazebo::systems::Physics'/>"
         "<model name='m'><link name='l'/><plugin filename='misbehaving' name='test::Misbehaving'><fault>" +
         fault + "</fault></plugin></model></world>\n";
}

TEST_F(SeveralWorlds, AreNamedWhereTheirSystemsFail) {
  setenv("PONGSIM_PLUGIN_PATH", PONGSIM_TEST_SYSTEMS, 1);
  const std::string file = write("<world name='good'/>\n" + faultyWorld("bad", "throw"));
  const Outcome outcome = runToEnd({"run", file, "-z", "0", "--iterations", "50"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("error: misbehaving of m (world bad): failed in preUpdate: no more; it is switched off"),
            std::string::npos)
      << outcome.error;
  // without the fault, the other world would run forever
  const Outcome strict = runToEnd({"run", file, "--strict"});
  EXPECT_EQ(strict.exitCode, 1);
  EXPECT_EQ(lines(strict.error).back(), "pongsim: error: misbehaving of m (world bad) failed in preUpdate: no more");
  const Outcome crash = runToEnd({"run", write("<world name='good'/>\n" + faultyWorld("bad", "crash"))});
  EXPECT_GT(crash.exitCode, 0);
  EXPECT_NE(crash.error.find("crashed with SIGSEGV in the system misbehaving of m (world bad), in preUpdate\n"),
            std::string::npos)
      << crash.error;
}

TEST_F(SeveralWorlds, AreWarnedOfTopicsThatTheyShare) {
  setenv("PONGSIM_PLUGIN_PATH", PONGSIM_TEST_SYSTEMS, 1);
  const Outcome outcome =
      runToEnd({"run", write(faultyWorld("one", "throw") + faultyWorld("two", "throw")), "--iterations", "1"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("worlds.sdf:3:1: warning: world 'one' and world 'two' publish on the same topic "
                               "'/misbehave'"),
            std::string::npos)
      << outcome.error;
  EXPECT_NE(outcome.error.find("warning: world 'two' subscribes to what world 'one' publishes: topic '/misbehave'"),
            std::string::npos)
      << outcome.error;
}

TEST(NoWorld, IsAnEmptyOneWithTheDefaultSystems) {
  const auto process = start({"run"});
  ASSERT_TRUE(process->waitForError("world 'default': 0 models, step 1 ms, real-time factor 1\n")) << process->error();
  const Outcome create = runToEnd({"service", "-s", "/world/default/create", "--timeout", kTimeout, "--req",
                                   "sdf: '<sdf version=\"1.9\"><model name=\"m\"><pose>0 0 100 0 0 0</pose><link "
                                   "name=\"l\"/></model></sdf>'"});
  EXPECT_EQ(create.exitCode, 0) << create.error;
  const Outcome falling = runToEnd({"topic", "wait", "-t", "/world/default/dynamic_pose/info", "--field",
                                    "pose[0].position.z < 99.9", "--timeout", "60"});
  EXPECT_EQ(falling.exitCode, 0) << falling.error;
  process->kill(SIGINT);
  EXPECT_EQ(process->wait(), 0);
}

TEST(NoWorld, IsPausedWhenAskedForAsIgn) {
  testDomain();
  const TempFolder folder;
  const std::string ign = (folder.path() / "ign").string();
  std::filesystem::create_symlink(PONGSIM_PROGRAM, ign);
  Process process({ign, "gazebo", "-s"});
  EXPECT_TRUE(process.waitForError("world 'default': 0 models, step 1 ms, real-time factor 1, paused\n"))
      << process.error();
}

}  // namespace
}  // namespace pongsim::test::worlds_test
