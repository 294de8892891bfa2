#include "pongsim/expect/monitor.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/double_v.pb.h>

#include <string>

#include "pongsim/actor.hh"
#include "support/running_world.hh"

namespace pongsim::test {
namespace {

using Kind = Signal::Kind;
using Mode = Expectation::Mode;
using Relation = Criterion::Relation;
using State = Verdict::State;

/// A ball of 1 m that falls from 2 m onto the ground, and an arm.
const std::string kBall = R"(
  <model name="ground"><static>true</static><link name="link"><collision name="c"><geometry><plane/></geometry>
  </collision></link></model>
  <model name="ball"><pose>0 0 2 0 0 0</pose><link name="link"><inertial><mass>2</mass></inertial>
    <collision name="c"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision></link></model>
  <model name="arm"><pose>5 0 1 0 0 0</pose><link name="base"/><link name="rod"/>
    <joint name="hold" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="hinge" type="revolute"><parent>base</parent><child>rod</child><axis><xyz>0 0 1</xyz></axis></joint>
  </model>)";

class MonitorTest : public testing::Test {
 protected:
  Criterion below(const char* field, double value) {
    return {.field = field, .relation = Relation::kBelow, .number = value};
  }

  Expectation expectation(Mode mode, Event event, double to = 0) {
    Expectation result{.mode = mode, .events = {std::move(event)}};
    if (to > 0) result.to = fromSeconds(to);
    return result;
  }

  std::size_t add(Expectation expected) {
    const Outcome<std::size_t> number = monitor_.add(std::move(expected));
    EXPECT_TRUE(number) << number.error;
    return number.value.value_or(0);
  }

  std::string errorOf(Event event) { return monitor_.add(expectation(Mode::kEventually, std::move(event))).error; }

  Verdict verdictAfter(double seconds, std::size_t number) {
    while (world_.simulation().time() < fromSeconds(seconds)) monitor_.runUntil(fromSeconds(seconds));
    monitor_.finish();
    return monitor_.verdict(number);
  }

  Publisher flags() { return world_.simulation().transport().node().advertise<ignition::msgs::Boolean>("/flag"); }
  static void publish(Publisher& publisher, bool data) {
    ignition::msgs::Boolean message;
    message.set_data(data);
    publisher.publish(message);
  }

