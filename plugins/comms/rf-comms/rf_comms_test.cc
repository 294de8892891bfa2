#include <gtest/gtest.h>
#include <ignition/msgs/dataframe.pb.h>

#include <cmath>
#include <string>
#include <vector>

#include "radio.hh"
#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::rf_comms_test {
namespace {

using ignition::msgs::Dataframe;
using test::RunningWorld;

std::string robot(const std::string& name, double x, const std::string& address) {
  return "<model name='" + name + "'><static>true</static><pose>" + std::to_string(x) +
         " 0 0 0 0 0</pose><link name='l'/><plugin filename='ignition-gazebo-comms-endpoint-system' "
         "name='ignition::gazebo::systems::CommsEndpoint'><address>" +
         address + "</address><topic>" + address + "/rx</topic></plugin></model>";
}

std::string radios(const std::string& range, const std::string& radio) {
  return "<plugin filename='ignition-gazebo-rf-comms-system' name='ignition::gazebo::systems::RFComms'><range_config>" +
         range + "</range_config><radio_config>" + radio + "</radio_config></plugin>";
}

std::string worldWith(double distance, const std::string& range = "", const std::string& radio = "") {
  return radios(range, radio) + robot("a", 0, "addr1") + robot("b", distance, "addr2");
}

Dataframe frame(std::size_t bytes) {
  Dataframe message;
  message.set_src_address("addr2");
  message.set_dst_address("addr1");
  message.set_data(std::string(bytes, 'x'));
  return message;
}

/// Sends so many messages, one each step, and returns those that arrive.
std::vector<Dataframe> send(RunningWorld& world, int count, std::size_t bytes) {
  std::vector<Dataframe> heard;
  const Subscription subscription = world.simulation().transport().node().subscribe<Dataframe>(
      "/addr1/rx", [&heard](const Dataframe& message) { heard.push_back(message); });
  Publisher publisher = world.simulation().transport().node().advertise<Dataframe>("/broker/msgs");
  for (int i = 0; i < count; ++i) {
    publisher.publish(frame(bytes));
    world.step(1);
  }
  return heard;
}

double powerOf(const Dataframe& message) {
  EXPECT_EQ(message.header().data_size(), 1);
  EXPECT_EQ(message.header().data(0).key(), "rssi");
  return std::stod(message.header().data(0).value(0));
}

/// As Fortress's own test of the system tells it.
TEST(RFComms, CarriesMostMessages) {
  RunningWorld world(worldWith(52, "<max_range>500000.0</max_range><fading_exponent>2.6</fading_exponent><l0>40</l0>",
                               "<capacity>1000000</capacity><tx_power>20</tx_power><noise_floor>-90</noise_floor>"));
  world.step(2);
  EXPECT_GT(send(world, 10, 15).size(), 5U);
}

TEST(RFComms, SaysThePowerThatWasReceived) {
  // no deviation: what the formula says
  RunningWorld world(worldWith(20, "<sigma>0</sigma>"));
  world.step(2);
  const std::vector<Dataframe> heard = send(world, 5, 10);
  ASSERT_EQ(heard.size(), 5U);
  EXPECT_NEAR(powerOf(heard[0]), 27 - 40 - 25 * std::log10(20), 1e-6);
}

TEST(RFComms, SpreadsThePowerAsItIsTold) {
  RunningWorld world(worldWith(2, "<sigma>3</sigma>"));
  world.step(2);
  constexpr int kCount = 2000;
  const std::vector<Dataframe> heard = send(world, kCount, 1);
  ASSERT_EQ(heard.size(), kCount) << "at two metres all arrive";
  double sum = 0, squares = 0;
  for (const Dataframe& message : heard) {
    sum += powerOf(message);
    squares += powerOf(message) * powerOf(message);
  }
  const double mean = sum / kCount;
  // four standard errors
  EXPECT_NEAR(mean, 27 - 40 - 25 * std::log10(2), 4 * 3 / std::sqrt(kCount));
  EXPECT_NEAR(std::sqrt(squares / kCount - mean * mean), 3, 4 * 3 / std::sqrt(2.0 * kCount));
}

TEST(RFComms, LosesAsManyAsTheFormulasSay) {
  constexpr int kCount = 4000;
  constexpr std::size_t kBytes = 20;
  // from 6 dB to 2 dB above the noise
  const RadioSettings settings{.sigma = 0, .sendingPower = -10, .noiseFloor = -90};
  for (const double distance : {23.0, 27.0, 33.0}) {
    RunningWorld world(worldWith(distance, "<sigma>0</sigma>", "<tx_power>-10</tx_power>"));
    world.step(2);
    const double share = static_cast<double>(send(world, kCount, kBytes).size()) / kCount;
    const double expected = 1 - lossProbability(bitErrorRate(settings, meanReceivedPower(settings, distance)), kBytes);
    EXPECT_GT(expected, 0.05) << distance;
    EXPECT_LT(expected, 0.95) << distance;
    EXPECT_NEAR(share, expected, 4 * std::sqrt(expected * (1 - expected) / kCount)) << distance;
  }
}

TEST(RFComms, CarriesNothingBeyondTheLargestRange) {
  RunningWorld near(worldWith(49.9, "<sigma>0</sigma>")), far(worldWith(50.1, "<sigma>0</sigma>"));
  near.step(2);
  far.step(2);
  EXPECT_EQ(send(near, 20, 10).size(), 20U);
  EXPECT_EQ(send(far, 20, 10).size(), 0U);
  RunningWorld unlimited(worldWith(50.1, "<sigma>0</sigma><max_range>0</max_range>"));
  unlimited.step(2);
  EXPECT_EQ(send(unlimited, 20, 10).size(), 20U);
}

TEST(RFComms, CarriesNoMoreThanItsCapacity) {
  RunningWorld world(worldWith(2, "", "<capacity>8000</capacity>"));
  world.step(2);
  testing::internal::CaptureStderr();
  // a kilobyte a second
  EXPECT_EQ(send(world, 500, 100).size(), 10U);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("the radio of 'addr2' is at its capacity: 8800.000000 bits sent in a second, 8000.000000 are "
                      "allowed; the message is lost"),
            std::string::npos)
      << said;
  world.step(1000);
  EXPECT_EQ(send(world, 10, 100).size(), 10U);
}

