#include "shared/rtps/submessages.hh"

#include <algorithm>
#include <array>

#include "shared/rtps/wire_number.hh"

namespace pongsim::shared {

bool isRtpsMessage(std::span<const std::uint8_t> packet) {
  constexpr std::array<std::uint8_t, 4> kBeginning{'R', 'T', 'P', 'S'};
  return packet.size() >= Submessages::kMessageHeader &&
         std::ranges::equal(packet.first(kBeginning.size()), kBeginning);
}

Submessages::Submessages(std::span<const std::uint8_t> packet) {
  if (isRtpsMessage(packet)) rest_ = packet.subspan(kMessageHeader);
}

std::optional<Submessage> Submessages::next() {
  constexpr std::size_t kHeader = 4, kAlignment = 4;
  constexpr std::uint8_t kPad = 0x01, kInfoTimestamp = 0x09;
  if (rest_.size() < kHeader) {
    isCutOff_ = isCutOff_ || !rest_.empty();
    return std::nullopt;
  }
  Submessage part{rest_[0], rest_[1], {}};
  std::size_t size = readNumber(rest_.subspan(2, 2), part.isLittleEndian());
  rest_ = rest_.subspan(kHeader);
  // a size of zero means up to the end of the message
  if (size == 0 && part.kind != kPad && part.kind != kInfoTimestamp) size = rest_.size();
  if (size > rest_.size()) {
    isCutOff_ = true;
    rest_ = {};
    return std::nullopt;
  }
  part.content = rest_.first(size);
  rest_ = rest_.subspan(std::min(rest_.size(), (size + kAlignment - 1) / kAlignment * kAlignment));
  return part;
}

}  // namespace pongsim::shared
