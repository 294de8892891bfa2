#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"

namespace pongsim::triggered_publisher_test {
namespace {

constexpr const char* kInput = R"(<input type="ignition.msgs.Int32" topic="/in"><match field="data">7</match></input>)";
constexpr const char* kOutput = R"(<output type="ignition.msgs.StringMsg" topic="/out">data: "yes"</output>)";

std::string plugin(const std::string& parameters) {
  return R"(<plugin filename="ignition-gazebo-triggered-publisher-system"
            name="ignition::gazebo::systems::TriggeredPublisher">)" +
         parameters + "</plugin>";
}

std::string worldAround(const std::string& plugins) {
  return R"(<sdf version="1.9"><world name="w">
    <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>)" +
         plugins + "</world></sdf>";
}

std::string world(const std::string& parameters) { return worldAround(plugin(parameters)); }

class TriggeredPublisherTest : public testing::Test {
 protected:
  void start(const std::string& parameters) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(world(parameters), "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_NE(simulation_, nullptr);
    connect();
  }

  void connect() {
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

/// @return What is said about a world with several TriggeredPublishers.
std::vector<std::string> complaintsAbout(const std::vector<std::string>& publishers) {
  std::string all;
  for (const std::string& parameters : publishers) all += plugin(parameters);
  Diagnostics diagnostics;
  EXPECT_NE(Simulation::fromText(worldAround(all), "world.sdf", {}, diagnostics), nullptr);
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    messages.push_back(diagnostic.message);
    EXPECT_GT(diagnostic.position.line, 0);
  }
  return messages;
}

/// A TriggeredPublisher from a number on one topic to a number on another.
std::string relay(const std::string& from, const std::string& match, const std::string& to, const std::string& value,
                  const std::string& rest = "") {
  return "<input type='ignition.msgs.Int32' topic='" + from + "'>" +
         (match.empty() ? "" : "<match field='data'>" + match + "</match>") +
         "</input><output type='ignition.msgs.Int32' topic='" + to + "'>data: " + value + "</output>" + rest;
}

TEST(TriggeredPublisherLoop, IsNamedAndNotClosed) {
  const std::string left = "triggered-publisher is left out: its own output would trigger it forever: ";
  EXPECT_EQ(complaintsAbout({relay("/a", "", "a", "1")}), std::vector<std::string>{left + "/a -> /a"});
  EXPECT_EQ(complaintsAbout({relay("/a", "1", "/b", "2"), relay("/b", "2", "/c", "3"), relay("/c", "", "/a", "1")}),
            std::vector<std::string>{left + "/c -> /a -> /b -> /c"});
}

TEST(TriggeredPublisherLoop, IsNoneWhereAMatchEndsItOrADelayPacesIt) {
  EXPECT_EQ(complaintsAbout({relay("/a", "1", "/a", "2")}), std::vector<std::string>());
  EXPECT_EQ(complaintsAbout({relay("/a", "1", "/b", "2"), relay("/b", "3", "/a", "1")}), std::vector<std::string>());
  EXPECT_EQ(complaintsAbout({relay("/a", "", "/b", "1"), relay("/b", "", "/a", "1", "<delay_ms>9</delay_ms>")}),
            std::vector<std::string>());
}

TEST_F(TriggeredPublisherTest, CallsServicesOneAfterAnother) {
  start(std::string(kInput) +
        "<service name='/first' reqType='StringMsg' repType='Boolean' timeout='5000' reqMsg='data: \"a\"'/>"
        "<service name='/second' reqType='StringMsg' repType='Boolean' timeout='5000' reqMsg='data: \"b\"'/>");
  std::vector<std::string> requests;
  const auto answer = [&](const ignition::msgs::StringMsg& request, ignition::msgs::Boolean&) {
    requests.push_back(request.data());
    return ServiceAnswer(true);
  };
  Node node = simulation_->transport().node();
  const Service first = node.serve<ignition::msgs::StringMsg, ignition::msgs::Boolean>("/first", answer);
  const Service second = node.serve<ignition::msgs::StringMsg, ignition::msgs::Boolean>("/second", answer);
  send(7);
  send(7);
  while (requests.size() < 4) simulation_->transport().dispatchFor(std::chrono::seconds(5));
  EXPECT_EQ(requests, (std::vector<std::string>{"a", "b", "a", "b"}));
}

TEST(TriggeredPublisherParameters, LeaveOutMatchesWithoutText) {
  const std::string empty = "<input type='ignition.msgs.Int32' topic='/in'><match/><match>data: 7</match></input>";
  const std::string said = "a <match> without text is ignored";
  EXPECT_EQ(complaintsAbout({empty + kOutput}), std::vector<std::string>{said});
  EXPECT_EQ(complaintsAbout({std::string("<input type='ignition.msgs.Int32' topic='/in'><match/></input>") + kOutput}),
            (std::vector<std::string>{said, "triggered-publisher is left out: no <match> is left"}));
}

TEST_F(TriggeredPublisherTest, PublishesWhatItCanReadOfAnOutput) {
  Diagnostics diagnostics;
  simulation_ = Simulation::fromText(
      world(std::string(kInput) + "<output type='ignition.msgs.StringMsg' topic='/out'>data: 'x' wrong: 1</output>"),
      "world.sdf", {}, diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_NE(diagnostics.all()[0].message.find("the text of this <output> is not of type ignition.msgs.StringMsg: "),
            std::string::npos);
  connect();
  send(7);
  simulation_->step(3);
  EXPECT_EQ(received_, std::vector<std::string>{"x"});
}

TEST(TriggeredPublisherParameters, SaysWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {kOutput, "a TriggeredPublisher needs an <input>"},
      {kInput, "a TriggeredPublisher needs an <output> or a <service>"},
      {std::string(R"(<input topic="/in"/>)") + kOutput, "<input> has no 'type' attribute"},
      {std::string(R"(<input type="ignition.msgs.Int23" topic="/in"/>)") + kOutput,
       "'ignition.msgs.Int23' is not a message type\n  hint: did you mean 'ignition.msgs.Int"},
      {std::string(kInput) + "<service name='/s' reqType='Empty' repType='Empty'/>",
       "<service> has no 'timeout' attribute"},
      {std::string(kInput) + "<service name='/s' reqType='StringMsg' repType='Empty' timeout='9' reqMsg='dat: 1'/>",
       "the 'reqMsg' of this <service> is not of type StringMsg: "},
      {std::string(kInput) + kOutput + "<delay_ms>-1</delay_ms>", "<delay_ms> must be zero or more"}};
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
}  // namespace pongsim::triggered_publisher_test
