#include "ros2/wire/announcements.hh"

#include <gtest/gtest.h>

#include <limits>

#include "support/ros2/announced.hh"

namespace pongsim::ros2 {
namespace {

using std::chrono::nanoseconds;
using std::chrono::seconds;

constexpr GuidPrefix kSpeaker = {1, 16, 7}, kCompanion = {1, 16, 8};
constexpr nanoseconds kDecades = std::chrono::hours(24 * 365 * 30);

std::optional<Presence> presenceIn(const hostile::Packet& packet) {
  std::vector<unsigned char> bytes = bytesOf(packet);
  return readPresence(bytes);
}

bool isAnnouncementRefused(const Announced& announced) {
  std::vector<unsigned char> bytes = announcementOf(announced);
  return !readPresence(bytes);
}

TEST(Announcements, TellOfALeaseWhichBecomesEndless) {
  std::vector<unsigned char> bytes = announcementOf({.participant = kSpeaker, .lease = 5});
  const auto presence = readPresence(bytes);
  ASSERT_TRUE(presence);
  EXPECT_EQ(presence->senders, std::vector{kSpeaker});
  ASSERT_EQ(presence->announcements.size(), 1);
  EXPECT_EQ(presence->announcements[0].participant, kSpeaker);
  EXPECT_EQ(presence->announcements[0].lease, seconds(5));
  const auto again = readPresence(bytes);
  ASSERT_TRUE(again);
  EXPECT_GT(again->announcements.at(0).lease, kDecades);
}

TEST(Announcements, HaveEitherByteOrder) {
  constexpr unsigned char kBigDataFlags = 4;
  std::vector<unsigned char> bytes{'R', 'T', 'P', 'S', 2, 3, 1, 16};
  const auto add = [&](std::initializer_list<unsigned char> more) { bytes.insert(bytes.end(), more); };
  bytes.insert(bytes.end(), kSpeaker.begin(), kSpeaker.end());
  add({0x15, kBigDataFlags, 0, 0, 0, 0, 0, 16, 0, 1, 0, 0xc7, 0, 1, 0, 0xc2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, 0});
  add({0, 0x50, 0, 16});
  bytes.insert(bytes.end(), kSpeaker.begin(), kSpeaker.end());
  add({0, 0, 1, 0xc1, 0, 0x58, 0, 4, 0, 0, 0, 0x3f, 0, 2, 0, 8, 0, 0, 0, 7, 0x80, 0, 0, 0, 0, 1, 0, 0});
  const auto presence = readPresence(bytes);
  ASSERT_TRUE(presence);
  EXPECT_EQ(presence->announcements.at(0).lease, std::chrono::milliseconds(7500));
  EXPECT_GT(readPresence(bytes)->announcements.at(0).lease, kDecades);
}

TEST(Announcements, OfSeveralParticipantsMayBeInOneMessage) {
  // as those of one process by Cyclone DDS are
  hostile::Packet packet(kSpeaker);
  addAnnouncement(packet, {.participant = kSpeaker, .lease = 10});
  addSource(packet, kCompanion);
  addAnnouncement(packet, {.participant = kCompanion, .lease = 11});
  std::vector<unsigned char> bytes = bytesOf(packet);
  const auto presence = readPresence(bytes);
  ASSERT_TRUE(presence);
  EXPECT_EQ(presence->senders, (std::vector{kSpeaker, kCompanion}));
  ASSERT_EQ(presence->announcements.size(), 2);
  EXPECT_EQ(presence->announcements[0].participant, kSpeaker);
  EXPECT_EQ(presence->announcements[0].lease, seconds(10));
  EXPECT_EQ(presence->announcements[1].participant, kCompanion);
  EXPECT_EQ(presence->announcements[1].lease, seconds(11));
  const auto readAgain = readPresence(bytes);
  ASSERT_TRUE(readAgain);
  for (const Announcement& each : readAgain->announcements) EXPECT_GT(each.lease, kDecades);
}

TEST(Announcements, MayBeSentByAnotherParticipantOfTheProcess) {
  hostile::Packet packet(kSpeaker);
  addAnnouncement(packet, {.participant = kCompanion});
  const auto presence = presenceIn(packet);
  ASSERT_TRUE(presence);
  EXPECT_EQ(presence->announcements.at(0).participant, kCompanion);
}

TEST(Announcements, AreGoodbyesInEitherForm) {
  for (const Goodbye form : {Goodbye::kWithHash, Goodbye::kWithKey}) {
    hostile::Packet packet(kSpeaker);
    addGoodbye(packet, kCompanion, form);
    const auto presence = presenceIn(packet);
    ASSERT_TRUE(presence);
    ASSERT_EQ(presence->announcements.size(), 1);
    EXPECT_EQ(presence->announcements[0].participant, kCompanion);
    EXPECT_FALSE(presence->announcements[0].lease);
  }
}

TEST(Announcements, HaveNoLeaseThatFastDdsReadsAndWeDont) {
  hostile::Packet twice(kSpeaker);
  beginAnnouncement(twice, 4, 1);
  twice.add32(0x00000300);
  twice.addGuid(kGuidId, kSpeaker, hostile::entity::kParticipant);
  twice.addNumberParameter(kEndpointsId, 0x3f);
  addLease(twice, 1);
  addLease(twice, 2);
  twice.addSentinel();
  twice.end();
  std::vector<unsigned char> bytes = bytesOf(twice);
  EXPECT_EQ(readPresence(bytes)->announcements.at(0).lease, seconds(2)) << "Fast DDS takes the last one";
  std::size_t endless = 0;
  for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4) {
    if (std::equal(bytes.begin() + i, bytes.begin() + i + 4, std::begin({0, 0, 0, 0x40}))) ++endless;
  }
  EXPECT_EQ(endless, 2);

