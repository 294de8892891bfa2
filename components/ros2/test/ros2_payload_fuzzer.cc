// Arbitrary bytes as input from other participants: the first two select a type, the rest is a payload of it and an
// RTPS packet. Readers must end, stay within the bytes, and use a small multiple of their size as memory; what they
// accept must be encoded to the same bytes.
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fuzz/require.hh"
#include "ros2/test/all_types.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/rmw_dds_common.hh"
#include "ros2/wire/discovery_acknacks.hh"
#include "ros2/wire/discovery_guard.hh"

namespace pongsim::ros2 {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t kChoice = 2;
// The smallest list element is one byte; the largest structure encoded in few bytes has many texts.
constexpr std::size_t kMostGrowth = 64;

using fuzz::require;

void requireEndlessLeases(std::span<const std::uint8_t> packet) {
  const auto message = shared::readAnyRtpsMessage(packet);
  require(message.has_value());
  for (const shared::RtpsDiscovery& each : message->discovery) {
    require(!each.isOfParticipant() || !each.isAlive || each.lease == std::chrono::seconds(1 << 30));
  }
}

template <class Type>
void readAs(Bytes payload) {
  Type value;
  const bool isRead = !readCdr(payload, value).has_value();
  const std::vector<std::byte> written = toCdr(value);
  require(written.size() == cdrSize(value));
  if (!isRead) return;
  require(written.size() <= kMostGrowth * payload.size());
  Type again;
  require(!readCdr(written, again).has_value());
  require(toCdr(again) == written);
}

std::vector<void (*)(Bytes)> readers() {
  std::vector<void (*)(Bytes)> all;
  forAllTypes([&all]<class Type>() { all.push_back(readAs<Type>); });
  all.push_back(readAs<rmw_dds_common::ParticipantEntitiesInfo<24>>);
  all.push_back(readAs<rmw_dds_common::ParticipantEntitiesInfo<16>>);
  return all;
}

}  // namespace
}  // namespace pongsim::ros2

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pongsim::ros2;
  std::vector<std::uint8_t> packet(data, data + size);
  pongsim::fuzz::require(DiscoveryAcknacks().modify({}, packet) <= size / 24);
  DiscoveryGuard().receive(packet, {}, requireEndlessLeases);
  if (size < kChoice) return 0;
  static const auto all = readers();
  const std::size_t choice = data[0] | static_cast<std::size_t>(data[1]) << 8;
  all[choice % all.size()](std::as_bytes(std::span(data, size).subspan(kChoice)));
  return 0;
}