  RunningWorld world_{kBall};
  Monitor monitor_{world_.simulation()};
};

TEST_F(MonitorTest, SeesAPoseWhenItComes) {
  const auto number = add(expectation(Mode::kEventually, {{Kind::kPose, "ball"}, {below("z", 1)}}, 1));
  EXPECT_TRUE(monitor_.runUntil(fromSeconds(5)));
  // z = 2 - g t^2 / 2 < 1
  EXPECT_NEAR(toSeconds(world_.simulation().time()), 0.4515, 0.002);
  const Verdict verdict = monitor_.verdict(number);
  EXPECT_EQ(verdict.state, State::kMet);
  EXPECT_EQ(verdict.expected, "eventually pose of ball: z < 1, within 1 s");
  EXPECT_EQ(verdict.field, "z");
  EXPECT_EQ(verdict.times.size(), verdict.values.size());
  EXPECT_GT(verdict.times.size(), 100U);
}

TEST_F(MonitorTest, TellsWhatCameNearest) {
  const auto number = add(expectation(Mode::kEventually, {{Kind::kPose, "ball"}, {below("z", 0.2)}}, 1));
  const Verdict verdict = verdictAfter(2, number);
  EXPECT_EQ(verdict.state, State::kFailed);
  EXPECT_EQ(verdict.time, fromSeconds(1));
  EXPECT_TRUE(verdict.seen.starts_with("z = 0.")) << verdict.seen;
  EXPECT_NE(verdict.seen.find(" s came nearest; z = 0."), std::string::npos) << verdict.seen;
  EXPECT_TRUE(verdict.seen.ends_with(" at 1 s was the last")) << verdict.seen;
}

TEST_F(MonitorTest, SeesLinksJointsAndVelocities) {
  add(expectation(Mode::kAlways, {{Kind::kPose, "arm::rod"}, {below("z", 1.001)}}));
  add(expectation(Mode::kEventually, {{Kind::kVelocity, "ball"}, {below("z", -3)}}));
  add(expectation(Mode::kAlways,
                  {{Kind::kJoint, "arm::hinge"}, {{.field = "position", .relation = Relation::kNear, .other = 0.01}}}));
  verdictAfter(0.5, 0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(monitor_.verdict(i).state, State::kMet) << monitor_.verdict(i).seen;
}

TEST(Monitor, SeesActors) {
  RunningWorld world(std::string(R"(<actor name="walker"><pose>1 2 3 0 0 0</pose></actor>)"));
  Simulation& simulation = world.simulation();
  Monitor monitor(simulation);
  const auto add = [&](const Signal& signal) {
    return monitor.add({.mode = Mode::kEventually, .events = {{signal, {{"y", Relation::kNear, 5}}}}});
  };
  ASSERT_TRUE(add({Kind::kPose, "walker"}));
  simulation.step(1);
  monitor.look();
  EXPECT_EQ(monitor.verdict(0).state, State::kPending);
  Actor::find(simulation.world(), "walker")->move({{1, 5, 3}, Quaternion::Identity()});
  simulation.step(1);
  monitor.look();
  EXPECT_EQ(monitor.verdict(0).state, State::kMet);
  EXPECT_EQ(add({Kind::kPose, "walkr"}).error, "there is no model 'walkr' (did you mean 'walker'?)");
  EXPECT_EQ(add({Kind::kVelocity, "walker"}).error, "there is no model 'walker'");
}

TEST_F(MonitorTest, SeesContacts) {
  const auto touches = add(expectation(Mode::kEventually, {{Kind::kContact, "ball", "ground"}}));
  const auto other = add(expectation(Mode::kNever, {{Kind::kContact, "ball::link::c", "arm"}}));
  const auto anything = add(expectation(Mode::kNever, {{Kind::kContact, "ball", ""}}));
  verdictAfter(1, touches);
  EXPECT_EQ(monitor_.verdict(touches).state, State::kMet);
  // it falls 1.5 m
  EXPECT_NEAR(toSeconds(monitor_.verdict(touches).time), 0.553, 0.005);
  EXPECT_EQ(monitor_.verdict(other).state, State::kMet);
  EXPECT_EQ(monitor_.verdict(anything).state, State::kFailed);
  EXPECT_EQ(monitor_.verdict(anything).time, monitor_.verdict(touches).time);
  EXPECT_EQ(monitor_.verdict(anything).expected, "never contact of ball with anything");
}

TEST_F(MonitorTest, HearsMessagesAtTheTimeOfTheirPublishing) {
  Publisher publisher = flags();
  const auto number =
      add(expectation(Mode::kEventually, {{Kind::kTopic, "/flag"}, {{.field = "data", .number = 1, .isTruth = true}}}));
  publish(publisher, false);
  world_.step(10);
  publish(publisher, true);
  const Verdict verdict = verdictAfter(0.1, number);
  EXPECT_EQ(verdict.state, State::kMet);
  EXPECT_EQ(verdict.time, fromSeconds(0.01));
  EXPECT_EQ(verdict.seen, "data = true at 0.01 s");
}

TEST_F(MonitorTest, TellsWhichMessagesCame) {
  Publisher publisher = flags();
  const auto number =
      add(expectation(Mode::kEventually, {{Kind::kTopic, "/flag"}, {{.field = "data", .number = 1, .isTruth = true}}}));
  publish(publisher, false);
  EXPECT_EQ(verdictAfter(0.1, number).seen, "data = false at 0 s was the last of 1 message");
}

TEST_F(MonitorTest, NamesTheNearestOfTheTopicsThatAreThere) {
  Publisher publisher = flags();
  const auto eventually = add(expectation(Mode::kEventually, {{Kind::kTopic, "/flags"}}));
  const auto never = add(expectation(Mode::kNever, {{Kind::kTopic, "/flaq"}}));
  const auto quiet = add(expectation(Mode::kNever, {{Kind::kTopic, "/flag"}}));
  verdictAfter(0.01, eventually);
  EXPECT_EQ(monitor_.verdict(eventually).seen, "nobody publishes /flags (did you mean '/flag'?)");
  EXPECT_EQ(monitor_.verdict(never).state, State::kFailed) << "a topic that is not there says nothing";
  EXPECT_EQ(monitor_.verdict(never).seen, "nobody publishes /flaq (did you mean '/flag'?)");
  EXPECT_EQ(monitor_.verdict(quiet).state, State::kMet);
}

TEST_F(MonitorTest, ATopicWhosePublisherHasGoneWasThere) {
  Publisher publisher = flags();
  const auto quiet = add(expectation(Mode::kNever, {{Kind::kTopic, "/flag"}}));
  publisher = Publisher();
  EXPECT_EQ(verdictAfter(0.01, quiet).state, State::kMet);
}

TEST_F(MonitorTest, ReadsListsOfNumbers) {
  Publisher publisher = world_.simulation().transport().node().advertise<ignition::msgs::Double_V>("/list");
  const auto met = add(expectation(Mode::kEventually, {{Kind::kTopic, "/list"}, {below("min(data)", 2)}}));
  const auto size =
      add(expectation(Mode::kEventually, {{Kind::kTopic, "/list"}, {{.field = "size(data)", .number = 2}}}));
  const auto mean =
      add(expectation(Mode::kEventually, {{Kind::kTopic, "/list"}, {{.field = "mean(data)", .number = 2}}}));
  ignition::msgs::Double_V message;
  message.add_data(1);
  message.add_data(3);
  publisher.publish(message);
  verdictAfter(0.01, met);
  for (const auto number : {met, size, mean}) EXPECT_EQ(monitor_.verdict(number).state, State::kMet);
}

TEST_F(MonitorTest, ComparesWithARecordedRun) {
  const auto recorded = std::make_shared<RecordedValues>();
  // the free fall of the start, with few values
  for (double t = 0; t < 0.5; t += 0.05) {
    recorded->times.push_back(t);
    recorded->values.push_back(2 - 4.9 * t * t);
  }
  const auto criterion = [&](double tolerance) {
    return Criterion{.field = "z", .relation = Relation::kRecorded, .other = tolerance, .recorded = recorded};
  };
  const auto met = add(expectation(Mode::kAlways, {{Kind::kPose, "ball"}, {criterion(0.01)}}, 0.4));
  const auto failed = add(expectation(Mode::kAlways, {{Kind::kPose, "ball"}, {criterion(0.001)}}, 0.4));
  verdictAfter(0.5, met);
  EXPECT_EQ(monitor_.verdict(met).state, State::kMet);
  EXPECT_EQ(monitor_.verdict(failed).state, State::kFailed);
  EXPECT_NE(monitor_.verdict(failed).seen.find(" instead of 1.9"), std::string::npos) << monitor_.verdict(failed).seen;
}

TEST_F(MonitorTest, AFullTurnDoesNotCount) {
  const auto number = add(expectation(
      Mode::kAlways,
      {{Kind::kPose, "ball"}, {{.field = "yaw", .relation = Relation::kNear, .number = 6.2832, .other = 0.01}}}));
  EXPECT_EQ(verdictAfter(0.01, number).state, State::kMet);
}

TEST_F(MonitorTest, InOrderTellsHowFarItCame) {
  Publisher publisher = flags();
  Expectation expected = expectation(Mode::kInOrder, {{Kind::kPose, "ball"}, {below("z", 1.9)}});
  expected.events.push_back({{Kind::kTopic, "/flag"}});
  const auto number = add(expected);
  publish(publisher, true);
  const Verdict verdict = verdictAfter(0.2, number);
  EXPECT_EQ(verdict.expected, "in order pose of ball: z < 1.9, then a message on /flag");
  EXPECT_EQ(verdict.seen, "1 came at 0.143 s, 2 (a message on /flag) did not, only before that, at 0 s");
}

TEST_F(MonitorTest, TellsWhyTheWindowDidNotBegin) {
  Expectation expected = expectation(Mode::kNever, {{Kind::kContact, "ball"}});
  expected.after = Event{{Kind::kTopic, "/nothing"}};
  EXPECT_EQ(verdictAfter(0.01, add(expected)).seen, "it did not begin: nobody publishes /nothing");
}

TEST_F(MonitorTest, RefusesWhatIsNotThere) {
  EXPECT_EQ(errorOf({{Kind::kPose, "bal"}, {below("z", 1)}}), "there is no model 'bal' (did you mean 'ball'?)");
  EXPECT_EQ(errorOf({{Kind::kPose, "robot"}, {below("z", 1)}}),
            "there is no model 'robot' (there is: ground, ball, arm)");
  EXPECT_EQ(errorOf({{Kind::kPose, "ball::lnk"}, {below("z", 1)}}),
            "there is no link 'ball::lnk' (did you mean 'ball::link'?)");
  EXPECT_EQ(errorOf({{Kind::kJoint, "arm::hing"}, {below("position", 1)}}),
            "there is no joint 'arm::hing' (did you mean 'arm::hinge'?)");
  EXPECT_EQ(errorOf({{Kind::kJoint, "arm::hold"}, {below("position", 1)}}),
            "joint 'arm::hold' has no axis with a position");
  EXPECT_EQ(errorOf({{Kind::kContact, "ball", "groud"}}),
            "there is no model, link or collision 'groud' (did you mean 'ground'?)");
  EXPECT_EQ(errorOf({{Kind::kPose, "ball"}, {below("height", 1)}}),
            "it has no field 'height' (there is: x, y, z, roll, pitch, yaw)");
  EXPECT_EQ(errorOf({{Kind::kTopic, "/a b"}}), "the topic '/a b' has a space");
  EXPECT_EQ(monitor_.decided(), 0U) << "what was refused is not there";
}

TEST_F(MonitorTest, RefusesFieldsThatATopicDoesNotHave) {
  const Publisher publisher = flags();
  EXPECT_EQ(errorOf({{Kind::kTopic, "/flag"}, {{.field = "dat"}}}),
            "field 'dat' is not in ignition.msgs.Boolean (did you mean 'data'?)");
  EXPECT_EQ(errorOf({{Kind::kTopic, "/flag"}, {{.field = "data", .text = "yes"}}}),
            "field 'data' of ignition.msgs.Boolean is a number, and not 'yes'");
  EXPECT_EQ(errorOf({{Kind::kTopic, "/flag"}, {{.field = "min(data)"}}}),
            "field 'data' of ignition.msgs.Boolean is not a list of numbers");
}

TEST_F(MonitorTest, TellsOfAFieldThatALaterTopicDoesNotHave) {
  const auto number = add(expectation(Mode::kNever, {{Kind::kTopic, "/flag"}, {{.field = "dat"}}}));
  Publisher publisher = flags();
  publish(publisher, true);
  const Verdict verdict = verdictAfter(0.1, number);
  EXPECT_EQ(verdict.state, State::kFailed);
  EXPECT_EQ(verdict.seen, "/flag: field 'dat' is not in ignition.msgs.Boolean (did you mean 'data'?)");
}

TEST_F(MonitorTest, ChangesNoBit) {
  RunningWorld other(kBall);
  add(expectation(Mode::kNever, {{Kind::kContact, "arm"}}));
  verdictAfter(1, 0);
  other.step(world_.simulation().iterations());
  EXPECT_EQ(world_.simulation().stateHash(), other.simulation().stateHash());
}

}  // namespace
}  // namespace pongsim::test
