#include "transport/udp/interfaces.hh"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <stdexcept>

namespace pongsim::transport {

namespace {

/// Each test sets PONGSIM_NETWORK itself.
class Interfaces : public testing::Test {
 protected:
  Interfaces() { unsetenv("PONGSIM_NETWORK"); }
  ~Interfaces() override { unsetenv("PONGSIM_NETWORK"); }
};

}  // namespace

TEST_F(Interfaces, HaveLoopbackAmongThem) {
  const std::vector<NetworkInterface> all = networkInterfaces();
  const auto found = std::ranges::find(all, "127.0.0.1", &NetworkInterface::address);
  ASSERT_NE(found, all.end());
  EXPECT_EQ(found->name, "lo");
}

TEST_F(Interfaces, AreChosenByNameOrAddressElseByTheEnvironment) {
  EXPECT_FALSE(chosenInterface({}));
  EXPECT_FALSE(chosenInterface("127.0.0.1")) << "loopback is no opening";
  for (const NetworkInterface& each : networkInterfaces()) {
    if (each.address.starts_with("127.")) continue;
    setenv("PONGSIM_NETWORK", each.address.c_str(), 1);
    ASSERT_TRUE(chosenInterface({}));
    EXPECT_EQ(chosenInterface({})->name, each.name);
    EXPECT_EQ(chosenInterface(each.name)->name, each.name);
    EXPECT_FALSE(chosenInterface("lo"));
  }
}

TEST_F(Interfaces, AreListedWhereThereIsNoSuchOne) {
  setenv("PONGSIM_NETWORK", "eth99", 1);
  try {
    chosenInterface({});
    FAIL();
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("this machine has no network interface 'eth99'; it has ")) << message;
    EXPECT_NE(message.find("lo (127.0.0.1)"), std::string::npos) << message;
  }
}

}  // namespace pongsim::transport
