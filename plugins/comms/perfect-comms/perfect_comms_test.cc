#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/dataframe.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>

#include <string>
#include <vector>

#include "support/ask_service.hh"
#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::perfect_comms_test {
namespace {

using ignition::msgs::Dataframe;
using test::RunningWorld;

std::string endpoint(const std::string& address, const std::string& more = "") {
  return R"(<plugin filename="ignition-gazebo-comms-endpoint-system" name="ignition::gazebo::systems::CommsEndpoint">
    <address>)" +
         address + "</address><topic>" + address + "/rx</topic>" + more + "</plugin>";
}

std::string robot(const std::string& name, const std::string& content) {
  return "<model name='" + name + "'><static>true</static><link name='l'/>" + content + "</model>";
}

std::string broker(const std::string& parameters = "") {
  return R"(<plugin filename="ignition-gazebo-perfect-comms-system" name="ignition::gazebo::systems::PerfectComms">)" +
         parameters + "</plugin>";
}

std::string worldWith(const std::string& parameters = "", const std::string& ofEndpoints = "") {
  return broker(parameters) + robot("a", endpoint("addr1", ofEndpoints)) + robot("b", endpoint("addr2", ofEndpoints));
}

Dataframe frame(const std::string& from, const std::string& to, const std::string& data) {
  Dataframe message;
  message.set_src_address(from);
  message.set_dst_address(to);
  message.set_data(data);
  return message;
}

ignition::msgs::StringMsg_V texts(const std::vector<std::string>& all) {
  ignition::msgs::StringMsg_V message;
  for (const std::string& text : all) message.add_data(text);
  return message;
}

std::string bind(RunningWorld& world, const std::vector<std::string>& all) {
  ignition::msgs::Boolean reply;
  return test::refusalOf(test::askService(world.simulation().transport(), "/broker/bind", texts(all), reply));
}

std::string unbind(RunningWorld& world, const std::vector<std::string>& all) {
  ignition::msgs::Empty reply;
  return test::refusalOf(test::askService(world.simulation().transport(), "/broker/unbind", texts(all), reply));
}

std::vector<std::string> dataOf(const std::vector<Dataframe>& messages) {
  std::vector<std::string> all;
  for (const Dataframe& message : messages) all.push_back(message.data());
  return all;
}

/// As Fortress's own test of the system tells it.
TEST(PerfectComms, CarriesEveryMessage) {
  RunningWorld world(test::projectFolder() / "plugins/comms/perfect-comms/perfect_comms.sdf");
  world.step(1000);
  std::vector<Dataframe> heard, elsewhere;
  world.listen("/addr1/rx", heard);
  world.listen("/addr2/rx", elsewhere);
  for (int i = 0; i < 10; ++i) {
    ignition::msgs::StringMsg payload;
    payload.set_data("hello world " + std::to_string(i));
    world.tell("/broker/msgs", frame("addr2", "addr1", payload.SerializeAsString()));
    world.step(100);
  }
  ASSERT_EQ(heard.size(), 10U);
  for (std::size_t i = 0; i < heard.size(); ++i) {
    ignition::msgs::StringMsg payload;
    EXPECT_TRUE(payload.ParseFromString(heard[i].data()));
    EXPECT_EQ(payload.data(), "hello world " + std::to_string(i));
    EXPECT_EQ(heard[i].src_address(), "addr2");
  }
  // the time of the step before it came
  EXPECT_EQ(heard[2].header().stamp().sec(), 1);
  EXPECT_EQ(heard[2].header().stamp().nsec(), 200'000'000);
  EXPECT_TRUE(elsewhere.empty());
}

