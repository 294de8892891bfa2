#include "transport/udp_sockets.hh"

#include <gtest/gtest.h>
#include <netinet/in.h>

#include <algorithm>
#include <cstdint>
#include <list>
#include <set>
#include <thread>
#include <vector>

#include "support/test_domain.hh"
#include "support/udp_socket.hh"
#include "transport/domain.hh"

namespace pongsim::transport {

namespace {

/// Sockets at many ports that no other test uses: so many that the kernel tells of them in several pieces.
class UdpSockets : public testing::Test {
 protected:
  UdpSockets() {
    const DiscoveryPorts ports = discoveryPorts(test::testDomain());
    for (std::uint32_t i = 0; i < 2 * ports.count; ++i) {
      const std::uint32_t address = i % 2 == 0 ? INADDR_LOOPBACK : INADDR_ANY;
      expected_.push_back({address, ports.first + i});
      sockets_.emplace_back(address, ports.first + i);
    }
  }

  std::vector<BoundUdp> ours(const std::vector<BoundUdp>& all) const {
    std::vector<BoundUdp> ours;
    for (const BoundUdp& each : all) {
      if (each.port >= expected_.front().port && each.port <= expected_.back().port) ours.push_back(each);
    }
    std::ranges::sort(ours, {}, &BoundUdp::port);
    return ours;
  }

  std::vector<BoundUdp> expected_;

 private:
  std::list<test::UdpSocket> sockets_;
};

}  // namespace

TEST_F(UdpSockets, AreAllToldWhileOthersComeAndGo) {
  if (!udpSocketsBySockDiag()) GTEST_SKIP() << "this kernel has no sock_diag for UDP";
  std::jthread others([](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      std::list<test::UdpSocket> some;
      for (int i = 0; i < 8; ++i) some.emplace_back(INADDR_LOOPBACK, 0);
    }
  });
  for (int i = 0; i < 500; ++i) ASSERT_EQ(ours(boundUdpSockets().value()), expected_) << i;
}

TEST_F(UdpSockets, AreToldOfByProcToo) {
  const auto told = udpSocketsByProc();
  ASSERT_TRUE(told);
  // some may be missing where other tests open and close sockets just now
  const std::vector<BoundUdp> found = ours(*told);
  EXPECT_GT(found.size(), expected_.size() / 2);
  const std::set<BoundUdp> known(expected_.begin(), expected_.end());
  EXPECT_TRUE(std::ranges::all_of(found, [&known](const BoundUdp& each) { return known.contains(each); }));
}

}  // namespace pongsim::transport
