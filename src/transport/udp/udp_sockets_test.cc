#include "transport/udp/udp_sockets.hh"

#include <gtest/gtest.h>
#include <netinet/in.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <list>
#include <set>
#include <thread>
#include <vector>

#include "support/process.hh"
#include "support/test_domain.hh"
#include "support/udp_socket.hh"
#include "transport/udp/domain.hh"

namespace pongsim::transport {

namespace {

/// Sockets at ports that no other test uses, inside and outside the requested range.
class UdpSockets : public testing::Test {
 protected:
  UdpSockets() {
    const auto first = static_cast<std::uint16_t>(discoveryPorts(test::testDomain()).first);
    ports_ = {static_cast<std::uint16_t>(first + 10), static_cast<std::uint16_t>(first + 49)};
    for (std::uint32_t port = ports_.first - 10U; port <= ports_.last + 10U; ++port) {
      const std::uint32_t address = port % 2 == 0 ? INADDR_LOOPBACK : INADDR_ANY;
      sockets_.emplace_back(address, port);
      if (port >= ports_.first && port <= ports_.last) expected_.push_back({address, port});
    }
  }

  static std::vector<BoundUdp> sorted(std::vector<BoundUdp> all) {
    std::ranges::sort(all, {}, &BoundUdp::port);
    return all;
  }

  PortRange ports_;
  std::vector<BoundUdp> expected_;

 private:
  std::list<test::UdpSocket> sockets_;
};

}  // namespace

TEST_F(UdpSockets, AreAllToldWhileOthersComeAndGo) {
  if (!udpSocketsBySockDiag(ports_)) GTEST_SKIP() << "this kernel has no sock_diag for UDP";
  std::jthread others([](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      std::list<test::UdpSocket> some;
      for (int i = 0; i < 8; ++i) some.emplace_back(INADDR_LOOPBACK, 0);
    }
  });
  for (int i = 0; i < 500; ++i) ASSERT_EQ(sorted(boundUdpSockets(ports_).value()), expected_) << i;
}

TEST_F(UdpSockets, AreFoundByTheirAddress) {
  for (const BoundUdp& each : expected_) EXPECT_TRUE(isUdpOpen({INADDR_LOOPBACK, each.port}).value()) << each.port;
  const std::uint32_t onLoopbackAlone = ports_.first + ports_.first % 2U;
  EXPECT_FALSE(isUdpOpen({INADDR_LOOPBACK + 1, onLoopbackAlone}).value());
  EXPECT_TRUE(isUdpOpen({INADDR_LOOPBACK + 1, onLoopbackAlone + 1}).value()) << "bound to any address";
  EXPECT_FALSE(isUdpOpen({INADDR_LOOPBACK, ports_.last + 11U}).value());
}

TEST_F(UdpSockets, AreToldOfByProcToo) {
  // one reading may miss some, while other tests open and close sockets
  std::set<BoundUdp> told;
  const auto deadline = std::chrono::steady_clock::now() + test::kDeadline;
  while (told.size() < expected_.size() && std::chrono::steady_clock::now() < deadline) {
    const auto some = udpSocketsByProc(ports_);
    ASSERT_TRUE(some);
    told.insert(some->begin(), some->end());
  }
  EXPECT_EQ(told, std::set<BoundUdp>(expected_.begin(), expected_.end()));
}

}  // namespace pongsim::transport
