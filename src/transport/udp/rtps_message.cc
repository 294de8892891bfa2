#include "transport/udp/rtps_message.hh"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "transport/payload.hh"

#include "transport/wire_number.hh"

namespace pongsim::transport {

namespace {

constexpr std::size_t kHeader = 20, kSubmessageHeader = 4, kEncapsulation = 4;
constexpr RtpsEntity kParticipant = 0x000001c1;
// The flag of a submessage that is little-endian.
constexpr std::uint8_t kLittle = 1;
constexpr std::uint64_t kMostInSet = 256;
// Far more than anybody has ever sent. Fast DDS 2.9 ends the process where a number is the last one that there is.
constexpr std::uint64_t kLastNumber = std::uint64_t(1) << 48;

namespace submessage {
constexpr std::uint8_t kAckNack = 0x06, kHeartbeat = 0x07, kGap = 0x08, kInfoTs = 0x09, kPad = 0x01, kInfoSrc = 0x0c,
                       kInfoDst = 0x0e, kNackFrag = 0x12, kData = 0x15, kDataFrag = 0x16, kFirstOfVendors = 0x80;
}  // namespace submessage

namespace parameter {
constexpr std::uint16_t kSentinel = 0x01, kLease = 0x02, kDefaultUnicast = 0x31, kMetatrafficUnicast = 0x32,
                        kParticipantGuid = 0x50, kEndpointGuid = 0x5a, kKeyHash = 0x70;
}  // namespace parameter

/// Takes numbers off the beginning of some bytes. What is not there reads as 0 and spoils the reading.
class Reading {
 public:
  Reading(std::span<const std::uint8_t> bytes, bool isLittleEndian) : rest_(bytes), isLittleEndian_(isLittleEndian) {}

  bool isGood() const { return isGood_; }
  std::span<const std::uint8_t> rest() const { return rest_; }

  std::span<const std::uint8_t> take(std::size_t count) {
    if (count > rest_.size()) {
      isGood_ = false;
      return {};
    }
    const auto taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }
  std::uint64_t number(std::size_t size) { return readNumber(take(size), isLittleEndian_); }
  RtpsEntity entity() {
    RtpsEntity id = 0;
    for (const std::uint8_t each : take(4)) id = id << 8 | each;
    return id;
  }
  std::uint64_t sequence() {
    const std::uint64_t upper = number(4);
    return upper << 32 | number(4);
  }

 private:
  std::span<const std::uint8_t> rest_;
  bool isLittleEndian_;
  bool isGood_ = true;
};

std::optional<RtpsPrefix> prefixIn(std::span<const std::uint8_t> value) {
  RtpsPrefix prefix{};
  if (value.size() < prefix.size()) return std::nullopt;
  std::copy_n(value.begin(), prefix.size(), prefix.begin());
  return prefix;
}

/// A message as it is written, little-endian.
class Writing {
 public:
  explicit Writing(const RtpsPrefix& source) : bytes_{'R', 'T', 'P', 'S', 2, 3, 1, 0x0f} { add(source); }

