#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>

#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::comms_endpoint_test {
namespace {

using ignition::msgs::StringMsg_V;
using test::RunningWorld;

constexpr const char* kBroker =
    "<plugin filename='ignition-gazebo-perfect-comms-system' name='ignition::gazebo::systems::PerfectComms'/>";

std::string robot(const std::string& name, const std::string& parameters) {
  return "<model name='" + name + "'><static>true</static><link name='l'/><plugin " +
         "filename='ignition-gazebo-comms-endpoint-system' name='ignition::gazebo::systems::CommsEndpoint'>" +
         parameters + "</plugin></model>";
}

std::string endpoint(const std::string& address) {
  return "<address>" + address + "</address><topic>" + address + "/rx</topic>";
}

void send(RunningWorld& world, const std::string& from, const std::string& to) {
  world.tellText("/broker/msgs", "ignition.msgs.Dataframe",
                 "src_address: '" + from + "' dst_address: '" + to + "' data: 'x'");
}

/// A broker of a test's own, which notes what it is asked.
class OwnBroker {
 public:
  explicit OwnBroker(Node node)
      : bind_(node.serve<StringMsg_V, ignition::msgs::Boolean>(
            "/broker/bind",
            [this](const StringMsg_V& request, ignition::msgs::Boolean&) {
              asked.push_back("bind " + textOf(request));
              return refuses ? ServiceAnswer::refused("not now") : true;
            })),
        unbind_(
            node.serve<StringMsg_V, ignition::msgs::Empty>("/broker/unbind", [this](const StringMsg_V& request, auto&) {
              asked.push_back("unbind " + textOf(request));
              return true;
            })) {}

  std::vector<std::string> asked;
  bool refuses = false;

 private:
  static std::string textOf(const StringMsg_V& request) {
    std::string text;
    for (const std::string& each : request.data()) text += each + " ";
    return text;
  }

  Service bind_;
  Service unbind_;
};

class OwnBrokerTest : public testing::Test {
 protected:
  void start(const std::string& content) {
    Diagnostics diagnostics;
    simulation_ =
        Simulation::fromText(RunningWorld::textOf(content), "world.sdf", {.transport = &transport_}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_NE(simulation_, nullptr);
  }

  Transport transport_{TransportOptions{.network = false}};
  OwnBroker broker_{transport_.node()};
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(OwnBrokerTest, IsAskedOnceToBindAndToUnbindWhenTheModelGoes) {
  start(robot("a", endpoint("addr1")));
  simulation_->step(3000);
  EXPECT_EQ(broker_.asked, std::vector<std::string>{"bind addr1 a addr1/rx "});
  EXPECT_TRUE(simulation_->remove(*simulation_->world().model("a")));
  simulation_->step(1);
  EXPECT_EQ(broker_.asked.back(), "unbind addr1 addr1/rx ");
}

TEST_F(OwnBrokerTest, IsAskedAgainEverySecondWhileItRefuses) {
  broker_.refuses = true;
  testing::internal::CaptureStderr();
  start(robot("a", endpoint("addr1")));
  simulation_->step(2500);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(broker_.asked.size(), 3U);
  const std::string warning = "comms-endpoint of a: service '/broker/bind' refused: not now; retrying every second";
  EXPECT_NE(said.find(warning), std::string::npos) << said;
  EXPECT_EQ(said.find(warning), said.rfind(warning)) << said;
  broker_.refuses = false;
  simulation_->step(3000);
  EXPECT_EQ(broker_.asked.size(), 4U);
}

TEST_F(OwnBrokerTest, IsToldTheWholeNameOfANestedModel) {
  start("<model name='outer'><static>true</static>" + robot("inner", endpoint("addr1")) + "</model>");
  simulation_->step(1);
  EXPECT_EQ(broker_.asked, std::vector<std::string>{"bind addr1 outer::inner addr1/rx "});
}

TEST(CommsEndpoint, LetsItsAddressGoWithTheModel) {
  RunningWorld world(kBroker + robot("a", endpoint("addr1")) + robot("b", endpoint("addr2")));
  world.step(2);
  EXPECT_TRUE(world.simulation().remove(world.model("a")));
  Diagnostics diagnostics;
  // another model takes it
  ASSERT_TRUE(world.simulation().insertText("<sdf version='1.9'>" + robot("c", endpoint("addr1")) + "</sdf>", "c.sdf",
                                            {}, diagnostics));
  EXPECT_TRUE(diagnostics.all().empty());
  world.step(2);
  std::vector<ignition::msgs::Empty> none;
  std::size_t heard = 0;
  const Subscription subscription = world.simulation().transport().node().subscribe(
      "/addr1/rx", "ignition.msgs.Dataframe", [&heard](const Message&) { ++heard; });
  send(world, "addr2", "addr1");
  world.step(1);
  EXPECT_EQ(heard, 1U);
}

TEST(CommsEndpoint, WarnsOfAnAddressThatIsTaken) {
  testing::internal::CaptureStderr();
  RunningWorld world(kBroker + robot("a", endpoint("addr1")) + robot("b", endpoint("addr1")));
  world.step(2);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("comms-endpoint of b: service '/broker/bind' refused: the address 'addr1' is bound to the model "
                      "'a' already"),
            std::string::npos)
      << said;
}

TEST(CommsEndpoint, IsLeftOutWithTheReason) {
  const std::string left = "comms-endpoint of a is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(kBroker + robot("a", "<topic>x</topic>")),
            std::vector<std::string>{left + "no <address> is given"});
  EXPECT_EQ(RunningWorld::complaintsAbout(kBroker + robot("a", "<address>x</address>")),
            std::vector<std::string>{left + "no <topic> is given"});
  EXPECT_EQ(RunningWorld::complaintsAbout(kBroker + robot("a", "<address>x</address><topic>a b</topic>")),
            std::vector<std::string>{left + "<topic> 'a b' has a space"});
  EXPECT_EQ(RunningWorld::complaintsAbout(robot("a", endpoint("addr1"))),
            std::vector<std::string>{
                "the address 'addr1' is not bound: no system before this one offers the service '/broker/bind'"});
}

}  // namespace
}  // namespace pongsim::comms_endpoint_test
