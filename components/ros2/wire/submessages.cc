#include "ros2/wire/submessages.hh"

#include <algorithm>
#include <array>

namespace pongsim::ros2 {

std::uint64_t numberIn(std::span<const unsigned char> bytes, bool isLittleEndian) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    number = number << 8 | bytes[isLittleEndian ? bytes.size() - 1 - i : i];
  }
  return number;
}

void putNumber(std::span<unsigned char> bytes, bool isLittleEndian, std::uint64_t number) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[isLittleEndian ? i : bytes.size() - 1 - i] = static_cast<unsigned char>(number >> 8 * i);
  }
}

bool isRtpsMessage(std::span<const unsigned char> packet) {
  constexpr std::array<unsigned char, 4> kBeginning{'R', 'T', 'P', 'S'};
  return packet.size() >= Submessages::kMessageHeader &&
         std::ranges::equal(packet.first(kBeginning.size()), kBeginning);
}

Submessages::Submessages(std::span<unsigned char> packet) {
  if (isRtpsMessage(packet)) rest_ = packet.subspan(kMessageHeader);
}

std::optional<Submessage> Submessages::next() {
  constexpr std::size_t kHeader = 4, kAlignment = 4;
  constexpr unsigned char kPad = 0x01, kInfoTimestamp = 0x09;
  if (rest_.size() < kHeader) return std::nullopt;
  Submessage part{rest_[0], rest_[1], {}};
  std::size_t size = numberIn(rest_.subspan(2, 2), part.isLittleEndian());
  rest_ = rest_.subspan(kHeader);
  // a size of zero means up to the end of the message
  if (size == 0 && part.kind != kPad && part.kind != kInfoTimestamp) size = rest_.size();
  if (size > rest_.size()) {
    rest_ = {};
    return std::nullopt;
  }
  part.content = rest_.first(size);
  rest_ = rest_.subspan(std::min(rest_.size(), (size + kAlignment - 1) / kAlignment * kAlignment));
  return part;
}

}  // namespace pongsim::ros2
