// Arbitrary bytes as received RTPS messages, each after its length in two bytes. The filter must end, stay within
// the bytes, and change nothing in them but the lease.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "require.hh"
#include "shared/rtps/rtps_message.hh"
#include "split_messages.hh"
#include "transport/udp/rtps_filter.hh"

namespace {

constexpr std::size_t kLeaseBytes = 8;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using pongsim::transport::RtpsFilter;
  RtpsFilter filter({.isDiscovery = [](std::uint32_t port) { return port % 2 == 0; },
                     .isOpen = [](const pongsim::shared::RtpsAddress&) { return true; }});
  RtpsFilter::TimePoint now{};
  pongsim::fuzz::splitMessages({data, size}, [&](std::vector<std::uint8_t>& message, bool) {
    const std::vector<std::uint8_t> before = message;
    filter.decide(message, {0x7f000001, 7410}, RtpsFilter::Side::kLoopback, now);
    const auto read = pongsim::shared::readRtpsMessage(before);
    std::size_t leases = 0;
    if (read) {
      for (const auto& sample : read->discovery) leases += sample.leasesAt.size();
    }
    std::size_t changed = 0;
    for (std::size_t i = 0; i < message.size(); ++i) changed += message[i] != before[i] ? 1 : 0;
    pongsim::fuzz::require(changed <= kLeaseBytes * leases);
    now += std::chrono::milliseconds(100);
  });
  return 0;
}
