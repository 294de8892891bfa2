#include "transport/udp/domain.hh"

#include <gtest/gtest.h>
#include <netinet/in.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "support/environment_variable.hh"
#include "support/test_domain.hh"
#include "support/udp_socket.hh"

namespace pongsim::transport {

TEST(Domain, IsTheOneWantedElseTheEnvironmentsElseZero) {
  test::EnvironmentVariable domain("PONGSIM_DOMAIN");
  domain.unset();
  EXPECT_EQ(chosenDomain({}), 0);
  domain.set("");
  EXPECT_EQ(chosenDomain({}), 0);
  domain.set("232");
  EXPECT_EQ(chosenDomain({}), 232);
  EXPECT_EQ(chosenDomain(7), 7);
}

TEST(Domain, SaysWhatIsWrongWithIt) {
  EXPECT_THROW(chosenDomain(-1), std::invalid_argument);
  EXPECT_THROW(chosenDomain(233), std::invalid_argument);
  for (const char* bad : {"233", "-1", "x", "1.5", "99999999999999999999"}) {
    const test::EnvironmentVariable domain("PONGSIM_DOMAIN", bad);
    try {
      chosenDomain({});
      FAIL() << bad;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(bad), std::string::npos) << error.what();
    }
  }
}

TEST(Domain, HasThePartitionThatTheEnvironmentSays) {
  test::EnvironmentVariable ofFortress("IGN_PARTITION"), later("GZ_PARTITION");
  ofFortress.unset();
  later.unset();
  EXPECT_EQ(chosenPartition(), "");
  later.set("new");
  EXPECT_EQ(chosenPartition(), "new");
  ofFortress.set("old");
  EXPECT_EQ(chosenPartition(), "old");
}

TEST(Domain, HasPortsOfItsOwn) {
  for (int domain = 0; domain < 232; ++domain) {
    const DiscoveryPorts ports = discoveryPorts(domain);
    // a participant's user data port is its discovery port + 1 (RTPS: d3 = 11)
    EXPECT_LT(ports.first + 2 * (ports.count - 1) + 1, discoveryPorts(domain + 1).first) << domain;
    EXPECT_GE(ports.count, 60) << domain;
    EXPECT_LT(multicastPort(domain), ports.first) << domain;
  }
  EXPECT_LE(discoveryPorts(232).first + 2 * discoveryPorts(232).count, 65535);
}

TEST(Domain, KnowsWhoListensOnThisMachine) {
  const int domain = test::testDomain();
  const DiscoveryPorts ports = discoveryPorts(domain);
  const test::UdpSocket near(INADDR_LOOPBACK, ports.first + 20);
  const test::UdpSocket far(INADDR_ANY, ports.first + 200);
  const test::UdpSocket data(INADDR_LOOPBACK, ports.first + 21);
  const test::UdpSocket next(INADDR_LOOPBACK, ports.first + 2 * ports.count);
  auto open = openDiscoveryPorts(domain);
  ASSERT_TRUE(open);
  std::ranges::sort(*open, {}, &OpenPort::port);
  ASSERT_EQ(open->size(), 2);
  EXPECT_EQ(open->front().port, ports.first + 20);
  EXPECT_TRUE(open->front().isOnLoopbackAlone);
  EXPECT_EQ(open->back().port, ports.first + 200);
  EXPECT_FALSE(open->back().isOnLoopbackAlone);
}

}  // namespace pongsim::transport