TEST(PerfectComms, CarriesFromTheSecondStepOn) {
  RunningWorld world(worldWith());
  std::vector<Dataframe> heard;
  world.listen("/addr1/rx", heard);
  testing::internal::CaptureStderr();
  world.tell("/broker/msgs", frame("addr2", "addr1", "none is bound yet"));
  world.step(1);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("was dropped: no model has bound 'addr2'"), std::string::npos);
  world.tell("/broker/msgs", frame("addr2", "addr1", "all are"));
  world.step(1);
  EXPECT_EQ(dataOf(heard), std::vector<std::string>{"all are"});
}

TEST(PerfectComms, CarriesNothingInTheStepInWhichAnAddressIsBound) {
  RunningWorld world(broker("<step_size>0.0005</step_size>") + robot("a", "") + robot("b", ""));
  EXPECT_EQ(bind(world, {"x", "a", "x/rx"}), "");
  EXPECT_EQ(bind(world, {"y", "b", "y/rx"}), "");
  std::vector<Dataframe> heard;
  world.listen("/y/rx", heard);
  testing::internal::CaptureStderr();
  world.tell("/broker/msgs", frame("x", "y", "early"));
  world.step(1);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("'x' was bound in this step"), std::string::npos);
  world.tell("/broker/msgs", frame("x", "y", "hello"));
  world.step(1);
  EXPECT_EQ(dataOf(heard), std::vector<std::string>{"hello"});
}

TEST(PerfectComms, CarriesToAllTopicsOfAnAddressUntilTheyAreUnbound) {
  RunningWorld world(worldWith());
  EXPECT_EQ(bind(world, {"addr1", "a", "second"}), "");
  world.step(2);
  std::vector<Dataframe> first, second;
  world.listen("/addr1/rx", first);
  world.listen("/second", second);
  world.tell("/broker/msgs", frame("addr2", "addr1", "1"));
  world.tell("/broker/msgs", frame("addr1", "addr1", "to itself"));
  world.step(1);
  EXPECT_EQ(dataOf(first), (std::vector<std::string>{"to itself", "1"})) << "by the addresses of the senders";
  EXPECT_EQ(dataOf(second), dataOf(first));
  EXPECT_EQ(unbind(world, {"addr1", "second"}), "");
  EXPECT_EQ(unbind(world, {"addr1", "second"}), "the address 'addr1' is not bound to the topic 'second'");
  world.tell("/broker/msgs", frame("addr2", "addr1", "2"));
  world.step(1);
  EXPECT_EQ(first.size(), 3U);
  EXPECT_EQ(second.size(), 2U);
}

TEST(PerfectComms, RefusesBindingsThatMakeNoSense) {
  RunningWorld world(worldWith());
  world.step(1);
  EXPECT_EQ(bind(world, {"addr1", "b", "x"}), "the address 'addr1' is bound to the model 'a' already");
  EXPECT_EQ(bind(world, {"addr1", "b"}), "binding needs an address, a model and a topic, not 2 texts");
  EXPECT_EQ(bind(world, {"", "b", "x"}), "the address is empty");
  EXPECT_EQ(bind(world, {"addr3", "b", "not a topic"}), "the topic 'not a topic' has a space");
  EXPECT_EQ(unbind(world, {"addr1"}), "unbinding needs an address and a topic, not 1 texts");
  // free again
  EXPECT_EQ(unbind(world, {"addr1", "addr1/rx"}), "");
  EXPECT_EQ(bind(world, {"addr1", "b", "x"}), "");
}

TEST(PerfectComms, WarnsSeldomOfWhatItDrops) {
  RunningWorld world(worldWith());
  EXPECT_EQ(bind(world, {"ghost", "nobody", "x"}), "");
  world.step(2);
  testing::internal::CaptureStderr();
  world.tell("/broker/msgs", frame("addr2", "addr9", ""));
  world.tell("/broker/msgs", frame("addr9", "addr1", ""));
  world.tell("/broker/msgs", frame("addr2", "ghost", ""));
  world.step(1100);
  world.tell("/broker/msgs", frame("addr2", "ghost", ""));
  world.step(1);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("a message from 'addr9' to 'addr1' was dropped: no model has bound 'addr9'\n"), std::string::npos)
      << said;
  EXPECT_NE(said.find("'ghost' is bound to the model 'nobody', which does not exist (2 more since the last warning)"),
            std::string::npos)
      << said;
}

