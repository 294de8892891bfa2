#include "ros2/services/run_services.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <future>

#include "ros2/types/simulation_entity_services.hh"
#include "support/ros2/served_world.hh"

namespace pongsim::ros2::run_services_test {
namespace {

namespace si = simulation_interfaces;
namespace srv = simulation_interfaces::srv;
using State = si::SimulationState;

const std::string kBall =
    "<model name='ball'><pose>0 0 10 0 0 0</pose><link name='l'/></model>"
    "<frame name='dock'/>";
const std::string kOther = "<sdf version='1.9'><model name='other'><static>true</static><link name='l'/></model></sdf>";

class RunServicesTest : public testing::Test {
 protected:
  explicit RunServicesTest(const std::vector<std::string>& options = {"--paused"}) : world_(kBall, options) {}

  std::uint8_t state() { return world_.call<srv::GetSimulationState>("~/get_simulation_state").state.state; }
  Result setState(std::uint8_t target) {
    return world_.call<srv::SetSimulationState>("~/set_simulation_state", {{target}}).result;
  }
  Result step(std::uint64_t steps) { return world_.call<srv::StepSimulation>("~/step_simulation", {steps}).result; }
  Result reset(std::uint8_t scope) { return world_.call<srv::ResetSimulation>("~/reset_simulation", {scope}).result; }
  /// [steps of 1 ms]
  std::int64_t now() {
    const auto stamp = world_.call<srv::GetEntityState>("~/get_entity_state", {"ball"}).state.header.stamp;
    return std::int64_t{stamp.sec} * 1000 + stamp.nanosec / 1'000'000;
  }
  std::vector<std::string> entities() { return world_.call<srv::GetEntities>("~/get_entities").entities; }
  void spawnOther() {
    srv::SpawnEntity::Request request;
    request.entity_resource.resource_string = kOther;
    EXPECT_EQ(world_.call<srv::SpawnEntity>("~/spawn_entity", request).result, succeeded());
  }

