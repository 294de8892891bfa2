#include <gtest/gtest.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <memory>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

constexpr const char* kInput = R"(<input type="ignition.msgs.Int32" topic="/in"><match field="data">7</match></input>)";
constexpr const char* kOutput = R"(<output type="ignition.msgs.StringMsg" topic="/out">data: "yes"</output>)";

std::string world(const std::string& parameters) {
  return R"(<sdf version="1.9"><world name="w">
    <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
    <plugin filename="ignition-gazebo-triggered-publisher-system"
            name="ignition::gazebo::systems::TriggeredPublisher">)" +
         parameters + "</plugin></world></sdf>";
}

class TriggeredPublisherTest : public testing::Test {
 protected:
  void start(const std::string& parameters) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(world(parameters), "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_NE(simulation_, nullptr);
    Node node = simulation_->transport().node();
    input_ = node.advertise<ignition::msgs::Int32>("/in");
    output_ = node.subscribe<ignition::msgs::StringMsg>(
        "/out", [this](const ignition::msgs::StringMsg& message) { received_.push_back(message.data()); });
  }

  void send(int value) {
    ignition::msgs::Int32 message;
    message.set_data(value);
    input_.publish(message);
  }

  std::unique_ptr<Simulation> simulation_;
  Publisher input_;
  Subscription output_;
  std::vector<std::string> received_;
};

TEST_F(TriggeredPublisherTest, AnswersAMatchAndNothingElse) {
  start(std::string(kInput) + kOutput);
  send(6);
  simulation_->step(3);
  EXPECT_TRUE(received_.empty());
  send(7);
  simulation_->step(3);
  EXPECT_EQ(received_, std::vector<std::string>{"yes"});
}

TEST_F(TriggeredPublisherTest, AnswersEveryMessageWithoutAMatch) {
  start(std::string(R"(<input type="ignition.msgs.Int32" topic="in"/>)") + kOutput);
  send(1);
  send(2);
  simulation_->step(3);
  EXPECT_EQ(received_.size(), 2U);
}

TEST_F(TriggeredPublisherTest, WantsAllMatchesToHold) {
  start(std::string(R"(<input type="ignition.msgs.Int32" topic="/in">
                         <match field="data" logic_type="negative">7</match>
                         <match field="data" logic_type="negative">9</match>
                       </input>)") +
        kOutput);
  for (int value : {4, 7, 9}) send(value);
  simulation_->step(3);
  EXPECT_EQ(received_.size(), 1U);
}

TEST_F(TriggeredPublisherTest, PublishesAllOutputsInOrder) {
  start(std::string(kInput) + kOutput + R"(<output type="ignition.msgs.StringMsg" topic="/out">data: "and"</output>)" +
        R"(<output type="ignition.msgs.StringMsg" topic="/out"/>)");
  send(7);
  simulation_->step(3);
  EXPECT_EQ(received_, (std::vector<std::string>{"yes", "and", ""}));
}

TEST_F(TriggeredPublisherTest, WaitsForTheDelayInSimulatedTime) {
  start(std::string(kInput) + kOutput + "<delay_ms>100</delay_ms>");
  send(7);
  simulation_->step(100);
  EXPECT_TRUE(received_.empty());
  simulation_->step(2);
  EXPECT_EQ(received_.size(), 1U);
}

TEST_F(TriggeredPublisherTest, HoldsTheDelayWhilePaused) {
  start(std::string(kInput) + kOutput + "<delay_ms>10</delay_ms>");
  send(7);
  for (int i = 0; i < 50; ++i) simulation_->stepPaused();
  EXPECT_TRUE(received_.empty());
  simulation_->step(12);
  EXPECT_EQ(received_.size(), 1U);
}

TEST_F(TriggeredPublisherTest, AnswersWhilePaused) {
  start(std::string(kInput) + kOutput);
  send(7);
  simulation_->stepPaused();
  simulation_->stepPaused();
  EXPECT_EQ(received_.size(), 1U);
}

TEST(TriggeredPublisherParameters, SaysWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {kOutput, "a TriggeredPublisher needs an <input>"},
      {kInput, "a TriggeredPublisher needs an <output>"},
      {std::string(R"(<input topic="/in"/>)") + kOutput, "<input> has no 'type' attribute"},
      {std::string(R"(<input type="ignition.msgs.Int23" topic="/in"/>)") + kOutput,
       "'ignition.msgs.Int23' is no message type\n  hint: did you mean 'ignition.msgs.Int"},
      {std::string(kInput) + R"(<output type="ignition.msgs.Twist" topic="/out">lineer: {x: 1}</output>)",
       "the text of this <output> is no ignition.msgs.Twist: "},
      {std::string(kInput) + kOutput + "<delay_ms>-1</delay_ms>", "<delay_ms> must not be negative"}};
  for (const auto& [parameters, message] : cases) {
    Diagnostics diagnostics;
    EXPECT_NE(Simulation::fromText(world(parameters), "world.sdf", {}, diagnostics), nullptr) << parameters;
    ASSERT_EQ(diagnostics.all().size(), 1U) << parameters;
    const std::string text = format(diagnostics.all()[0]);
    EXPECT_NE(text.find("triggered-publisher is left out: " + message), std::string::npos) << text;
    EXPECT_EQ(text.find("world.sdf:"), 0U) << text;
  }
}

}  // namespace
}  // namespace pongsim
