#include "ros2/wire/announcements.hh"

#include <algorithm>
#include <cstddef>
#include <initializer_list>

#include "ros2/wire/submessages.hh"

namespace pongsim::ros2 {

namespace {

using Octets = std::span<unsigned char>;

// RTPS 2.3: 9.4.1 header, 9.4.5 submessages
constexpr std::size_t kSourceInHeader = 8;
constexpr unsigned char kInfoSource = 0x0c, kData = 0x15, kDataFragment = 0x16;
constexpr unsigned char kLittle = 1, kInlineQos = 2, kWithData = 4, kWithKey = 8;
constexpr std::size_t kInfoSourceSize = 20, kSourceInInfo = 8;
// DATA and DATA_FRAG: flags, octets to the inline QoS, reader, writer, sequence number
constexpr std::size_t kToInlineQos = 2, kDataWriter = 8, kSequence = 12, kBeforeInlineQos = 20;
constexpr std::uint64_t kUsualToInlineQos = 16;

// 9.3.1.3 and 9.3.1.5: entities
constexpr std::array<unsigned char, 4> kAnnouncer{0, 1, 0, 0xc2}, kAnnouncementReader{0, 1, 0, 0xc7},
    kItself{0, 0, 1, 0xc1};
// 9.6.2.2: parameters
constexpr std::uint64_t kEndOfList = 0x01, kLeaseDuration = 0x02, kParticipantGuid = 0x50, kBuiltinEndpoints = 0x58,
                        kKeyHash = 0x70, kStatusInfo = 0x71;
constexpr std::uint64_t kHasAnnouncer = 1;
// 10.2: lists of parameters
constexpr unsigned char kBigList = 2, kLittleList = 3;
constexpr std::size_t kEncapsulation = 4;

// What is added to a clock's time in nanoseconds must not overflow.
constexpr std::uint64_t kEndless = 1 << 30;
// Far more than anybody sends.
constexpr std::uint64_t kLastSequence = std::uint64_t(1) << 48;

GuidPrefix prefixAt(Octets bytes, std::size_t at) {
  GuidPrefix prefix{};
  std::ranges::copy(bytes.subspan(at, prefix.size()), prefix.begin());
  return prefix;
}

/// Reads parameters up to the end of their list.
/// @param take Called with the id and the value of each; returns whether it is as it should be.
/// @return What follows; nothing if the list has no end, or a parameter is not as it should be.
template <class Take>
std::optional<Octets> readList(Octets list, bool isLittle, const Take& take) {
  constexpr std::size_t kId = 2, kBeforeValue = 4;
  while (list.size() >= kBeforeValue) {
    const std::uint64_t id = numberIn(list.first(kId), isLittle);
    const std::size_t size = numberIn(list.subspan(kId, kBeforeValue - kId), isLittle);
    list = list.subspan(kBeforeValue);
    if (id == kEndOfList) return list;
    const std::size_t padded = (size + 3) / 4 * 4;
    if (padded > list.size() || !take(id, list.first(size))) return std::nullopt;
    list = list.subspan(padded);
  }
  return std::nullopt;
}

/// Reads one announcement or goodbye.
class AnnouncementReading {
 public:
  /// @param data With all that precedes its inline QoS.
  /// @param source Whose it is if it doesn't say so.
  /// @return Nothing if it is malformed.
  std::optional<Announcement> read(const Submessage& data, const GuidPrefix& source) {
    const bool isLittle = data.isLittleEndian();
    const Octets content = data.content;
    const unsigned char flags = data.flags;
    const std::uint64_t sequence =
        numberIn(content.subspan(kSequence, 4), isLittle) << 32 | numberIn(content.subspan(kSequence + 4, 4), isLittle);
    if (sequence == 0 || sequence > kLastSequence) return std::nullopt;
    if (numberIn(content.subspan(kToInlineQos, 2), isLittle) != kUsualToInlineQos) return std::nullopt;
    std::optional<Octets> rest = content.subspan(kBeforeInlineQos);
    if ((flags & kInlineQos) != 0) {
      rest = readList(*rest, isLittle, [&](std::uint64_t id, Octets value) { return takeInline(id, value); });
    }
    if (!rest) return std::nullopt;
    const bool isWithData = (flags & kWithData) != 0, isWithKey = (flags & kWithKey) != 0;
    if (!isGone_) {
      if (!isWithData || !readPayload(*rest) || !isNamed_ || !announcement_.lease || !isAnnouncer_) return std::nullopt;
    } else {
      // whose it is, unless that has been told
      if (isWithKey && rest->size() <= kGuid) takeGuid(*rest);
      if (isWithData || (isWithKey && rest->size() > kGuid)) readPayload(*rest);
      if (!isNamed_) announcement_.participant = source;
      announcement_.lease.reset();
    }
    return announcement_;
  }