TEST(PerfectComms, KeepsNoMoreThanItsQueueWhilePaused) {
  RunningWorld world(worldWith());
  world.step(2);
  std::vector<Dataframe> heard;
  world.listen("/addr1/rx", heard);
  testing::internal::CaptureStderr();
  Publisher publisher = world.simulation().transport().node().advertise<Dataframe>("/broker/msgs");
  for (int i = 0; i < 30; ++i) {
    for (int k = 0; k < 50; ++k) publisher.publish(frame("addr2", "addr1", "x"));
    world.simulation().stepPaused();
  }
  EXPECT_TRUE(heard.empty());
  world.step(1);
  EXPECT_EQ(heard.size(), 1000U);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("too many are waiting for the next step"), std::string::npos);
}

TEST(PerfectComms, SpeaksByTheNamesItIsGiven) {
  const std::string services = "<bind_service>/my/bind</bind_service><unbind_service>/my/unbind</unbind_service>";
  RunningWorld world(worldWith("<broker><messages_topic>/my/msgs</messages_topic>" + services + "</broker>",
                               "<broker>" + services + "</broker>"));
  world.step(2);
  std::vector<Dataframe> heard;
  world.listen("/addr1/rx", heard);
  world.tell("/my/msgs", frame("addr2", "addr1", "hello"));
  world.step(1);
  EXPECT_EQ(heard.size(), 1U);
}

TEST(PerfectComms, GoesOnFromASavedState) {
  RunningWorld world(worldWith()), other(worldWith());
  world.step(2);
  EXPECT_EQ(bind(world, {"addr3", "a", "third"}), "");
  world.tell("/broker/msgs", frame("addr2", "addr1", "on its way"));
  // handed over, but not carried
  world.simulation().stepPaused();
  const std::vector<std::byte> state = world.simulation().saveState();
  ASSERT_TRUE(other.simulation().restoreState(state));
  for (RunningWorld* each : {&world, &other}) {
    std::vector<Dataframe> heard, third;
    each->listen("/addr1/rx", heard);
    each->listen("/third", third);
    each->step(1);
    ASSERT_EQ(dataOf(heard), std::vector<std::string>{"on its way"});
    EXPECT_EQ(heard[0].header().stamp().nsec(), 2'000'000);
    each->tell("/broker/msgs", frame("addr1", "addr3", "hello"));
    each->step(1);
    EXPECT_EQ(third.size(), 1U);
  }
}

TEST(PerfectComms, BindsAgainAfterAReset) {
  RunningWorld world(worldWith());
  world.step(10);
  EXPECT_EQ(bind(world, {"addr3", "a", "third"}), "");
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  world.step(1);
  std::vector<Dataframe> heard;
  world.listen("/addr1/rx", heard);
  testing::internal::CaptureStderr();
  world.tell("/broker/msgs", frame("addr2", "addr1", "1"));
  world.tell("/broker/msgs", frame("addr2", "addr3", "2"));
  world.step(1);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("no model has bound 'addr3'"), std::string::npos);
  EXPECT_EQ(heard.size(), 1U);
}

TEST(PerfectComms, IsLeftOutWithTheReason) {
  const std::string left = "perfect-comms is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(broker("<step_size>0</step_size>")),
            std::vector<std::string>{left + "<step_size> must be above zero"});
  EXPECT_EQ(RunningWorld::complaintsAbout(broker() + broker()),
            std::vector<std::string>{left + "service '/broker/bind' is already offered"});
  EXPECT_EQ(RunningWorld::complaintsAbout(broker("<broker><topic>x</topic></broker>")),
            std::vector<std::string>{"<broker> does not know <topic>"});
}

}  // namespace
}  // namespace pongsim::perfect_comms_test
