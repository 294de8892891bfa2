#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/scene.pb.h>
#include <ignition/msgs/serialized_map.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/uint32_v.pb.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "support/ask_service.hh"

namespace pongsim::scene_broadcaster_test {
namespace {

std::string world(const std::string& plugins) {
  return R"(<sdf version="1.9"><world name="drop test">)" + plugins + R"(
    <model name="floor"><static>true</static><link name="slab"/></model>
    <model name="ball"><pose>0 1 2 0 0 1.5707963267948966</pose>
      <link name="skin"><pose>0.5 0 0 0 0 0</pose><inertial><mass>1</mass></inertial></link>
    </model>
  </world></sdf>)";
}

std::string broadcaster(const std::string& parameters) {
  return R"(<plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
            <plugin filename="ignition-gazebo-scene-broadcaster-system"
                    name="ignition::gazebo::systems::SceneBroadcaster">)" +
         parameters + "</plugin>";
}

class SceneBroadcasterTest : public testing::Test {
 protected:
  void start(const std::string& text) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(text, "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_NE(simulation_, nullptr);
    const auto listen = [this](const std::string& topic, std::vector<ignition::msgs::Pose_V>& into) {
      return simulation_->transport().node().subscribe<ignition::msgs::Pose_V>(
          topic, [&into](const auto& message) { into.push_back(message); });
    };
    allSubscription_ = listen("/world/drop_test/pose/info", all_);
    movingSubscription_ = listen("/world/drop_test/dynamic_pose/info", moving_);
  }

  /// Calls a service of the world, which goes on being paused meanwhile.
  template <class Reply>
  CallResult ask(const std::string& service, const Message& request, Reply& reply) {
    return test::askService(simulation_->transport(), "/world/drop_test" + service, request, reply,
                            [this] { simulation_->stepPaused(); });
  }

  template <class M>
  Subscription listenTo(const std::string& topic, std::vector<M>& into) {
    return simulation_->transport().node().subscribe<M>("/world/drop_test" + topic,
                                                        [&into](const M& message) { into.push_back(message); });
  }

  void insertBox(const std::string& name = "box") {
    Diagnostics diagnostics;
    simulation_->insertText("<sdf version='1.9'><model name='" + name + "'><link name='l'/></model></sdf>", "box", {},
                            diagnostics);
    EXPECT_FALSE(diagnostics.hasErrors());
  }

  std::unique_ptr<Simulation> simulation_;
  std::vector<ignition::msgs::Pose_V> all_;
  std::vector<ignition::msgs::Pose_V> moving_;
  Subscription allSubscription_;
  Subscription movingSubscription_;
};

TEST_F(SceneBroadcasterTest, TellsModelsInTheWorldAndLinksInTheirModel) {
  start(world(broadcaster("")));
  simulation_->step(2);
  ASSERT_EQ(moving_.size(), 1U);
  ASSERT_EQ(moving_[0].pose_size(), 2);
  EXPECT_EQ(moving_[0].header().stamp().nsec(), 1'000'000);
  const ignition::msgs::Pose& model = moving_[0].pose(0);
  EXPECT_EQ(model.name(), "ball");
  EXPECT_EQ(model.id(), simulation_->world().model("ball")->id().value);
  EXPECT_NEAR(model.position().y(), 1, 1e-9);
  EXPECT_NEAR(model.position().z(), 2, 1e-4);
  EXPECT_NEAR(model.orientation().z(), std::sqrt(0.5), 1e-9);
  const ignition::msgs::Pose& link = moving_[0].pose(1);
  EXPECT_EQ(link.name(), "skin");
  EXPECT_NEAR(link.position().x(), 0.5, 1e-9);
  EXPECT_NEAR(link.position().y(), 0, 1e-9);
  EXPECT_NEAR(link.orientation().w(), 1, 1e-9);
}

TEST_F(SceneBroadcasterTest, TellsWhatIsStaticOnPoseInfoOnly) {
  start(world(broadcaster("")));
  simulation_->step(2);
  ASSERT_EQ(all_.size(), 1U);
  std::vector<std::string> names;
  for (const ignition::msgs::Pose& pose : all_[0].pose()) names.push_back(pose.name());
  EXPECT_EQ(names, (std::vector<std::string>{"floor", "ball", "slab", "skin"}));
}

TEST_F(SceneBroadcasterTest, KeepsItsRateInSimulatedTime) {
  start(world(broadcaster("<dynamic_pose_hertz>30</dynamic_pose_hertz>")));
  simulation_->step(2001);
  EXPECT_NEAR(static_cast<double>(moving_.size()), 60, 1);
}

TEST_F(SceneBroadcasterTest, IsThereInAWorldThatListsNoSystem) {
  start(world(""));
  simulation_->step(2);
  EXPECT_EQ(moving_.size(), 1U);
}

TEST_F(SceneBroadcasterTest, SpeaksWhilePaused) {
  start(world(broadcaster("")));
  simulation_->stepPaused();
  simulation_->stepPaused();
  ASSERT_EQ(moving_.size(), 1U);
  EXPECT_EQ(moving_[0].pose(0).position().z(), 2);
}

