// Arbitrary bytes as data from other processes: a sample, headers of requests and replies, a traffic report, messages
// of several types. Readers must end and stay within the bytes, and what they accept must be encoded to the same bytes.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "msgs/encoding/bytes.hh"
#include "pongsim/message.hh"
#include "require.hh"
#include "transport/network/traffic_report.hh"
#include "transport/payload.hh"
#include "transport/services/service_payload.hh"

namespace {

using pongsim::fuzz::require;
using Bytes = std::span<const std::byte>;

template <class Header>
void requireSame(const Header& header, Bytes whole, Bytes message) {
  std::vector<std::byte> written(pongsim::transport::headerSize(header) + message.size());
  std::ranges::copy(message, pongsim::transport::writeHeader(header, written).begin());
  require(std::ranges::equal(written, whole));
}

void readSample(Bytes bytes) {
  pongsim::transport::keepingOf(bytes);
  const auto message = pongsim::transport::messageInPayload(bytes);
  if (!message) return;
  std::vector<std::byte> sample(pongsim::transport::payloadSize(message->size()));
  std::ranges::copy(*message, pongsim::transport::framePayload(sample, message->size()).begin());
  const auto again = pongsim::transport::messageInPayload(sample);
  require(again && std::ranges::equal(*again, *message));
}

void readMessages(Bytes bytes) {
  for (const char* type : {"Twist", "Pose_V", "WorldControl", "Image", "StringMsg_V", "EntityFactory"}) {
    const pongsim::MessagePointer message = pongsim::newMessage(type);
    if (!pongsim::msgs::parseBytes(bytes, *message)) continue;
    pongsim::messageText(*message);
    pongsim::messageJson(*message);
    std::vector<std::byte> written(pongsim::msgs::byteSize(*message));
    pongsim::msgs::writeBytes(*message, written);
    require(pongsim::msgs::parseBytes(written, *message));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes bytes = std::as_bytes(std::span(data, size));
  readSample(bytes);
  Bytes rest = bytes;
  if (const auto request = pongsim::transport::readRequestHeader(rest)) requireSame(*request, bytes, rest);
  rest = bytes;
  if (const auto reply = pongsim::transport::readReplyHeader(rest)) requireSame(*reply, bytes, rest);
  if (const auto traffic = pongsim::transport::readTraffic(bytes)) {
    require(std::ranges::equal(pongsim::transport::trafficBytes(*traffic), bytes));
  }
  readMessages(bytes);
  return 0;
}
