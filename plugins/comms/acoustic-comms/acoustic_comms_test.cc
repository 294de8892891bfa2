#include <gtest/gtest.h>
#include <ignition/msgs/dataframe.pb.h>

#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::acoustic_comms_test {
namespace {

using ignition::msgs::Dataframe;
using test::RunningWorld;

std::string robot(const std::string& name, double x, const std::string& address) {
  return "<model name='" + name + "'><pose>" + std::to_string(x) +
         " 0 0 0 0 0</pose><link name='l'><inertial><mass>1</mass></inertial></link>"
         "<plugin filename='gz-sim-comms-endpoint-system' name='gz::sim::systems::CommsEndpoint'><address>" +
         address + "</address><topic>" + address + "/rx</topic></plugin></model>";
}

/// The robots "a" at the origin and "b".
std::string worldWith(double distance, const std::string& parameters) {
  return "<gravity>0 0 0</gravity>"
         "<plugin filename='gz-sim-acoustic-comms-system' name='gz::sim::systems::AcousticComms'>" +
         parameters + "</plugin>" + robot("a", 0, "addr1") + robot("b", distance, "addr2");
}

Dataframe frame(const std::string& data) {
  Dataframe message;
  message.set_src_address("addr2");
  message.set_dst_address("addr1");
  message.set_data(data);
  return message;
}

class Talk {
 public:
  explicit Talk(const std::string& content) : world_(content) {
    world_.listen("/addr1/rx", heard_);
    world_.step(2);
  }

  void say(const std::string& data) { world_.tell("/broker/msgs", frame(data)); }
  void step(std::uint64_t count) { world_.step(count); }
  RunningWorld& world() { return world_; }
  std::string heard() const {
    std::string all;
    for (const Dataframe& message : heard_) all += message.data();
    return all;
  }

 private:
  RunningWorld world_;
  std::vector<Dataframe> heard_;
};

TEST(AcousticComms, TakesTheTimeOfTheSound) {
  Talk talk(worldWith(30, "<speed_of_sound>1500</speed_of_sound>"));
  talk.say("a");
  // 30 m at 1500 m/s are 20 steps
  talk.step(19);
  EXPECT_EQ(talk.heard(), "");
  talk.say("b");
  talk.step(1);
  EXPECT_EQ(talk.heard(), "a");
  talk.step(18);
  EXPECT_EQ(talk.heard(), "a");
  talk.step(1);
  EXPECT_EQ(talk.heard(), "ab");
}

TEST(AcousticComms, ComesFromWhereTheSenderWas) {
  Talk talk(worldWith(30, "<speed_of_sound>1500</speed_of_sound>"));
  talk.say("a");
  talk.step(1);
  ASSERT_TRUE(talk.world().model("b").setPose({Vector3(1, 0, 0), Quaternion::Identity()}));
  talk.step(18);
  EXPECT_EQ(talk.heard(), "");
  // the receiver comes towards it
  ASSERT_TRUE(talk.world().model("a").setPose({Vector3(25, 0, 0), Quaternion::Identity()}));
  talk.step(1);
  EXPECT_EQ(talk.heard(), "a");
}

TEST(AcousticComms, EndsAtItsRange) {
  Talk talk(worldWith(30, "<speed_of_sound>1500</speed_of_sound><max_range>29.9</max_range>"));
  talk.say("a");
  talk.step(100);
  EXPECT_EQ(talk.heard(), "");
}

TEST(AcousticComms, IsDeafWhileAMessageArrives) {
  Talk talk(worldWith(3,
                      "<speed_of_sound>1500</speed_of_sound>"
                      "<collision_time_per_byte>0.01</collision_time_per_byte>"));
  talk.say("ab");
  talk.step(10);
  talk.say("c");
  talk.step(10);
  talk.say("d");
  talk.step(10);
  EXPECT_EQ(talk.heard(), "abd") << "20 ms for two bytes";
}

TEST(AcousticComms, IsDeafAfterALoss) {
  Talk talk(worldWith(3,
                      "<speed_of_sound>1500</speed_of_sound><collision_time_per_byte>0.01</collision_time_per_byte>"
                      "<collision_time_packet_drop>0.03</collision_time_packet_drop>"));
  talk.say("a");
  talk.step(5);
  // lost, so that the next 30 ms are, too
  talk.say("b");
  talk.step(20);
  talk.say("c");
  talk.step(25);
  // within 30 ms after that loss
  talk.say("d");
  talk.step(30);
  talk.say("e");
  talk.step(5);
  EXPECT_EQ(talk.heard(), "ae");
}

/// As Gazebo's own test of the system tells it.
TEST(AcousticComms, LosesMessagesInNoise) {
  const std::string model =
      "<propagation_model><source_power>0.001</source_power><noise_level>150</noise_level>"
      "<spectral_efficiency>7</spectral_efficiency><seed>0</seed></propagation_model>";
  const std::string sound = "<max_range>6</max_range><speed_of_sound>1400</speed_of_sound>";
  Talk faint(worldWith(4, sound + model));
  Talk loud(worldWith(4, sound + "<propagation_model/>"));
  for (Talk* talk : {&faint, &loud}) {
    for (int i = 0; i < 3; ++i) {
      talk->say(std::string(100, 'x'));
      talk->step(100);
    }
  }
  EXPECT_EQ(faint.heard(), "");
  EXPECT_EQ(loud.heard().size(), 300U);
}

TEST(AcousticComms, SavesWhatIsOnItsWay) {
  const std::string content = worldWith(30,
                                        "<speed_of_sound>1500</speed_of_sound>"
                                        "<collision_time_per_byte>0.01</collision_time_per_byte>");
  Talk talk(content), other(content);
  talk.say("a");
  talk.step(10);
  ASSERT_TRUE(other.world().simulation().restoreState(talk.world().simulation().saveState()));
  other.step(9);
  EXPECT_EQ(other.heard(), "");
  other.step(1);
  EXPECT_EQ(other.heard(), "a");
  Diagnostics diagnostics;
  talk.world().simulation().reset(diagnostics);
  talk.step(100);
  EXPECT_EQ(talk.heard(), "") << "a reset forgets it";
}

TEST(AcousticComms, SaysWhatIsWrongWithItsParameters) {
  const auto said = [](const std::string& parameters) {
    return RunningWorld::complaintsAbout(
        "<plugin filename='gz-sim-acoustic-comms-system' name='gz::sim::systems::AcousticComms'>" + parameters +
        "</plugin>");
  };
  using Said = std::vector<std::string>;
  const std::string left = "acoustic-comms is left out: ";
  EXPECT_EQ(said("<speed_of_sound>0</speed_of_sound>"), Said{left + "<speed_of_sound> must be above zero"});
  EXPECT_EQ(said("<max_range>-1</max_range>"), Said{left + "<max_range> must be zero or more"});
  EXPECT_EQ(said("<propagation_model><source_power>0</source_power></propagation_model>"),
            Said{left + "<source_power> must be above zero"});
}

}  // namespace
}  // namespace pongsim::acoustic_comms_test
