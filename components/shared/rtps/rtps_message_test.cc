#include "shared/rtps/rtps_message.hh"

#include <gtest/gtest.h>

#include <limits>

#include "hostile/packet.hh"

namespace pongsim::shared {

namespace {

using hostile::Kind;
using hostile::Packet;

constexpr RtpsPrefix kSourcePrefix = {1, 15, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
constexpr RtpsPrefix kOtherPrefix = {1, 15, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9};
constexpr std::uint32_t kThisMachine = 0x7f000001;

void beginSample(Packet& packet, RtpsEntity writer, std::int64_t number = 1) {
  packet.beginData(0, writer, number, hostile::kWithData);
  packet.add32(0x00000300);
}

std::optional<RtpsMessage> readPacket(const Packet& packet) { return readRtpsMessage(packet.bytes()); }

std::optional<RtpsMessage> readGap(std::int64_t first, std::int64_t base, std::uint32_t bits) {
  Packet packet(kSourcePrefix);
  packet.begin(Kind::kGap);
  packet.add32(0);
  packet.add32(0);
  packet.addSequence(first);
  packet.addSequenceSet(base, bits);
  packet.end();
  return readPacket(packet);
}

bool takesHeartbeat(std::int64_t first, std::int64_t last) {
  Packet packet(kSourcePrefix);
  packet.begin(Kind::kHeartbeat);
  packet.add32(0);
  packet.add32(0);
  packet.addSequence(first);
  packet.addSequence(last);
  packet.add32(1);
  packet.end();
  return readPacket(packet).has_value();
}

std::optional<RtpsMessage> readFragment(std::uint32_t number, std::uint16_t count, std::uint16_t size,
                                        std::uint32_t whole, RtpsEntity writer = 0x103) {
  Packet packet(kSourcePrefix);
  packet.begin(Kind::kDataFrag);
  packet.add16(0);
  packet.add16(28);
  packet.addEntity(0);
  packet.addEntity(writer);
  packet.addSequence(1);
  packet.add32(number);
  packet.add16(count);
  packet.add16(size);
  packet.add32(whole);
  packet.addZeros(64);
  packet.end();
  return readPacket(packet);
}

}  // namespace

TEST(RtpsMessage, RefusesAKeyThatContradictsTheList) {
  const auto readEnd = [](const RtpsPrefix& key) {
    Packet packet(kSourcePrefix);
    packet.begin(Kind::kData, 2 | 8);
    packet.add16(0);
    packet.add16(16);
    packet.addEntity(0);
    packet.addEntity(kSpdpWriter);
    packet.addSequence(2);
    packet.addGuid(0x70, kSourcePrefix, 0x1c1);
    packet.addSentinel();
    packet.addPrefix(key);
    packet.addEntity(0x1c1);
    packet.end();
    return readPacket(packet);
  };
  ASSERT_TRUE(readEnd(kSourcePrefix));
  EXPECT_EQ(readEnd(kSourcePrefix)->discovery.at(0).prefix, kSourcePrefix);
  EXPECT_FALSE(readEnd(kOtherPrefix)) << "another one's end";
}

TEST(RtpsMessage, TellsOfWhoAnnouncesItself) {
  Packet packet(kSourcePrefix);
  beginSample(packet, kSpdpWriter);
  packet.addGuid(0x50, kSourcePrefix, 0x1c1);
  packet.addLocator(0x32, kThisMachine, 7412);
  packet.addLocator(0x31, 0x0a070701, 7413);
  packet.beginParameter(0x02);
  packet.add32(20);
  packet.add32(0);
  packet.endParameter();
  packet.addSentinel();
  packet.end();
  const auto message = readPacket(packet);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->source, kSourcePrefix);
  ASSERT_EQ(message->discovery.size(), 1U);
  const RtpsDiscovery& sample = message->discovery[0];
  EXPECT_EQ(sample.writer, kSpdpWriter);
  EXPECT_TRUE(sample.isAlive);
  EXPECT_EQ(sample.prefix, kSourcePrefix);
  EXPECT_EQ(sample.discoveryAddresses, (std::vector<RtpsAddress>{{kThisMachine, 7412}}));
  EXPECT_EQ(sample.addresses, (std::vector<RtpsAddress>{{kThisMachine, 7412}, {0x0a070701, 7413}}));
  EXPECT_EQ(sample.lease, std::chrono::seconds(20));
  ASSERT_EQ(sample.leasesAt.size(), 1U);
  EXPECT_EQ(packet.bytes()[sample.leasesAt[0]], 20);
}

TEST(RtpsMessage, TellsNamesAndUserDataOfParticipants) {
  const auto read = [](RtpsEntity writer, std::uint16_t id, std::uint32_t length, std::string_view text) {
    Packet packet(kSourcePrefix);
    beginSample(packet, writer);
    packet.beginParameter(id);
    packet.add32(length);
    for (const char each : text) packet.add8(static_cast<std::uint8_t>(each));
    packet.endParameter();
    packet.addSentinel();
    packet.end();
    return readPacket(packet).value().discovery.at(0);
  };
  constexpr std::uint16_t kUserData = 0x2c, kName = 0x62;
  EXPECT_EQ(read(kSpdpWriter, kName, 12, std::string_view("pongsim/471\0", 12)).name, "pongsim/471");
  EXPECT_EQ(read(kSpdpWriter, kUserData, 12, "enclave=/ab;").userData, "enclave=/ab;");
  EXPECT_EQ(read(kSpdpWriter, kName, 0xffffffff, "abcd").name, "abcd") << "no more than there is";
  EXPECT_EQ(read(kSpdpWriter, kName, 0, "").name, "");
  EXPECT_EQ(read(kPublicationsWriter, kUserData, 4, "abcd").userData, "") << "an endpoint's";
  EXPECT_TRUE(isOfPongsim(read(kSpdpWriter, kName, 12, "pongsim/4711")));
  EXPECT_FALSE(isOfPongsim(read(kSpdpWriter, kName, 4, "/pon")));
  EXPECT_TRUE(isOfPongsimRos(read(kSpdpWriter, kUserData, 24, "enclave=/;pongsim=ros2;\0")));
  EXPECT_FALSE(isOfPongsimRos(read(kSpdpWriter, kUserData, 12, "enclave=/ab;")));
}

TEST(RtpsMessage, IsNoneWhereTwoIdsContradictEachOther) {
  Packet packet(kSourcePrefix);
  beginSample(packet, kPublicationsWriter);
  packet.addGuid(0x5a, kSourcePrefix, 0x103);
  packet.addGuid(0x50, kOtherPrefix, 0x1c1);
  packet.addSentinel();
  packet.end();
  EXPECT_FALSE(readPacket(packet));
}

TEST(RtpsMessage, IsNoneWhereItsListOfParametersHasNoEnd) {
  Packet packet(kSourcePrefix);
  beginSample(packet, kPublicationsWriter);
  packet.addGuid(0x5a, kSourcePrefix, 0x103);
  packet.end();
  EXPECT_FALSE(readPacket(packet));
}

TEST(RtpsMessage, IsNoneWhereALengthIsWrong) {
  for (const std::uint16_t length : {std::uint16_t{1000}, std::uint16_t{65535}}) {
    Packet packet(kSourcePrefix);
    packet.begin(Kind::kInfoTs);
    packet.addZeros(8);
    packet.end(length);
    EXPECT_FALSE(readPacket(packet)) << length;
  }
  EXPECT_FALSE(readRtpsMessage(Packet(kSourcePrefix).bytes().first(19)));
  EXPECT_TRUE(readPacket(Packet(kSourcePrefix)));
}

TEST(RtpsMessage, IsNoneThatSpeaksForAnother) {
  for (const RtpsPrefix& prefix : {kSourcePrefix, kOtherPrefix}) {
    Packet packet(kSourcePrefix);
    packet.begin(Kind::kInfoSrc);
    packet.addZeros(8);
    packet.addPrefix(prefix);
    packet.end();
    EXPECT_EQ(readPacket(packet).has_value(), prefix == kSourcePrefix);
  }
}

TEST(RtpsMessage, CountsWhatIsAGapAndRefusesWhatIsNone) {
  const auto gap = readGap(5, 10, 3);
  ASSERT_TRUE(gap);
  EXPECT_EQ(gap->gapNumbers, 8U);
  EXPECT_FALSE(readGap(10, 5, 0));
  EXPECT_FALSE(readGap(0, 5, 0));
  EXPECT_FALSE(readGap(1, 5, 257));
  EXPECT_FALSE(readGap(1, std::numeric_limits<std::int64_t>::max(), 0));
}

TEST(RtpsMessage, RefusesSequenceNumbersThatEndTheLibrary) {
  for (const std::int64_t number : {std::numeric_limits<std::int64_t>::max(), std::int64_t(0), std::int64_t(-1)}) {
    Packet packet(kSourcePrefix);
    beginSample(packet, 0x103, number);
    packet.end();
    EXPECT_FALSE(readPacket(packet)) << number;
  }
  EXPECT_TRUE(takesHeartbeat(1, 0));
  EXPECT_TRUE(takesHeartbeat(7, 9));
  EXPECT_FALSE(takesHeartbeat(7, 5));
  EXPECT_FALSE(takesHeartbeat(1, std::numeric_limits<std::int64_t>::max()));
  EXPECT_FALSE(takesHeartbeat(-1, 5));
}

TEST(RtpsMessage, RefusesFragmentsThatBelongToNoSample) {
  EXPECT_TRUE(readFragment(1, 1, 64, 1000));
  EXPECT_TRUE(readFragment(16, 1, 64, 1000));
  EXPECT_FALSE(readFragment(17, 1, 64, 1000)) << "behind its end";
  EXPECT_FALSE(readFragment(0xffffffff, 0xffff, 0xffff, 1000));
  EXPECT_FALSE(readFragment(0, 1, 64, 1000));
  EXPECT_FALSE(readFragment(1, 1, 0, 1000));
  EXPECT_TRUE(readFragment(1, 1, 64, 0xffffffff)->largestFragmented == 0xffffffff);
  EXPECT_FALSE(readFragment(1, 1, 64, 1000, kPublicationsWriter)) << "discovery";
}

TEST(RtpsMessage, RefusesParticipantsOfAnotherEntity) {
  for (const bool isAlive : {true, false}) {
    for (const RtpsEntity entity : {0x1c1U, 0x1c2U}) {
      Packet packet(kSourcePrefix);
      packet.begin(Kind::kData, isAlive ? 4 : 2);
      packet.add16(0);
      packet.add16(16);
      packet.addEntity(0);
      packet.addEntity(kSpdpWriter);
      packet.addSequence(1);
      if (isAlive) packet.add32(0x00000300);
      packet.addGuid(isAlive ? 0x50 : 0x70, kSourcePrefix, entity);
      packet.addSentinel();
      packet.end();
      EXPECT_EQ(readPacket(packet).has_value(), entity == 0x1c1) << isAlive;
    }
  }
}

TEST(RtpsMessage, AnnouncesAParticipantWithoutALease) {
  constexpr std::uint64_t kSequence = (std::uint64_t(3) << 32) + 5;
  const auto bytes = announcementWithoutLease(kSourcePrefix, kSequence);
  const auto message = readRtpsMessage(bytes);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->source, kSourcePrefix);
  ASSERT_EQ(message->discovery.size(), 1U);
  const RtpsDiscovery& sample = message->discovery[0];
  EXPECT_TRUE(sample.isOfParticipant() && sample.isAlive);
  EXPECT_EQ(sample.prefix, kSourcePrefix);
  EXPECT_EQ(sample.sequence, kSequence);
  ASSERT_TRUE(sample.lease);
  EXPECT_LT(*sample.lease, std::chrono::microseconds(1));
}