  void add(std::initializer_list<std::uint8_t> more) { bytes_.insert(bytes_.end(), more); }
  void add(const RtpsPrefix& prefix) { bytes_.insert(bytes_.end(), prefix.begin(), prefix.end()); }
  void add32(std::uint64_t number) {
    for (int shift = 0; shift < 32; shift += 8) bytes_.push_back(static_cast<std::uint8_t>(number >> shift));
  }
  void addEntity(RtpsEntity id) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes_.push_back(static_cast<std::uint8_t>(id >> shift));
  }
  void addSequence(std::uint64_t number) {
    add32(number >> 32);
    add32(number);
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Reads whose the sample is.
/// @return Whether the GUID is one, and contradicts no other.
bool takeGuid(std::span<const std::uint8_t> value, RtpsDiscovery& sample) {
  const auto prefix = prefixIn(value);
  if (!prefix || (sample.prefix && sample.prefix != prefix)) return false;
  sample.prefix = prefix;
  // the library would know another one under the name of this
  return !sample.isOfParticipant() || Reading(value.subspan(prefix->size()), true).entity() == kParticipant;
}

/// Reads a list of parameters up to its end.
/// @param whole The message that it is in.
/// @return Whether it is one, with what it says in `sample`.
bool readParameters(Reading& list, std::span<const std::uint8_t> whole, RtpsDiscovery& sample) {
  constexpr std::uint32_t kUdpV4 = 1;
  while (true) {
    const std::uint64_t id = list.number(2);
    const std::uint64_t length = list.number(2);
    if (id == parameter::kSentinel) return list.isGood();
    const auto value = list.take(length);
    if (!list.isGood()) return false;
    Reading reading(value, sample.isLittleEndian);
    if (id == parameter::kParticipantGuid || id == parameter::kEndpointGuid || id == parameter::kKeyHash) {
      if (!takeGuid(value, sample)) return false;
    } else if (id == parameter::kLease) {
      if (length != 8) return false;
      sample.leaseAt = static_cast<std::size_t>(value.data() - whole.data());
    } else if (id == parameter::kDefaultUnicast || id == parameter::kMetatrafficUnicast) {
      const bool isUdp = reading.number(4) == kUdpV4;
      const auto port = static_cast<std::uint32_t>(reading.number(4));
      reading.take(12);
      const RtpsAddress address{reading.entity(), port};
      if (!reading.isGood()) return false;
      if (isUdp) sample.addresses.push_back(address);
      if (isUdp && id == parameter::kMetatrafficUnicast) sample.discoveryAddresses.push_back(address);
    }
  }
}

/// @return The reader of a writer of discovery.
constexpr RtpsEntity readerOf(RtpsEntity writer) { return (writer & ~RtpsEntity(0xff)) | 0xc7; }

bool isDiscovery(RtpsEntity writer) {
  return writer == kSpdpWriter || writer == kPublicationsWriter || writer == kSubscriptionsWriter;
}

/// Reads DATA.
bool readData(Reading body, std::uint8_t flags, std::span<const std::uint8_t> whole, RtpsMessage& message) {
  constexpr std::uint8_t kInlineQos = 2, kWithData = 4, kWithKey = 8;
  constexpr std::size_t kLongestKey = 16;
  constexpr std::uint64_t kUpToInlineQos = 16;
  body.take(2);
  const std::uint64_t toInlineQos = body.number(2);
  body.take(4);
  const RtpsEntity writer = body.entity();
  const std::uint64_t number = body.sequence();
  if (!body.isGood() || number == 0 || number > kLastNumber) return false;
  if (!isDiscovery(writer)) {
    ++message.others;
    return true;
  }
  // parameters of its own before the list are of no version that there is
  if (toInlineQos != kUpToInlineQos) return false;
  RtpsDiscovery sample;
  sample.writer = writer;
  sample.sequence = number;
  sample.isLittleEndian = (flags & kLittle) != 0;
  sample.isAlive = (flags & kWithData) != 0;
  sample.bytes = body.rest().size();
  if ((flags & kInlineQos) != 0 && !readParameters(body, whole, sample)) return false;
  // Fast DDS takes so short a key for whose the sample is, whatever the list says
  if ((flags & kWithKey) != 0 && body.rest().size() <= kLongestKey) {
    if (sample.isAlive || !takeGuid(body.rest(), sample)) return false;
  }
  // it is read from what follows alone
  sample.leaseAt.reset();
  if (sample.isAlive) {
    constexpr std::uint8_t kBigList = 2, kLittleList = 3;
    const auto kind = body.take(kEncapsulation);
    if (!body.isGood() || kind[0] != 0 || (kind[1] != kBigList && kind[1] != kLittleList)) return false;
    sample.isLittleEndian = kind[1] == kLittleList;
    Reading list(body.rest(), sample.isLittleEndian);
    if (!readParameters(list, whole, sample)) return false;
  }
  message.discovery.push_back(std::move(sample));
  return true;
}

bool readDataFrag(Reading body) {
  body.take(8);
  const RtpsEntity writer = body.entity();
  const std::uint64_t number = body.sequence();
  const std::uint64_t first = body.number(4);
  const std::uint64_t count = body.number(2);
  const std::uint64_t size = body.number(2);
  const std::uint64_t whole = body.number(4);
  if (!body.isGood() || isDiscovery(writer) || number == 0 || number > kLastNumber) return false;
  return first > 0 && count > 0 && size > 0 && whole <= payloadSize(kMaximumMessage) &&
         (first + count - 2) * size < whole;
}

bool readHeartbeat(Reading body, RtpsMessage& message) {
  body.take(4);
  const RtpsEntity writer = body.entity();
  const std::uint64_t first = body.sequence();
  const std::uint64_t last = body.sequence();
  if (isDiscovery(writer)) {
    message.heartbeats.push_back({writer, last});
  } else {
    ++message.others;
  }
  // without samples the last is the one before the first
  return body.isGood() && first > 0 && first <= kLastNumber && last <= kLastNumber && last + 1 >= first;
}

bool readGap(Reading body, RtpsMessage& message) {
  body.take(8);
  const std::uint64_t first = body.sequence();
  const std::uint64_t base = body.sequence();
  const std::uint64_t bits = body.number(4);
  if (!body.isGood() || first == 0 || base < first || base > kLastNumber || bits > kMostInSet) return false;
  message.gapNumbers += base - first + bits;
  return true;
}

/// Reads ACKNACK or, of fragments, NACK_FRAG.
bool readWish(Reading body, bool isFragments, RtpsMessage& message) {
  constexpr std::uint64_t kLastCount = 0x7fff'ffff;
  const RtpsEntity reader = body.entity();
  const RtpsEntity writer = body.entity();
  const std::uint64_t number = body.sequence();
  if (isFragments) body.take(4);
  const std::uint64_t bits = body.number(4);
  if (!body.isGood() || number > kLastNumber || bits > kMostInSet) return false;
  if (bits > 0) ++message.wishes;
  if (isFragments || !isDiscovery(writer)) return true;
  body.take((bits + 31) / 32 * 4);
  const std::uint64_t count = body.number(4);
  if (reader == readerOf(writer)) {
    message.acknowledgements.push_back({writer, number, static_cast<std::uint32_t>(count)});
  }
  return body.isGood() && count <= kLastCount;
}

bool isAboutMessage(std::uint8_t kind) {
  return kind == submessage::kPad || kind == submessage::kInfoTs || kind == submessage::kInfoDst ||
         kind >= submessage::kFirstOfVendors;
}

bool readSubmessage(std::uint8_t kind, std::uint8_t flags, Reading body, std::span<const std::uint8_t> whole,
                    RtpsMessage& message) {
  if (kind != submessage::kData && kind != submessage::kHeartbeat && !isAboutMessage(kind)) ++message.others;
  switch (kind) {
    case submessage::kData:
      return readData(body, flags, whole, message);
    case submessage::kDataFrag:
      return readDataFrag(body);
    case submessage::kHeartbeat:
      return readHeartbeat(body, message);
    case submessage::kGap:
      return readGap(body, message);
    case submessage::kAckNack:
    case submessage::kNackFrag:
      return readWish(body, kind == submessage::kNackFrag, message);
    case submessage::kInfoDst:
      message.isAddressed |= prefixIn(body.rest()).value_or(RtpsPrefix{}) != RtpsPrefix{};
      return true;
    case submessage::kInfoSrc:
      body.take(8);
      return prefixIn(body.rest()) == message.source;
    default:
      return true;
  }
}

}  // namespace

std::optional<RtpsMessage> readRtpsMessage(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 5> kBeginning = {'R', 'T', 'P', 'S', 2};
  if (bytes.size() < kHeader || !std::equal(kBeginning.begin(), kBeginning.end(), bytes.begin())) return std::nullopt;
  RtpsMessage message;
  message.source = *prefixIn(bytes.subspan(8));
  auto rest = bytes.subspan(kHeader);
  while (!rest.empty()) {
    if (rest.size() < kSubmessageHeader) return std::nullopt;
    const std::uint8_t kind = rest[0];
    const std::uint8_t flags = rest[1];
    const bool isLittleEndian = (flags & 1) != 0;
    std::size_t length = Reading(rest.subspan(2), isLittleEndian).number(2);
    rest = rest.subspan(kSubmessageHeader);
    // the last one may say nothing of its length
    if (length == 0 && kind != submessage::kInfoTs && kind != submessage::kPad) length = rest.size();
    if (length > rest.size()) return std::nullopt;
    if (!readSubmessage(kind, flags, Reading(rest.first(length), isLittleEndian), bytes, message)) return std::nullopt;
    rest = rest.subspan(std::min(rest.size(), (length + 3) / 4 * 4));
  }
  return message;
}

std::vector<std::uint8_t> announcementWithoutLease(const RtpsPrefix& participant, std::uint64_t sequence) {
  constexpr std::uint8_t kWithData = 4;
  Writing message(participant);
  // without a length, for it is the last one
  message.add({submessage::kData, kLittle | kWithData, 0, 0, 0, 0, 16, 0});
  message.addEntity(readerOf(kSpdpWriter));
  message.addEntity(kSpdpWriter);
  message.addSequence(sequence);
  message.add({0, 3, 0, 0});
  message.add({parameter::kParticipantGuid, 0, 16, 0});
  message.add(participant);
  message.addEntity(kParticipant);
  message.add({parameter::kLease, 0, 8, 0});
  message.add32(0);
  message.add32(1);
  message.add({parameter::kSentinel, 0, 0, 0});
  return message.take();
}

std::vector<std::uint8_t> acknowledgementBy(const RtpsPrefix& participant,
                                            std::span<const RtpsAcknowledgement> acknowledgements) {
  constexpr std::uint8_t kFinal = 2, kLength = 24;
  Writing message(participant);
  for (const RtpsAcknowledgement& each : acknowledgements) {
    message.add({submessage::kAckNack, kLittle | kFinal, kLength, 0});
    message.addEntity(readerOf(each.writer));
    message.addEntity(each.writer);
    message.addSequence(each.below);
    message.add32(0);
    message.add32(each.count);
  }
  return message.take();
}

}  // namespace pongsim::transport
