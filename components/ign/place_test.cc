#include "ign/place.hh"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace pongsim::ign {
namespace {

class PlaceTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"IGN_IP", "IGN_PARTITION", "IGN_TRANSPORT_SNDHWM", "IGN_RELAY", "GZ_IP", "GZ_PARTITION",
                             "GZ_TRANSPORT_SNDHWM", "GZ_RELAY", "PONGSIM_NETWORK"}) {
      unsetenv(name);
    }
  }
  void TearDown() override { SetUp(); }

  static std::string errorOf() {
    try {
      placeOfEnvironment(Generation::kIgn);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(PlaceTest, IsThisMachineAlone) {
  const Place place = placeOfEnvironment(Generation::kIgn);
  EXPECT_EQ(place.address, "127.0.0.1");
  EXPECT_FALSE(place.isOpen);
  EXPECT_NE(place.partition, "");
}

TEST_F(PlaceTest, IsWhatFortressIsTold) {
  setenv("IGN_IP", "127.0.0.1", 1);
  setenv("IGN_PARTITION", "here", 1);
  setenv("PONGSIM_NETWORK", "no_such_interface", 1);
  EXPECT_EQ(placeOfEnvironment(Generation::kIgn).address, "127.0.0.1");
  EXPECT_EQ(placeOfEnvironment(Generation::kIgn).partition, "here");
}

TEST_F(PlaceTest, IsAnInterfacesAddress) {
  setenv("PONGSIM_NETWORK", "lo", 1);
  EXPECT_EQ(placeOfEnvironment(Generation::kIgn).address, "127.0.0.1");
}

TEST_F(PlaceTest, SaysWhatIsWrong) {
  setenv("IGN_IP", "192.0.2.77", 1);
  EXPECT_NE(
      errorOf().find("IGN_IP is '192.0.2.77', which is not an IPv4 address of this machine; it has 127.0.0.1 (lo)"),
      std::string::npos)
      << errorOf();
  setenv("IGN_IP", "127.zero", 1);
  EXPECT_NE(errorOf(), "");
  unsetenv("IGN_IP");
  setenv("PONGSIM_NETWORK", "no_such_interface", 1);
  EXPECT_NE(errorOf().find("no network interface 'no_such_interface'"), std::string::npos) << errorOf();
  unsetenv("PONGSIM_NETWORK");
  setenv("IGN_PARTITION", "a b", 1);
  EXPECT_NE(errorOf().find("IGN_PARTITION is 'a b'"), std::string::npos) << errorOf();
}

TEST_F(PlaceTest, IsToldToTheLibraryButForWhatTheUserSaid) {
  settle({"127.0.0.1", false, "p"}, 100, Generation::kIgn);
  EXPECT_STREQ(std::getenv("IGN_IP"), "127.0.0.1");
  EXPECT_STREQ(std::getenv("IGN_TRANSPORT_SNDHWM"), "100");
  settle({"127.0.0.1", false, "p"}, 1000, Generation::kIgn);
  EXPECT_STREQ(std::getenv("IGN_TRANSPORT_SNDHWM"), "100");
}

TEST_F(PlaceTest, OfLaterClientsIsSaidByLaterVariablesAlone) {
  setenv("IGN_IP", "127.zero", 1);
  setenv("IGN_PARTITION", "there", 1);
  const Place usual = placeOfEnvironment(Generation::kGz);
  EXPECT_EQ(usual.address, "127.0.0.1");
  EXPECT_NE(usual.partition.find(':'), std::string::npos) << usual.partition;
  setenv("GZ_IP", "127.0.0.1", 1);
  setenv("GZ_PARTITION", "here", 1);
  EXPECT_EQ(placeOfEnvironment(Generation::kGz).partition, "here");
  setenv("GZ_PARTITION", "a b", 1);
  EXPECT_THROW(placeOfEnvironment(Generation::kGz), std::invalid_argument);
  setenv("GZ_IP", "192.0.2.77", 1);
  EXPECT_THROW(placeOfEnvironment(Generation::kGz), std::invalid_argument);
}

TEST_F(PlaceTest, OfLaterClientsIsToldToTheLibraryByFortressVariables) {
  setenv("IGN_RELAY", "10.0.0.1", 1);
  setenv("IGN_TRANSPORT_SNDHWM", "7", 1);
  settle({"127.0.0.1", false, "p"}, 100, Generation::kGz);
  EXPECT_STREQ(std::getenv("IGN_IP"), "127.0.0.1");
  EXPECT_STREQ(std::getenv("IGN_PARTITION"), "p");
  EXPECT_STREQ(std::getenv("IGN_TRANSPORT_SNDHWM"), "100");
  EXPECT_EQ(std::getenv("IGN_RELAY"), nullptr);
  setenv("GZ_RELAY", "10.0.0.2", 1);
  setenv("GZ_TRANSPORT_SNDHWM", "8", 1);
  settle({"127.0.0.1", false, "p"}, 100, Generation::kGz);
  EXPECT_STREQ(std::getenv("IGN_RELAY"), "10.0.0.2");
  EXPECT_STREQ(std::getenv("IGN_TRANSPORT_SNDHWM"), "8");
}

}  // namespace
}  // namespace pongsim::ign