 private:
  static constexpr std::size_t kGuid = 16;

  bool takeGuid(Octets value) {
    if (value.size() != kGuid || !std::ranges::equal(value.subspan(12), kItself)) return false;
    const GuidPrefix named = prefixAt(value, 0);
    // Fast DDS takes one here and the other there
    if (isNamed_ && named != announcement_.participant) return false;
    announcement_.participant = named;
    return isNamed_ = true;
  }

  bool takeInline(std::uint64_t id, Octets value) {
    constexpr std::size_t kStatus = 4;
    if (id == kKeyHash) return takeGuid(value);
    if (id != kStatusInfo) return true;
    if (value.size() != kStatus) return false;
    // disposed, unregistered or both
    const unsigned char status = value[kStatus - 1];
    if (status >= 1 && status <= 3) isGone_ = true;
    return true;
  }

  bool readPayload(Octets payload) {
    if (payload.size() < kEncapsulation || (payload[1] != kBigList && payload[1] != kLittleList)) return false;
    const bool isLittle = payload[1] == kLittleList;
    const auto take = [&](std::uint64_t id, Octets value) {
      switch (id) {
        case kParticipantGuid:
        case kKeyHash:
          return takeGuid(value);
        case kLeaseDuration:
          return takeLease(value, isLittle);
        case kBuiltinEndpoints:
          isAnnouncer_ = value.size() == 4 && (numberIn(value, isLittle) & kHasAnnouncer) != 0;
          return isAnnouncer_;
        default:
          return true;
      }
    };
    return readList(payload.subspan(kEncapsulation), isLittle, take).has_value();
  }

  /// Takes a lease, which becomes endless. One of less than no time is over.
  bool takeLease(Octets value, bool isLittle) {
    if (value.size() != 8) return false;
    const auto seconds = static_cast<std::int32_t>(numberIn(value.first(4), isLittle));
    const std::uint64_t fraction = numberIn(value.subspan(4), isLittle);
    putNumber(value.first(4), isLittle, kEndless);
    putNumber(value.subspan(4), isLittle, 0);
    announcement_.lease =
        std::max(std::chrono::nanoseconds(0),
                 std::chrono::seconds(seconds) + std::chrono::nanoseconds(fraction * 1'000'000'000 >> 32));
    return true;
  }

  Announcement announcement_;
  bool isNamed_ = false, isGone_ = false, isAnnouncer_ = false;
};

}  // namespace

std::optional<Presence> readPresence(Octets packet) {
  Presence presence;
  if (!isRtpsMessage(packet)) return presence;
  presence.senders.push_back(prefixAt(packet, kSourceInHeader));
  Submessages parts(packet);
  while (const auto part = parts.next()) {
    const Octets content = part->content;
    if (part->kind == kInfoSource) {
      // Fast DDS ends here, too
      if (content.size() != kInfoSourceSize) break;
      presence.senders.push_back(prefixAt(content, kSourceInInfo));
    } else if ((part->kind == kData || part->kind == kDataFragment) && content.size() >= kBeforeInlineQos &&
               std::ranges::equal(content.subspan(kDataWriter, kAnnouncer.size()), kAnnouncer)) {
      const auto announcement =
          part->kind == kData ? AnnouncementReading().read(*part, presence.senders.back()) : std::nullopt;
      if (!announcement) return std::nullopt;
      presence.announcements.push_back(*announcement);
    }
  }
  return presence;
}

std::vector<unsigned char> goodbye(const GuidPrefix& participant, std::uint64_t number) {
  constexpr unsigned char kGuidSize = 16, kStatusSize = 4, kGone = 3;
  std::vector<unsigned char> bytes{'R', 'T', 'P', 'S', 2, 3, 1, 0x0f};
  const auto add = [&](std::initializer_list<unsigned char> more) { bytes.insert(bytes.end(), more); };
  const auto addAll = [&](const auto& more) { bytes.insert(bytes.end(), more.begin(), more.end()); };
  const auto addWord = [&](std::uint64_t word) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<unsigned char>(word >> shift));
  };
  addAll(participant);
  // without a size, for it is the last one
  add({kData, kLittle | kInlineQos, 0, 0, 0, 0, static_cast<unsigned char>(kUsualToInlineQos), 0});
  addAll(kAnnouncementReader);
  addAll(kAnnouncer);
  addWord((kLastSequence + number) >> 32);
  addWord(kLastSequence + number);
  add({static_cast<unsigned char>(kKeyHash), 0, kGuidSize, 0});
  addAll(participant);
  addAll(kItself);
  add({static_cast<unsigned char>(kStatusInfo), 0, kStatusSize, 0, 0, 0, 0, kGone});
  add({static_cast<unsigned char>(kEndOfList), 0, 0, 0});
  return bytes;
}

}  // namespace pongsim::ros2
