#include "shared/rtps/rtps_message.hh"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "shared/rtps/submessages.hh"
#include "shared/rtps/wire_number.hh"

namespace pongsim::shared {

namespace {

constexpr std::size_t kEncapsulation = 4;
constexpr RtpsEntity kParticipant = 0x000001c1;
// Flag E of a submessage: little-endian.
constexpr std::uint8_t kLittle = 1;
constexpr std::uint64_t kMostInSet = 256;
// Largest accepted sequence number, far above what is sent in practice. At the largest representable one, an assertion
// of Fast DDS 2.9 ends the process.
constexpr std::uint64_t kLastNumber = std::uint64_t(1) << 48;

namespace submessage {
constexpr std::uint8_t kAckNack = 0x06, kHeartbeat = 0x07, kGap = 0x08, kInfoTs = 0x09, kPad = 0x01, kInfoSrc = 0x0c,
                       kInfoDst = 0x0e, kNackFrag = 0x12, kData = 0x15, kDataFrag = 0x16, kFirstOfVendors = 0x80;
}  // namespace submessage

namespace parameter {
constexpr std::uint16_t kSentinel = 0x01, kLease = 0x02, kUserData = 0x2c, kDefaultUnicast = 0x31,
                        kMetatrafficUnicast = 0x32, kParticipantGuid = 0x50, kEndpoints = 0x58, kEndpointGuid = 0x5a,
                        kEntityName = 0x62, kKeyHash = 0x70, kStatus = 0x71;
}  // namespace parameter

/// Reads numbers from the beginning of a range of bytes. Beyond its end it reads 0, and `isGood` becomes false.
class ByteReader {
 public:
  ByteReader(std::span<const std::uint8_t> bytes, bool isLittleEndian)
      : rest_(bytes), isLittleEndian_(isLittleEndian) {}

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

/// Builds a message, little-endian.
class MessageWriter {
 public:
  explicit MessageWriter(const RtpsPrefix& source) : bytes_{'R', 'T', 'P', 'S', 2, 3, 1, 0x0f} { add(source); }

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

constexpr std::size_t kGuidSize = 16;

/// Reads the GUID of the sample's participant or endpoint.
/// @return Whether it is valid and equal to the sample's other GUIDs. Fast DDS would use different ones for different
/// purposes.
bool readGuid(std::span<const std::uint8_t> value, RtpsDiscovery& sample) {
  if (value.size() != kGuidSize) return false;
  const auto prefix = prefixIn(value);
  if (sample.prefix && sample.prefix != prefix) return false;
  sample.prefix = prefix;
  // Fast DDS would store a participant under the GUID of another entity
  return !sample.isOfParticipant() || ByteReader(value.subspan(prefix->size()), true).entity() == kParticipant;
}

bool readAddress(ByteReader value, bool isForDiscovery, RtpsDiscovery& sample) {
  constexpr std::uint32_t kUdpV4 = 1;
  const bool isUdp = value.number(4) == kUdpV4;
  const auto port = static_cast<std::uint32_t>(value.number(4));
  value.take(12);
  const RtpsAddress address{value.entity(), port};
  if (!value.isGood()) return false;
  if (isUdp) sample.addresses.push_back(address);
  if (isUdp && isForDiscovery) sample.discoveryAddresses.push_back(address);
  return true;
}

bool readLease(ByteReader value, std::size_t at, RtpsDiscovery& sample) {
  const std::chrono::seconds seconds(value.number(4));
  const std::uint64_t fraction = value.number(4);
  if (!value.isGood() || !value.rest().empty()) return false;
  sample.lease = seconds + std::chrono::nanoseconds(fraction * 1'000'000'000 >> 32);
  sample.leasesAt.push_back(at);
  return true;
}

/// @return What is in a string, without the zero at its end, or in a sequence of bytes; as much of it as there is.
std::string readText(ByteReader value) {
  const std::uint64_t length = value.number(4);
  const auto bytes = value.rest().first(std::min<std::size_t>(length, value.rest().size()));
  std::string text(bytes.begin(), bytes.end());
  if (text.ends_with('\0')) text.pop_back();
  return text;
}

/// Reads a parameter of the description of a participant or an endpoint.
/// @param whole The message that contains it.
bool readParameter(std::uint64_t id, std::span<const std::uint8_t> value, std::span<const std::uint8_t> whole,
                   RtpsDiscovery& sample) {
  constexpr std::uint64_t kParticipantAnnouncer = 1;
  ByteReader reading(value, sample.isLittleEndian);
  switch (id) {
    case parameter::kParticipantGuid:
    case parameter::kKeyHash:
      return readGuid(value, sample);
    case parameter::kEndpointGuid:
      return sample.isOfParticipant() || readGuid(value, sample);
    case parameter::kLease:
      return readLease(reading, static_cast<std::size_t>(value.data() - whole.data()), sample);
    case parameter::kDefaultUnicast:
    case parameter::kMetatrafficUnicast:
      return readAddress(reading, id == parameter::kMetatrafficUnicast, sample);
    case parameter::kEntityName:
    case parameter::kUserData:
      if (sample.isOfParticipant()) {
        (id == parameter::kEntityName ? sample.name : sample.userData) = readText(reading);
      }
      return true;
    case parameter::kEndpoints:
      sample.announcesItself = value.size() == 4 && (reading.number(4) & kParticipantAnnouncer) != 0;
      return sample.announcesItself || !sample.isOfParticipant();
    default:
      return true;
  }
}

/// Reads a parameter of the inline QoS (RTPS 2.3, 9.6.3): the GUID (key hash), and whether it is removed (status).
bool readInlineParameter(std::uint64_t id, std::span<const std::uint8_t> value, RtpsDiscovery& sample) {
  constexpr std::uint8_t kDisposedOrUnregistered = 3;
  if (id == parameter::kKeyHash) return readGuid(value, sample);
  if (id != parameter::kStatus) return true;
  if (value.size() != 4) return false;
  sample.isGone = sample.isGone || (value[3] >= 1 && value[3] <= kDisposedOrUnregistered);
  return true;
}

/// Reads a list of parameters up to its sentinel.
/// @param take Called with the id and value of each; returns whether they are valid.
template <class Take>
bool readParameters(ByteReader& list, const Take& take) {
  while (true) {
    const std::uint64_t id = list.number(2);
    const std::uint64_t length = list.number(2);
    if (id == parameter::kSentinel) return list.isGood();
    const auto value = list.take(length);
    // padded to a multiple of four
    list.take((4 - length % 4) % 4);
    if (!list.isGood() || !take(id, value)) return false;
  }
}

/// @return The reader that belongs to a discovery writer.
constexpr RtpsEntity readerOf(RtpsEntity writer) { return (writer & ~RtpsEntity(0xff)) | 0xc7; }

bool isDiscovery(RtpsEntity writer) {
  return writer == kSpdpWriter || writer == kPublicationsWriter || writer == kSubscriptionsWriter;
}

/// Reads the payload of discovery data: the description of a participant or an endpoint, or its key.
bool readDescription(ByteReader body, std::span<const std::uint8_t> whole, RtpsDiscovery& sample) {
  constexpr std::uint8_t kBigList = 2, kLittleList = 3;
  const auto kind = body.take(kEncapsulation);
  if (!body.isGood() || kind[0] != 0 || (kind[1] != kBigList && kind[1] != kLittleList)) return false;
  sample.isLittleEndian = kind[1] == kLittleList;
  ByteReader list(body.rest(), sample.isLittleEndian);
  return readParameters(list,
                        [&](std::uint64_t id, const auto& value) { return readParameter(id, value, whole, sample); });
}

/// Reads discovery DATA after its sequence number.
bool readDiscovery(ByteReader body, std::uint8_t flags, std::span<const std::uint8_t> whole, RtpsDiscovery& sample) {
  constexpr std::uint8_t kInlineQos = 2, kWithData = 4, kWithKey = 8;
  const auto take = [&](std::uint64_t id, const auto& value) { return readInlineParameter(id, value, sample); };
  if ((flags & kInlineQos) != 0 && !readParameters(body, take)) return false;
  const bool isWithData = (flags & kWithData) != 0, isWithKey = (flags & kWithKey) != 0;
  sample.isAlive = isWithData && !sample.isGone;
  // Fast DDS reads a key of at most this size as the GUID
  if (isWithKey && body.rest().size() <= kGuidSize) return !isWithData && readGuid(body.rest(), sample);
  return (!isWithData && !isWithKey) || readDescription(body, whole, sample);
}

bool readData(ByteReader body, const Submessage& data, const RtpsPrefix& sender, std::span<const std::uint8_t> whole,
              RtpsMessage& message) {
  constexpr std::uint64_t kUpToInlineQos = 16;
  body.take(2);
  const std::uint64_t toInlineQos = body.number(2);
  body.take(4);
  const RtpsEntity writer = body.entity();
  const std::uint64_t number = body.sequence();
  const bool isGood = body.isGood() && number > 0 && number <= kLastNumber;
  if (!isDiscovery(writer)) {
    ++message.others;
    return isGood;
  }
  RtpsDiscovery sample;
  sample.writer = writer;
  sample.sequence = number;
  sample.sender = sender;
  sample.isLittleEndian = data.isLittleEndian();
  sample.bytes = body.rest().size();
  // no version of the protocol has further fields before the inline QoS
  if (!isGood || toInlineQos != kUpToInlineQos || !readDiscovery(body, data.flags, whole, sample)) {
    message.hasUnreadParticipant |= writer == kSpdpWriter;
    return false;
  }
  message.discovery.push_back(std::move(sample));
  return true;
}

bool readDataFrag(ByteReader body, RtpsMessage& message) {
  body.take(8);
  const RtpsEntity writer = body.entity();
  const std::uint64_t number = body.sequence();
  const std::uint64_t first = body.number(4);
  const std::uint64_t count = body.number(2);
  const std::uint64_t size = body.number(2);
  const std::uint64_t whole = body.number(4);
  message.hasUnreadParticipant |= writer == kSpdpWriter;
  message.largestFragmented = std::max(message.largestFragmented, whole);
  if (!body.isGood() || isDiscovery(writer) || number == 0 || number > kLastNumber) return false;
  return first > 0 && count > 0 && size > 0 && (first + count - 2) * size < whole;
}

bool readHeartbeat(ByteReader body, RtpsMessage& message) {
  body.take(4);
  const RtpsEntity writer = body.entity();
  const std::uint64_t first = body.sequence();
  const std::uint64_t last = body.sequence();
  if (isDiscovery(writer)) {
    message.heartbeats.push_back({writer, last});
  } else {
    ++message.others;
  }
  // of an empty history, the last number is that before the first
  return body.isGood() && first > 0 && first <= kLastNumber && last <= kLastNumber && last + 1 >= first;
}

bool readGap(ByteReader body, RtpsMessage& message) {
  body.take(8);
  const std::uint64_t first = body.sequence();
  const std::uint64_t base = body.sequence();
  const std::uint64_t bits = body.number(4);
  if (!body.isGood() || first == 0 || base < first || base > kLastNumber || bits > kMostInSet) return false;
  message.gapNumbers += base - first + bits;
  return true;
}

/// Reads ACKNACK, or NACK_FRAG if `isFragments`.
bool readAcknowledgement(ByteReader body, bool isFragments, RtpsMessage& message) {
  constexpr std::uint64_t kLastCount = 0x7fff'ffff;
  const RtpsEntity reader = body.entity();
  const RtpsEntity writer = body.entity();
  const std::uint64_t number = body.sequence();
  if (isFragments) body.take(4);
  const std::uint64_t bits = body.number(4);
  if (!body.isGood() || number > kLastNumber || bits > kMostInSet) return false;
  if (bits > 0) ++message.repeatRequests;
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

/// @param sender The participant that sends it; INFO_SRC changes it.
/// @return Whether it is proper (`RtpsMessage::isProper`).
bool readSubmessage(const Submessage& part, RtpsPrefix& sender, std::span<const std::uint8_t> whole,
                    RtpsMessage& message) {
  ByteReader body(part.content, part.isLittleEndian());
  if (part.kind != submessage::kData && part.kind != submessage::kHeartbeat && !isAboutMessage(part.kind)) {
    ++message.others;
  }
  switch (part.kind) {
    case submessage::kData:
      return readData(body, part, sender, whole, message);
    case submessage::kDataFrag:
      return readDataFrag(body, message);
    case submessage::kHeartbeat:
      return readHeartbeat(body, message);
    case submessage::kGap:
      return readGap(body, message);
    case submessage::kAckNack:
    case submessage::kNackFrag:
      return readAcknowledgement(body, part.kind == submessage::kNackFrag, message);
    case submessage::kInfoDst:
      message.isAddressed |= prefixIn(body.rest()).value_or(RtpsPrefix{}) != RtpsPrefix{};
      return true;
    case submessage::kInfoSrc:
      body.take(8);
      sender = prefixIn(body.rest()).value_or(RtpsPrefix{});
      if (sender != message.source) message.otherSources.push_back(sender);
      return sender == message.source;
    default:
      return true;
  }
}

}  // namespace

bool isOfPongsim(const RtpsDiscovery& sample) { return sample.name.starts_with(kPongsimName); }

bool isOfPongsimRos(const RtpsDiscovery& sample) { return sample.userData.find(kPongsimRosMark) != std::string::npos; }

std::optional<RtpsMessage> readAnyRtpsMessage(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kVersion = 4, kInfoSourceSize = 20;
  if (!isRtpsMessage(bytes)) return std::nullopt;
  RtpsMessage message;
  message.source = *prefixIn(bytes.subspan(8));
  message.isProper = bytes[kVersion] == 2;
  RtpsPrefix sender = message.source;
  Submessages parts(bytes);
  while (const auto part = parts.next()) {
    // as Fast DDS, which ignores the rest
    if (part->kind == submessage::kInfoSrc && part->content.size() != kInfoSourceSize) {
      message.isProper = false;
      break;
    }
    message.isProper &= readSubmessage(*part, sender, bytes, message);
  }
  message.isProper &= !parts.isCutOff();
  return message;
}

std::optional<RtpsMessage> readRtpsMessage(std::span<const std::uint8_t> bytes) {
  std::optional<RtpsMessage> message = readAnyRtpsMessage(bytes);
  if (message && !message->isProper) message.reset();
  return message;
}

std::vector<std::uint8_t> announcementWithoutLease(const RtpsPrefix& participant, std::uint64_t sequence) {
  constexpr std::uint8_t kWithData = 4;
  MessageWriter message(participant);
  // length 0: to the end of the message
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

std::vector<std::uint8_t> goodbyeBy(const RtpsPrefix& participant, std::uint64_t number) {
  constexpr std::uint8_t kInlineQos = 2, kDisposedAndUnregistered = 3;
  MessageWriter message(participant);
  // length 0: to the end of the message
  message.add({submessage::kData, kLittle | kInlineQos, 0, 0, 0, 0, 16, 0});
  message.addEntity(readerOf(kSpdpWriter));
  message.addEntity(kSpdpWriter);
  message.addSequence(kLastNumber + number);
  message.add({parameter::kKeyHash, 0, kGuidSize, 0});
  message.add(participant);
  message.addEntity(kParticipant);
  message.add({parameter::kStatus, 0, 4, 0, 0, 0, 0, kDisposedAndUnregistered});
  message.add({parameter::kSentinel, 0, 0, 0});
  return message.take();
}

std::vector<std::uint8_t> acknowledgementBy(const RtpsPrefix& participant,
                                            std::span<const RtpsAcknowledgement> acknowledgements) {
  constexpr std::uint8_t kFinal = 2, kLength = 24;
  MessageWriter message(participant);
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

}  // namespace pongsim::shared