TEST(RFComms, CountsWhatIsReceivedToo) {
  // each of two senders sends half of what is allowed, three of them too much
  const std::string more = robot("c", 2, "addr3") + robot("d", 2, "addr4");
  RunningWorld world(worldWith(2, "", "<capacity>8000</capacity>") + more);
  world.step(2);
  testing::internal::CaptureStderr();
  std::vector<Dataframe> heard;
  world.listen("/addr1/rx", heard);
  for (const char* from : {"addr2", "addr3", "addr4"}) {
    Dataframe message = frame(500);
    message.set_src_address(from);
    world.tell("/broker/msgs", message);
  }
  world.step(1);
  EXPECT_EQ(heard.size(), 2U);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("bits received in a second"), std::string::npos);
}

std::vector<double> powersOf(const std::vector<Dataframe>& messages) {
  std::vector<double> powers;
  for (const Dataframe& message : messages) powers.push_back(powerOf(message));
  return powers;
}

TEST(RFComms, RepeatsByItsSeedAfterAResetAndFromASavedState) {
  const std::string content = worldWith(30, "", "<capacity>40000</capacity><tx_power>10</tx_power>");
  RunningWorld world(content), other(content);
  world.step(2);
  const std::vector<double> first = powersOf(send(world, 40, 50));
  const std::vector<std::byte> state = world.simulation().saveState();
  testing::internal::CaptureStderr();
  const std::vector<double> second = powersOf(send(world, 80, 50));
  // 100 messages a second: the state holds how many have been sent
  EXPECT_LT(second.size(), 61U);
  ASSERT_TRUE(other.simulation().restoreState(state));
  EXPECT_EQ(powersOf(send(other, 80, 50)), second);
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  world.step(2);
  EXPECT_EQ(powersOf(send(world, 40, 50)), first);
  EXPECT_EQ(powersOf(send(world, 80, 50)), second);
  testing::internal::GetCapturedStderr();
}

TEST(RFComms, SaysWhatIsWrongWithItsParameters) {
  const std::string left = "rf-comms is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(radios("<max_range>-1</max_range>", "")),
            std::vector<std::string>{left + "<max_range> must be zero or more"});
  EXPECT_EQ(RunningWorld::complaintsAbout(radios("<sigma>wide</sigma>", "")),
            std::vector<std::string>{left + "<sigma> is 'wide', which is not a number"});
  EXPECT_EQ(RunningWorld::complaintsAbout(radios("<maxrange>1</maxrange>", "<modulation>FM</modulation>")),
            (std::vector<std::string>{"<range_config> does not know <maxrange>",
                                      "<modulation> 'FM' is unknown: QPSK is used, as in Fortress"}));
}

}  // namespace
}  // namespace pongsim::rf_comms_test