TEST(RtpsMessage, AcknowledgesForAParticipant) {
  const std::vector<RtpsAcknowledgement> all = {{kPublicationsWriter, 8, 5},
                                                {kSubscriptionsWriter, std::uint64_t(1) << 40, 1}};
  const auto message = readRtpsMessage(acknowledgementBy(kSourcePrefix, all));
  ASSERT_TRUE(message);
  EXPECT_EQ(message->source, kSourcePrefix);
  EXPECT_EQ(message->acknowledgements, all);
  EXPECT_EQ(message->repeatRequests, 0U);
}

TEST(RtpsMessage, HasAcknowledgementsOfDiscoverysReadersAlone) {
  const auto read = [](RtpsEntity reader, std::uint32_t count) {
    Packet packet(kSourcePrefix);
    packet.begin(Kind::kAckNack);
    packet.addEntity(reader);
    packet.addEntity(kPublicationsWriter);
    packet.addSequenceSet(3, 1);
    packet.add32(count);
    packet.end();
    return readPacket(packet);
  };
  EXPECT_EQ(read(0x3c7, 9)->acknowledgements, (std::vector<RtpsAcknowledgement>{{kPublicationsWriter, 3, 9}}));
  EXPECT_TRUE(read(0x4c7, 9)->acknowledgements.empty()) << "of another writer's reader";
  EXPECT_TRUE(read(0x3c7, 0x7fff'ffff));
  EXPECT_FALSE(read(0x3c7, 0x8000'0000)) << "a count after which none comes";
}

TEST(RtpsMessage, IsAnAnnouncementOrMore) {
  const auto announcement = [] {
    Packet packet(kSourcePrefix);
    beginSample(packet, kSpdpWriter);
    packet.addGuid(0x50, kSourcePrefix, 0x1c1);
    packet.addSentinel();
    packet.end();
    return packet;
  };
  EXPECT_TRUE(readPacket(announcement())->isAnnouncement());
  Packet more = announcement();
  beginSample(more, 0x103);
  more.end();
  EXPECT_FALSE(readPacket(more)->isAnnouncement());
  Packet endpoint(kSourcePrefix);
  beginSample(endpoint, kPublicationsWriter);
  endpoint.addGuid(0x5a, kSourcePrefix, 0x103);
  endpoint.addSentinel();
  endpoint.end();
  EXPECT_FALSE(readPacket(endpoint)->isAnnouncement());
}

TEST(RtpsMessage, HasHeartbeatsOfDiscoveryForAllOrForOne) {
  const auto add = [](Packet& packet, RtpsEntity writer) {
    packet.begin(Kind::kHeartbeat);
    packet.addEntity(0);
    packet.addEntity(writer);
    packet.addSequence(1);
    packet.addSequence(7);
    packet.add32(1);
    packet.end();
  };
  Packet toAll(kSourcePrefix);
  add(toAll, kPublicationsWriter);
  const auto read = readPacket(toAll);
  ASSERT_TRUE(read->isHeartbeatToAll());
  EXPECT_EQ(read->heartbeats.front().writer, kPublicationsWriter);
  EXPECT_EQ(read->heartbeats.front().last, 7);
  add(toAll, 0x103);
  EXPECT_FALSE(readPacket(toAll)->isHeartbeatToAll()) << "a topic's is in it, too";
  Packet toOne(kSourcePrefix);
  toOne.begin(Kind::kInfoDst);
  toOne.addPrefix(kOtherPrefix);
  toOne.end();
  add(toOne, kPublicationsWriter);
  EXPECT_FALSE(readPacket(toOne)->isHeartbeatToAll());
}

TEST(RtpsMessage, HasParametersAtMultiplesOfFour) {
  Packet packet(kSourcePrefix);
  beginSample(packet, kSpdpWriter);
  // of 2 bytes, which look like the end of the list where the next parameter is sought too early
  packet.add16(0x8000);
  packet.add16(2);
  packet.add16(0);
  packet.add16(1);
  packet.addGuid(0x50, kOtherPrefix, 0x1c1);
  packet.addSentinel();
  packet.end();
  const auto message = readPacket(packet);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->discovery.at(0).prefix, kOtherPrefix) << "as Fast DDS reads it";
}

TEST(RtpsMessage, SaysThatAParticipantHasGoneWhateverItHasBesides) {
  Packet packet(kSourcePrefix);
  packet.beginData(0, kSpdpWriter, 1, hostile::kWithData | hostile::kInlineQos);
  packet.addNumberParameter(0x71, 0x01000000);
  packet.addSentinel();
  packet.add32(0x00000300);
  packet.addGuid(0x50, kSourcePrefix, 0x1c1);
  packet.addSentinel();
  packet.end();
  const auto message = readPacket(packet);
  ASSERT_TRUE(message);
  EXPECT_TRUE(message->discovery.at(0).isGone);
  EXPECT_FALSE(message->discovery.at(0).isAlive);
}

TEST(RtpsMessage, SaysGoodbyeForAParticipant) {
  const auto bytes = goodbyeBy(kSourcePrefix, 0);
  const auto message = readRtpsMessage(bytes);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->source, kSourcePrefix);
  const RtpsDiscovery& sample = message->discovery.at(0);
  EXPECT_EQ(sample.prefix, kSourcePrefix);
  EXPECT_TRUE(sample.isOfParticipant() && sample.isGone);
  const auto newer = goodbyeBy(kSourcePrefix, 1);
  EXPECT_FALSE(readRtpsMessage(newer)) << "newer than what others may say";
}

TEST(RtpsMessage, IsReadAsFarAsItCanBeWhereItIsNotProper) {
  Packet packet(kSourcePrefix);
  packet.begin(Kind::kInfoSrc);
  packet.addZeros(8);
  packet.addPrefix(kOtherPrefix);
  packet.end();
  beginSample(packet, kPublicationsWriter);
  packet.addGuid(0x5a, kOtherPrefix, 0x103);
  packet.addSentinel();
  packet.end();
  packet.begin(Kind::kInfoTs);
  packet.addZeros(8);
  packet.end(1000);
  const auto message = readAnyRtpsMessage(packet.bytes());
  ASSERT_TRUE(message);
  EXPECT_FALSE(message->isProper);
  EXPECT_EQ(message->otherSources, std::vector{kOtherPrefix});
  EXPECT_EQ(message->discovery.at(0).sender, kOtherPrefix);
  EXPECT_FALSE(message->hasUnreadParticipant);
  EXPECT_FALSE(readAnyRtpsMessage(packet.bytes().first(19)));
}

}  // namespace pongsim::shared