  hostile::Packet fragment(kSpeaker);
  fragment.begin(hostile::Kind::kDataFrag);
  fragment.add16(0);
  fragment.add16(28);
  fragment.addEntity(0);
  fragment.addEntity(hostile::entity::kSpdpWriter);
  fragment.addSequence(1);
  fragment.addZeros(80);
  fragment.end();
  EXPECT_FALSE(presenceIn(fragment));

  hostile::Packet endlessList(kSpeaker);
  beginAnnouncement(endlessList, 4, 1);
  endlessList.add32(0x00000300);
  endlessList.addGuid(kGuidId, kSpeaker, hostile::entity::kParticipant);
  endlessList.addNumberParameter(kEndpointsId, 0x3f);
  addLease(endlessList, 1);
  endlessList.end();
  addAnnouncement(endlessList, {.participant = kSpeaker});
  EXPECT_FALSE(presenceIn(endlessList)) << "the list would go on in the next submessage";
}

TEST(Announcements, AreRefusedWhereAGoodbyeWouldNotDo) {
  EXPECT_FALSE(isAnnouncementRefused({.participant = kSpeaker}));
  EXPECT_TRUE(isAnnouncementRefused({.participant = kSpeaker, .lease = std::nullopt}));
  EXPECT_TRUE(isAnnouncementRefused({.participant = kSpeaker, .endpoints = std::nullopt}));
  EXPECT_TRUE(isAnnouncementRefused({.participant = kSpeaker, .endpoints = 0x3e}));
  EXPECT_TRUE(isAnnouncementRefused({.participant = kSpeaker, .entity = 0x000002c1}));
  EXPECT_TRUE(isAnnouncementRefused({.participant = kSpeaker, .sequence = 0}));
  EXPECT_FALSE(isAnnouncementRefused({.participant = kSpeaker, .sequence = std::int64_t(1) << 48}));
  EXPECT_TRUE(isAnnouncementRefused({.participant = kSpeaker, .sequence = (std::int64_t(1) << 48) + 1}));
  EXPECT_TRUE(isAnnouncementRefused({.participant = kSpeaker, .sequence = std::numeric_limits<std::int64_t>::max()}));
}

TEST(Announcements, AreNotWhatElseIsInMessages) {
  // a fragment of 100 MB
  hostile::Packet fragment(kSpeaker);
  fragment.begin(hostile::Kind::kDataFrag);
  fragment.add16(0);
  fragment.add16(28);
  fragment.addEntity(0);
  fragment.addEntity(0x00001203);
  fragment.addSequence(1);
  fragment.add32(1'500);
  fragment.add16(1);
  fragment.add16(64'000);
  fragment.add32(100'000'000);
  fragment.addZeros(64);
  fragment.end();
  std::vector<unsigned char> bytes = bytesOf(fragment);
  const std::vector<unsigned char> before = bytes;
  const auto presence = readPresence(bytes);
  ASSERT_TRUE(presence);
  EXPECT_EQ(presence->senders, std::vector{kSpeaker});
  EXPECT_TRUE(presence->announcements.empty());
  EXPECT_EQ(bytes, before);

  std::vector<unsigned char> rubbish{1, 2, 3};
  EXPECT_TRUE(readPresence(rubbish)) << "which Fast DDS drops";
}

TEST(Announcements, CanBeGoodbyesInAnothersName) {
  std::vector<unsigned char> bytes = goodbye(kSpeaker, 0);
  const auto presence = readPresence(bytes);
  ASSERT_TRUE(presence);
  EXPECT_EQ(presence->senders, std::vector{kSpeaker});
  EXPECT_EQ(presence->announcements.at(0).participant, kSpeaker);
  EXPECT_FALSE(presence->announcements.at(0).lease);
  std::vector<unsigned char> newer = goodbye(kSpeaker, 1);
  EXPECT_FALSE(readPresence(newer)) << "newer than what others may say";
}

}  // namespace
}  // namespace pongsim::ros2
