// What another user of this machine can do with a run: the rows of docs/security.md. These tests start as root.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::test {
namespace {

constexpr const char* kNobody = "65534";

/// A folder that only its owner can enter, in one that all can.
class OtherUser : public testing::Test {
 protected:
  void SetUp() override {
    if (geteuid() != 0) GTEST_SKIP() << "only root can start a program as another user";
    testDomain();
    if (const Outcome version = asOther({"--version"}); version.exitCode != 0)
      GTEST_SKIP() << "another user can't start the program (setpriv): " << version.error;
    chmod(folder_.path().c_str(), 0755);
    std::filesystem::create_directory(privateFolder());
    chmod(privateFolder().c_str(), 0700);
  }

  /// Runs the program as another user until it ends.
  static Outcome asOther(std::vector<std::string> arguments) {
    std::vector<std::string> all{"setpriv", "--reuid", kNobody, "--regid", kNobody, "--clear-groups", PONGSIM_PROGRAM};
    all.insert(all.end(), arguments.begin(), arguments.end());
    Process process(all, {.environment = {{"HOME", "/"}}, .folder = "/"});
    const int exitCode = process.wait().value_or(-1);
    return {exitCode, process.output(), process.error()};
  }
  static Outcome callAsOther(const std::string& service, const std::string& request) {
    return asOther({"service", "-s", service, "--req", request, "--timeout", "60000"});
  }
  std::filesystem::path privateFolder() const { return folder_.path() / "private"; }

  TempFolder folder_;
};

TEST_F(OtherUser, ReadsTopicsAndSendsCommandsWithoutAKeystore) {
  const auto world = startServedWorld("pong_world.sdf");
  EXPECT_EQ(asOther({"topic", "-et", "/clock", "-n", "1"}).exitCode, 0);
  const Outcome paused = callAsOther("/world/pong_world/control", "pause: true");
  EXPECT_EQ(paused.output, "data: true\n\n") << paused.error;
}

TEST_F(OtherUser, StopsTheWorldWithoutAKeystore) {
  const auto world = startServedWorld("pong_world.sdf");
  const Outcome stopped = callAsOther("/server_control", "stop: true");
  EXPECT_EQ(stopped.output, "data: true\n\n") << stopped.error;
  EXPECT_EQ(world->wait(), 0) << world->error();
}

TEST_F(OtherUser, RunsNoCode) {
  const auto world = startServedWorld("pong_world.sdf");
  const std::string library = std::string(PONGSIM_TEST_SYSTEMS) + "/libmisbehaving.so";
  callAsOther("/world/pong_world/create",
              "sdf: \"<sdf version='1.9'><model name='m'><link name='l'/><plugin filename='" + library +
                  "' name='x'/></model></sdf>\"");
  EXPECT_TRUE(world->waitForError("is a path, which is not allowed here: it is left out")) << world->error();
}

TEST_F(OtherUser, WritesNoFiles) {
  const auto world = startServedWorld("pong_world.sdf");
  const std::string recording = (folder_.path() / "recording").string();
  callAsOther("/world/pong_world/create",
              "sdf: \"<sdf version='1.9'><model name='m'><link name='l'/><plugin filename='ignition-gazebo-log-system' "
              "name='ignition::gazebo::systems::LogRecord'><path>" +
                  recording + "</path></plugin></model></sdf>\"");
  EXPECT_TRUE(world->waitForError("log of m is left out: it belongs in a <world>")) << world->error();
  EXPECT_FALSE(std::filesystem::exists(recording));
}

TEST_F(OtherUser, GetsNoContentOfPrivateFiles) {
  const auto world = startServedWorld("pong_world.sdf");
  folder_.write("private/secret.sdf", "<sdf version='1.9'><model name='m'><secret-word/></model>");
  const Outcome created =
      callAsOther("/world/pong_world/create", "sdf_filename: \"" + (privateFolder() / "secret.sdf").string() + "\"");
  EXPECT_EQ((created.output + created.error).find("secret-word"), std::string::npos) << created.output << created.error;
}

TEST_F(OtherUser, SeesAndDoesNothingWithAKeystore) {
  const std::string keys = (privateFolder() / "keys").string();
  if (const Outcome made = runToEnd({"security", "init", keys}); made.exitCode != 0)
    GTEST_SKIP() << "pongsim security is missing: " << made.error;
  const auto world = startWorld("pong_world.sdf", {"--secure", keys});
  EXPECT_EQ(runToEnd({"topic", "-et", "/clock", "-n", "1", "--secure", keys}).exitCode, 0);
  EXPECT_EQ(asOther({"topic", "-l"}).output, "");
  const Outcome call =
      asOther({"service", "-s", "/world/pong_world/control", "--req", "pause: true", "--timeout", "300"});
  EXPECT_NE(call.exitCode, 0) << call.output;
  // nor does the key help, which it can't read
  const Outcome listed = asOther({"topic", "-l", "--secure", keys});
  EXPECT_EQ(listed.exitCode, 1) << listed.output;
}

}  // namespace
}  // namespace pongsim::test
