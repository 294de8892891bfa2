#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <string>
#include <vector>

#include "integration/program.hh"

namespace pongsim::test {
namespace {

constexpr const char* kControl = "/world/pong_world/control";

Outcome call(const std::string& service, const std::string& request, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments = {"service", "-s", service, "--req", request};
  // a long timeout, although responses are quick, so that a busy machine does not fail the test
  if (std::ranges::count(more, "--timeout") == 0) more.insert(more.end(), {"--timeout", "60000"});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runToEnd(arguments);
}

/// The pong world, paused.
class Services : public testing::Test {
 protected:
  std::unique_ptr<Process> world_ = startServedWorld("pong_world.sdf", {"--paused"});
};

TEST_F(Services, AreListedSorted) {
  const Outcome list = runToEnd({"service", "-l"});
  EXPECT_EQ(list.exitCode, 0) << list.error;
  const std::vector<std::string> names = lines(list.output);
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  for (const char* name : {"/gazebo/worlds", "/server_control", kControl}) {
    EXPECT_TRUE(std::binary_search(names.begin(), names.end(), name)) << name << "\n" << list.output;
  }
}

TEST_F(Services, TellWhoOffersThem) {
  const Outcome info = runToEnd({"service", "-is", kControl});
  EXPECT_EQ(info.exitCode, 0) << info.error;
  EXPECT_EQ(info.output, "Service providers [Process, Request Message Type, Response Message Type]:\n  " +
                             std::to_string(world_->pid()) + ", ignition.msgs.WorldControl, ignition.msgs.Boolean\n");
}

TEST_F(Services, AnswerWithAndWithoutTheirTypes) {
  const Outcome short_ = call(kControl, "pause: true");
  EXPECT_EQ(short_.exitCode, 0) << short_.error;
  EXPECT_EQ(short_.output, "data: true\n\n");
  const Outcome full =
      call(kControl, "pause: true",
           {"--reqtype", "ignition.msgs.WorldControl", "--reptype", "gz.msgs.Boolean", "--timeout", "60000"});
  EXPECT_EQ(full.exitCode, 0) << full.error;
  EXPECT_EQ(full.output, "data: true\n\n");
  EXPECT_EQ(call("/gazebo/worlds", "").output, "data: \"pong_world\"\n\n");
}

TEST_F(Services, AnswerAsJsonToo) {
  EXPECT_EQ(call("/gazebo/worlds", "", {"--json"}).output, "{\"data\":[\"pong_world\"]}\n");
  const std::string providers = "{\"name\":\"" + std::string(kControl) +
                                "\",\"providers\":[{\"pid\":" + std::to_string(world_->pid()) +
                                ",\"requestType\":\"ignition.msgs.WorldControl\",\"replyType\":"
                                "\"ignition.msgs.Boolean\"}]}";
  EXPECT_EQ(runToEnd({"service", "-is", kControl, "--json"}).output, providers + "\n");
  const Outcome list = runToEnd({"service", "-l", "--json"});
  EXPECT_NE(list.output.find(providers), std::string::npos) << list.output;
}

TEST_F(Services, SetTheWorldBackWithANewSeed) {
  const Outcome alone = call(kControl, "pause: true, seed: 3");
  EXPECT_NE(alone.error.find("needs a reset: reset {all: true}"), std::string::npos) << alone.error;
  EXPECT_EQ(call(kControl, "pause: true, seed: 3, reset: {all: true}").output, "data: true\n\n");
}

TEST_F(Services, SayWhyTheyRefuse) {
  const Outcome reset = call(kControl, "reset: {time_only: true}");
  EXPECT_EQ(reset.exitCode, 1);
  EXPECT_EQ(reset.output, "");
  EXPECT_EQ(reset.error,
            "pongsim: error: service '/world/pong_world/control' refused: only the whole world can be reset: reset "
            "{all: true}\n");
  EXPECT_EQ(call("/world/pong_world/remove", "name: 'pong_bott', type: MODEL").error,
            "pongsim: error: service '/world/pong_world/remove' refused: there is no model 'pong_bott'; did you mean "
            "'pong_bot'?\n");
}

TEST_F(Services, ChangeTheWorld) {
  const std::string box =
      "sdf: \"<sdf version='1.9'><model name='crate'><link name='l'><collision name='c'><geometry><box><size>1 1 "
      "1</size>"
      "</box></geometry></collision></link></model></sdf>\", pose {position {x: 3, z: 0.5}}";
  EXPECT_EQ(call("/world/pong_world/create", box).output, "data: true\n\n");
  EXPECT_NE(call("/world/pong_world/create", box).error.find("crate"), std::string::npos);
  EXPECT_EQ(call("/world/pong_world/create", box + ", allow_renaming: true").output, "data: true\n\n");
  const Outcome poses = runToEnd({"topic", "-e", "-t", "/world/pong_world/pose/info", "-n", "1"});
  EXPECT_NE(poses.output.find("name: \"crate_0\""), std::string::npos) << poses.output;
  EXPECT_EQ(call("/world/pong_world/remove", "name: 'crate', type: MODEL").output, "data: true\n\n");
  EXPECT_EQ(runToEnd({"world", "reset"}).exitCode, 0);
}

TEST_F(Services, FailWithAReason) {
  const Outcome unknown = call("/world/pong_world/contrl", "pause: true", {"--timeout", "100"});
  EXPECT_EQ(unknown.exitCode, 1);
  EXPECT_EQ(unknown.error,
            "pongsim: error: no service /world/pong_world/contrl\n  hint: did you mean '/world/pong_world/control'?\n");
  EXPECT_EQ(runToEnd({"service", "-is", "/world/pong_world/contrl"}).error, unknown.error);
  const Outcome other = call(kControl, "data: 1", {"--reqtype", "Int32", "--reptype", "Boolean", "--timeout", "60000"});
  EXPECT_EQ(other.exitCode, 1);
  EXPECT_EQ(other.error,
            "pongsim: error: service '/world/pong_world/control' takes ignition.msgs.WorldControl and returns "
            "ignition.msgs.Boolean\n");
  const Outcome text = call(kControl, "paus: true");
  EXPECT_EQ(text.exitCode, 2);
  EXPECT_NE(text.error.find("did you mean 'pause'?"), std::string::npos) << text.error;
}

TEST_F(Services, FailInTimeWhereNobodyAnswers) {
  world_->kill(SIGSTOP);
  const Outcome silent =
      call(kControl, "pause: true", {"--reqtype", "WorldControl", "--reptype", "Boolean", "--timeout", "300"});
  world_->kill(SIGCONT);
  EXPECT_EQ(silent.exitCode, 1);
  EXPECT_NE(silent.error.find("pongsim: error: "), std::string::npos) << silent.error;
}

TEST_F(Services, EndTheRun) {
  EXPECT_EQ(call("/server_control", "stop: true").output, "data: true\n\n");
  EXPECT_EQ(world_->wait(), 0);
}

TEST(ServicesAlone, SayThatNobodyOffersOne) {
  const Outcome list = runToEnd({"service", "-l"});
  EXPECT_EQ(list.exitCode, 0);
  EXPECT_EQ(list.output, "");
  EXPECT_EQ(list.error, "pongsim: no services\n");
}

}  // namespace
}  // namespace pongsim::test