TEST_F(SceneBroadcasterTest, AnswersWithTheSceneTheGraphAndTheState) {
  start(world(broadcaster("")));
  ignition::msgs::Scene scene;
  EXPECT_TRUE(ask("/scene/info", ignition::msgs::Empty(), scene));
  ASSERT_EQ(scene.model_size(), 2);
  EXPECT_EQ(scene.model(1).link(0).name(), "skin");
  ignition::msgs::StringMsg graph;
  EXPECT_TRUE(ask("/scene/graph", ignition::msgs::Empty(), graph));
  EXPECT_NE(graph.data().find("[label=\"ball ("), std::string::npos) << graph.data();
  ignition::msgs::SerializedStepMap state;
  EXPECT_TRUE(ask("/state", ignition::msgs::Empty(), state));
  EXPECT_TRUE(state.stats().paused());
  EXPECT_EQ(state.state().entities_size(), 5) << "world, floor, slab, ball, skin";
}

TEST_F(SceneBroadcasterTest, CallsBackWithTheState) {
  start(world(broadcaster("")));
  std::vector<ignition::msgs::SerializedStepMap> states;
  const Service service =
      simulation_->transport().node().serve<ignition::msgs::SerializedStepMap, ignition::msgs::Empty>(
          "/call_me", [&states](const auto& request, auto&) {
            states.push_back(request);
            return true;
          });
  ignition::msgs::StringMsg request;
  ignition::msgs::Empty reply;
  const CallResult nobody = ask("/state_async", request, reply);
  EXPECT_EQ(nobody.outcome, CallOutcome::kRefused);
  request.set_data("/call_me");
  EXPECT_TRUE(ask("/state_async", request, reply));
  while (states.empty()) simulation_->transport().dispatchFor(std::chrono::milliseconds(10));
  EXPECT_EQ(states[0].state().entities_size(), 5);
}

TEST_F(SceneBroadcasterTest, TellsOfAllThatComeOrGoBetweenTwoStepsInOneMessage) {
  start(world(broadcaster("")));
  std::vector<ignition::msgs::Scene> come;
  std::vector<ignition::msgs::UInt32_V> gone;
  const Subscription scenes = listenTo("/scene/info", come);
  const Subscription deletions = listenTo("/scene/deletion", gone);
  simulation_->step(2);
  come.clear();
  for (const char* name : {"a", "b", "c"}) insertBox(name);
  simulation_->step(2);
  ASSERT_EQ(come.size(), 1U);
  EXPECT_EQ(come[0].model_size(), 3);
  for (const char* name : {"b", "a", "c"}) simulation_->remove(*simulation_->world().model(name));
  simulation_->step(2);
  ASSERT_EQ(gone.size(), 1U);
  EXPECT_EQ(gone[0].data_size(), 3);
}

TEST_F(SceneBroadcasterTest, TellsWhoComesAndWhoGoes) {
  start(world(broadcaster("")));
  std::vector<ignition::msgs::Scene> come;
  std::vector<ignition::msgs::UInt32_V> gone;
  const Subscription scenes = listenTo("/scene/info", come);
  const Subscription deletions = listenTo("/scene/deletion", gone);
  simulation_->step(2);
  come.clear();
  insertBox();
  simulation_->step(2);
  ASSERT_EQ(come.size(), 1U);
  ASSERT_EQ(come[0].model_size(), 1);
  EXPECT_EQ(come[0].model(0).name(), "box");
  EXPECT_TRUE(gone.empty());
  simulation_->remove(*simulation_->world().model("box"));
  simulation_->step(2);
  ASSERT_EQ(gone.size(), 1U);
  ASSERT_EQ(gone[0].data_size(), 1);
  EXPECT_EQ(gone[0].data(0), come[0].model(0).id());
}

TEST_F(SceneBroadcasterTest, TellsTheWholeSceneToWhoComesLater) {
  start(world(broadcaster("")));
  simulation_->step(3);
  std::vector<ignition::msgs::Scene> first, second;
  const Subscription firstSubscription = listenTo("/scene/info", first);
  simulation_->step(3);
  ASSERT_EQ(first.size(), 1);
  EXPECT_EQ(first[0].model_size(), 2);
  insertBox();
  simulation_->step(3);
  ASSERT_EQ(first.size(), 2);
  EXPECT_EQ(first[1].model_size(), 1);
  const Subscription secondSubscription = listenTo("/scene/info", second);
  simulation_->stepPaused();
  simulation_->stepPaused();
  ASSERT_EQ(second.size(), 1);
  EXPECT_EQ(second[0].model_size(), 3);
}

TEST_F(SceneBroadcasterTest, TellsAllOfTheStateFirstAndThenWhatMoves) {
  start(world(broadcaster("<state_hertz>10</state_hertz>")));
  std::vector<ignition::msgs::SerializedStepMap> states;
  const Subscription subscription = listenTo("/state", states);
  simulation_->step(1001);
  ASSERT_NEAR(static_cast<double>(states.size()), 10, 1);
  EXPECT_EQ(states[0].state().entities_size(), 5);
  EXPECT_EQ(states[1].state().entities_size(), 2) << "ball, skin";
  insertBox();
  const std::size_t before = states.size();
  simulation_->step(2);
  ASSERT_EQ(states.size(), before + 1) << "at once";
  EXPECT_EQ(states.back().state().entities_size(), 7);
}

TEST(SceneBroadcasterParameters, RefusesARateOfZero) {
  Diagnostics diagnostics;
  Simulation::fromText(world(broadcaster("<dynamic_pose_hertz>0</dynamic_pose_hertz>")), "world.sdf", {}, diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "scene-broadcaster is left out: <dynamic_pose_hertz> must be above zero");
}

}  // namespace
}  // namespace pongsim::scene_broadcaster_test