  ServedWorld world_;
};

class PlayingRunServicesTest : public RunServicesTest {
 protected:
  PlayingRunServicesTest() : RunServicesTest({}) {}
};

TEST_F(RunServicesTest, TellWhatWorks) {
  const auto features = world_.call<srv::GetSimulatorFeatures>("~/get_simulator_features").features;
  std::vector<std::uint16_t> numbers = features.features;
  std::ranges::sort(numbers);
  EXPECT_EQ(numbers, (std::vector<std::uint16_t>{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12,
                                                 13, 14, 20, 23, 24, 25, 26, 31, 32, 33, 44, 50}));
  EXPECT_EQ(features.spawn_formats, (std::vector<std::string>{"sdf", "urdf"}));
}

TEST_F(RunServicesTest, TellTheWorldAndItsFile) {
  const auto response = world_.call<srv::GetCurrentWorld>("~/get_current_world");
  EXPECT_EQ(response.result, succeeded());
  EXPECT_EQ(response.world.name, "w");
  EXPECT_EQ(response.world.world_resource.uri, world_.file().string());
}

TEST_F(RunServicesTest, GoFromStateToState) {
  using Response = srv::SetSimulationState::Response;
  EXPECT_EQ(state(), State::kStateStopped);
  EXPECT_EQ(setState(State::kStateStopped).result, Response::kAlreadyInTargetState);
  EXPECT_EQ(setState(State::kStatePaused), succeeded());
  EXPECT_EQ(state(), State::kStatePaused);
  EXPECT_EQ(now(), 0);
  EXPECT_EQ(setState(State::kStatePaused).result, Response::kAlreadyInTargetState);
  EXPECT_EQ(setState(State::kStatePlaying), succeeded());
  EXPECT_EQ(state(), State::kStatePlaying);
  EXPECT_EQ(setState(State::kStatePlaying).result, Response::kAlreadyInTargetState);
  EXPECT_EQ(setState(State::kStatePaused), succeeded());
  EXPECT_EQ(state(), State::kStatePaused);
  EXPECT_GT(now(), 0);
  EXPECT_EQ(now(), now());
  EXPECT_EQ(setState(State::kStateStopped), succeeded());
  EXPECT_EQ(state(), State::kStateStopped);
  EXPECT_EQ(now(), 0);
  EXPECT_EQ(setState(State::kStatePlaying), succeeded());
  EXPECT_EQ(setState(State::kStateStopped), succeeded());
  EXPECT_EQ(state(), State::kStateStopped);
}

TEST_F(RunServicesTest, RefuseStatesThatOneWorldHasNot) {
  using Response = srv::SetSimulationState::Response;
  for (const std::uint8_t target :
       {State::kStateNoWorld, State::kStateLoadingWorld, std::uint8_t{6}, std::uint8_t{255}}) {
    const Result result = setState(target);
    EXPECT_EQ(result.result, Response::kIncorrectTransition);
    EXPECT_FALSE(result.error_message.empty());
  }
  EXPECT_EQ(state(), State::kStateStopped);
}

TEST_F(RunServicesTest, EndTheRun) {
  EXPECT_EQ(setState(State::kStateQuitting), succeeded());
  EXPECT_EQ(world_.process().wait(), 0);
}

TEST_F(RunServicesTest, MakeStepsAndAnswerWhenTheyAreMade) {
  EXPECT_EQ(step(1), succeeded());
  EXPECT_EQ(now(), 1);
  EXPECT_EQ(state(), State::kStatePaused);
  EXPECT_EQ(step(99), succeeded());
  EXPECT_EQ(now(), 100);
  EXPECT_EQ(now(), 100);
}

TEST_F(RunServicesTest, RefuseStepsThatCantBeMade) {
  EXPECT_EQ(step(0), failed("the number of steps must be above 0"));
  EXPECT_EQ(step(1ULL << 32), failed("4294967296 steps are more than 4294967295, the most for one request"));
  EXPECT_EQ(now(), 0);
  EXPECT_EQ(setState(State::kStatePlaying), succeeded());
  EXPECT_EQ(step(1), failed("the simulation is not paused"));
}

TEST_F(RunServicesTest, SayThatStepsWereStopped) {
  auto steps = std::async(std::launch::async, [&] { return step(4'000'000'000); });
  while (now() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(step(1), failed("another request is stepping"));
  EXPECT_EQ(setState(State::kStatePaused), succeeded());
  const Result result = steps.get();
  EXPECT_EQ(result, failed("the simulation was stopped after " + std::to_string(now()) + " of 4000000000 steps"));
}

TEST_F(RunServicesTest, SayThatAResetEndedTheSteps) {
  auto steps = std::async(std::launch::async, [&] { return step(4'000'000'000); });
  while (now() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(reset(0), succeeded());
  EXPECT_EQ(steps.get(), failed("the world was reset meanwhile"));
  EXPECT_EQ(state(), State::kStateStopped);
}

TEST_F(RunServicesTest, ResetAllAndStayPaused) {
  using Request = srv::ResetSimulation::Request;
  for (const int scope : {0, 255, 7}) {
    spawnOther();
    EXPECT_EQ(step(10), succeeded());
    EXPECT_EQ(entities().size(), 2U);
    EXPECT_EQ(reset(static_cast<std::uint8_t>(scope)), succeeded());
    EXPECT_EQ(now(), 0);
    EXPECT_EQ(entities(), std::vector<std::string>{"ball"});
    EXPECT_EQ(world_.call<srv::GetEntityState>("~/get_entity_state", {"ball"}).state.pose.position.z, 10);
  }
  static_assert(Request::kScopeAll == 255);
}

TEST_F(RunServicesTest, RemoveWhatWasSpawnedAndNothingElse) {
  spawnOther();
  EXPECT_EQ(step(10), succeeded());
  EXPECT_EQ(reset(srv::ResetSimulation::Request::kScopeSpawned), succeeded());
  EXPECT_EQ(entities(), std::vector<std::string>{"ball"});
  EXPECT_EQ(now(), 10);
  EXPECT_EQ(reset(srv::ResetSimulation::Request::kScopeSpawned), succeeded());
}

TEST_F(RunServicesTest, SayWhatCantBeResetAlone) {
  for (const int scope : {1, 2, 3, 5, 6}) {
    EXPECT_EQ(reset(static_cast<std::uint8_t>(scope)).result, Result::kResultFeatureUnsupported) << scope;
  }
  EXPECT_EQ(reset(8), failed("there is no scope 8"));
}

TEST_F(PlayingRunServicesTest, GoOnAfterAReset) {
  EXPECT_EQ(state(), State::kStatePlaying);
  EXPECT_EQ(reset(0), succeeded());
  EXPECT_EQ(state(), State::kStatePlaying);
}

}  // namespace
}  // namespace pongsim::ros2::run_services_test
