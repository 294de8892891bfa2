#include "transport/network/directory.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>

#include "transport/names/service_name.hh"

namespace pongsim::transport {

namespace {

constexpr ParticipantId kFirst{1};
constexpr ParticipantId kSecond{2};
constexpr EndpointId kFirstsPublisher{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
constexpr EndpointId kFirstsSubscriber{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2};
constexpr EndpointId kSecondsPublisher{2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
const std::string kTwist = "ignition.msgs.Twist";

const TimePoint kNow{};

std::vector<std::uint32_t> ports(std::initializer_list<std::uint32_t> list) { return list; }

}  // namespace

TEST(Directory, ListsTopicsByNameWithTheProcessOfEachEndpoint) {
  Directory directory;
  directory.addParticipant(kFirst, 11, {7410});
  directory.addParticipant(kSecond, 22, {7412});
  directory.addEndpoint(kFirstsPublisher, {"/b", kTwist, Role::kPublisher});
  directory.addEndpoint(kFirstsSubscriber, {"/a", kTwist, Role::kSubscriber});
  directory.addEndpoint(kSecondsPublisher, {"/a", kTwist, Role::kPublisher});

  const std::vector<TopicInfo> topics = directory.topics();
  ASSERT_EQ(topics.size(), 2);
  EXPECT_EQ(topics[0].name, "/a");
  EXPECT_EQ(topics[0].publishers, (std::vector<TopicInfo::Endpoint>{{kTwist, 22}}));
  EXPECT_EQ(topics[0].subscribers, (std::vector<TopicInfo::Endpoint>{{kTwist, 11}}));
  EXPECT_EQ(topics[1].name, "/b");
  EXPECT_TRUE(directory.topic("/c").publishers.empty());
}

TEST(Directory, ForgetsAParticipantWithAllItsEndpoints) {
  Directory directory;
  directory.addParticipant(kFirst, 11, {7410});
  directory.addParticipant(kSecond, 22, {7412});
  directory.addEndpoint(kFirstsPublisher, {"/a", kTwist, Role::kPublisher});
  directory.addEndpoint(kFirstsSubscriber, {"/b", kTwist, Role::kSubscriber});
  directory.addEndpoint(kSecondsPublisher, {"/c", kTwist, Role::kPublisher});
  directory.removeParticipant(kFirst);
  ASSERT_EQ(directory.topics().size(), 1);
  EXPECT_EQ(directory.topics()[0].name, "/c");
  EXPECT_EQ(directory.pidOf(kFirst), 0);
}

TEST(Directory, ListsNoOtherProgramsAndNoHiddenTopics) {
  Directory directory;
  directory.addParticipant(kFirst, 0, {7410});
  directory.addParticipant(kSecond, 22, {7412});
  directory.addEndpoint(kFirstsPublisher, {"/ros", kTwist, Role::kPublisher});
  directory.addEndpoint(kSecondsPublisher, {"/other_partition", kTwist, Role::kPublisher, false});
  EXPECT_TRUE(directory.topics().empty());
  EXPECT_FALSE(directory.waitForTopic("/ros", Role::kPublisher, kNow));
}

TEST(Directory, IsCompleteWhenEveryPortHasAnsweredAndToldAll) {
  Directory directory;
  EXPECT_TRUE(directory.waitForAll({}, kNow));
  EXPECT_FALSE(directory.waitForAll(ports({7410}), kNow));
  directory.addParticipant(kFirst, 11, {7410});
  EXPECT_FALSE(directory.waitForAll(ports({7410}), kNow)) << "it has not said how many endpoints it has";
  directory.setCensus(kFirst, 2);
  EXPECT_FALSE(directory.waitForAll(ports({7410}), kNow));
  directory.addEndpoint(kFirstsPublisher, {"/a", kTwist, Role::kPublisher});
  EXPECT_FALSE(directory.waitForAll(ports({7410}), kNow));
  directory.addEndpoint(kFirstsSubscriber, {"/a", kTwist, Role::kSubscriber, false});
  EXPECT_TRUE(directory.waitForAll(ports({7410}), kNow));
  EXPECT_FALSE(directory.waitForAll(ports({7410, 7412}), kNow));
  directory.addParticipant(kSecond, 0, {7412});
  EXPECT_TRUE(directory.waitForAll(ports({7410, 7412}), kNow)) << "what is no pongsim takes no census";
}

TEST(Directory, TellsTheTrafficBetweenTwoReports) {
  Directory directory;
  directory.addParticipant(kFirst, 11, {7410});
  directory.addEndpoint(kFirstsPublisher, {"/a", kTwist, Role::kPublisher});
  const auto report = [](std::chrono::milliseconds at, std::uint64_t messages) {
    return TrafficReport{at, {{"/a", kTwist, Role::kSubscriber, 7, 0}, {"/a", kTwist, Role::kPublisher, messages, 5}}};
  };
  const auto traffic = [&] { return directory.topic("/a").publishers.at(0).traffic; };
  EXPECT_FALSE(traffic());
  directory.setTraffic(kFirst, report(std::chrono::milliseconds(1000), 100));
  EXPECT_FALSE(traffic()) << "a rate takes two";
  directory.setTraffic(kFirst, report(std::chrono::milliseconds(1500), 150));
  directory.setTraffic(kFirst, report(std::chrono::milliseconds(3000), 300));
  EXPECT_EQ(traffic(), (TopicInfo::Traffic{300, 5, 100}));

  directory.forgetTraffic();
  EXPECT_FALSE(traffic());
  directory.setTraffic(kFirst, report(std::chrono::milliseconds(1000), 400));
  directory.setTraffic(kFirst, report(std::chrono::milliseconds(2000), 300));
  EXPECT_EQ(traffic(), (TopicInfo::Traffic{300, 5, 0})) << "what can't be is no rate";
  directory.forgetTraffic();
  directory.setTraffic(kFirst, {std::chrono::nanoseconds::min(), {}});
  directory.setTraffic(kFirst, {std::chrono::nanoseconds::max(), {}});
  EXPECT_FALSE(traffic());
  // of nobody who is known
  directory.setTraffic(kSecond, report(std::chrono::milliseconds(1000), 1));
}

TEST(Directory, WarnsOnceOfAnotherTypeWithTopicTypesAndProcess) {
  Directory directory;
  directory.addParticipant(kFirst, 4711, {7410});
  directory.addOwn({"/a", kTwist, Role::kSubscriber});
  testing::internal::CaptureStderr();
  directory.addEndpoint(kFirstsPublisher, {"/a", "ignition.msgs.Pose", Role::kPublisher});
  directory.removeEndpoint(kFirstsPublisher);
  directory.addEndpoint(kFirstsPublisher, {"/a", "ignition.msgs.Pose", Role::kPublisher});
  directory.addEndpoint(kFirstsSubscriber, {"/a", "ignition.msgs.Image", Role::kSubscriber});
  const std::string said = testing::internal::GetCapturedStderr();
  for (const char* part : {"/a", "ignition.msgs.Pose", "ignition.msgs.Twist", "4711"}) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
  }
  EXPECT_EQ(said.find("process"), said.find("process 4711"));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

TEST(Directory, WarnsOfAnotherTypeThatWasThereBefore) {
  Directory directory;
  directory.addParticipant(kFirst, 4711, {7410});
  directory.addEndpoint(kFirstsSubscriber, {"/a", "ignition.msgs.Pose", Role::kSubscriber});
  testing::internal::CaptureStderr();
  directory.addOwn({"/a", kTwist, Role::kPublisher});
  EXPECT_NE(testing::internal::GetCapturedStderr().find("ignition.msgs.Pose"), std::string::npos);
}

TEST(Directory, WarnsOfNoTypeWhereOneSideTakesAny) {
  Directory directory;
  directory.addParticipant(kFirst, 4711, {7410});
  testing::internal::CaptureStderr();
  // this process takes any type, and has met one
  directory.addOwn({"/a", "*", Role::kSubscriber});
  directory.addOwn({"/a", kTwist, Role::kSubscriber});
  directory.addEndpoint(kFirstsPublisher, {"/a", "ignition.msgs.Pose", Role::kPublisher});
  // the other one does
  directory.addOwn({"/b", kTwist, Role::kPublisher});
  directory.addEndpoint(kFirstsSubscriber, {"/b", "*", Role::kSubscriber});
  directory.addEndpoint(EndpointId{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3}, {"/b", "a.Type", Role::kSubscriber});
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Directory, WarnsOnceOfAWorldOfTheSameNameInAnotherProcess) {
  const Endpoint control{requestTopic("/world/w/control"), serviceType("a", "b"), Role::kSubscriber};
  for (const bool isFirst : {true, false}) {
    Directory directory;
    directory.addParticipant(kFirst, 4711, {7410});
    testing::internal::CaptureStderr();
    if (isFirst) directory.addOwn(control);
    directory.addEndpoint(kFirstsSubscriber, control);
    directory.addEndpoint(kFirstsSubscriber, control);
    if (!isFirst) directory.addOwn(control);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("process 4711 runs a world 'w', too"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
}

TEST(Directory, WarnsOfNoOtherWorldOrServiceOrCaller) {
  Directory directory;
  directory.addParticipant(kFirst, 4711, {7410});
  testing::internal::CaptureStderr();
  for (const char* service : {"/world/w/control", "/gazebo/worlds", "/world/w/playback/control"})
    directory.addOwn({requestTopic(service), serviceType("a", "b"), Role::kSubscriber});
  std::uint8_t number = 10;
  const auto add = [&](const char* service, Role role, bool isVisible) {
    directory.addEndpoint(EndpointId{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, ++number},
                          {requestTopic(service), serviceType("c", "d"), role, isVisible});
  };
  add("/world/v/control", Role::kSubscriber, true);
  add("/gazebo/worlds", Role::kSubscriber, true);
  add("/world/w/playback/control", Role::kSubscriber, true);
  // in another partition
  add("/world/w/control", Role::kSubscriber, false);
  // calls it
  add("/world/w/control", Role::kPublisher, true);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Directory, ListsWhoTakesAnyTypeByTheTypesThatItHasMet) {
  Directory directory;
  directory.addParticipant(kFirst, 11, {7410});
  directory.addEndpoint(kFirstsSubscriber, {"/a", "*", Role::kSubscriber});
  EXPECT_EQ(directory.topic("/a").subscribers, (std::vector<TopicInfo::Endpoint>{{"*", 11}}));
  directory.addEndpoint(EndpointId{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3}, {"/a", kTwist, Role::kSubscriber});
  EXPECT_EQ(directory.topic("/a").subscribers, (std::vector<TopicInfo::Endpoint>{{kTwist, 11}}));
  EXPECT_EQ(directory.topics().at(0).subscribers.size(), 1U);
}

TEST(Directory, TellsOfPublishersOfTopicsAsTheyCome) {
  Directory directory;
  std::vector<std::string> told;
  directory.tellOfPublishers([&](const std::string& topic, const std::string& type) { told.push_back(topic + type); });
  directory.addParticipant(kFirst, 11, {7410});
  directory.addEndpoint(kFirstsPublisher, {"/a", "X", Role::kPublisher});
  directory.addEndpoint(kFirstsSubscriber, {"/a", "Y", Role::kSubscriber});
  directory.addEndpoint(kSecondsPublisher, {"/hidden", "Z", Role::kPublisher, false});
  EXPECT_EQ(told, std::vector<std::string>{"/aX"});
  directory.tellOfPublishers({});
  directory.addEndpoint(kFirstsPublisher, {"/b", "X", Role::kPublisher});
  EXPECT_EQ(told.size(), 1U);
}

TEST(Directory, CountsWhatSeveralParticipantsOfANetworkTell) {
  Directory directory;
  directory.addParticipant(kSecond, 11, {7412}, kFirst);
  directory.addEndpoint(kSecondsPublisher, {"/a", kTwist, Role::kPublisher});
  EXPECT_FALSE(directory.waitForAll(ports({7412}), kNow)) << "the first one is not there";
  directory.addParticipant(kFirst, 11, {7410});
  directory.setCensus(kFirst, 2);
  EXPECT_FALSE(directory.waitForAll(ports({7410, 7412}), kNow)) << "one is missing";
  directory.addEndpoint(kFirstsPublisher, {"/b", kTwist, Role::kPublisher});
  EXPECT_TRUE(directory.waitForAll(ports({7410, 7412}), kNow));
}

TEST(Directory, TakesTheFirstParticipantsReportForTheWholeNetwork) {
  Directory directory;
  directory.addParticipant(kFirst, 11, {7410});
  directory.addParticipant(kSecond, 11, {7412}, kFirst);
  directory.addEndpoint(kSecondsPublisher, {"/a", kTwist, Role::kPublisher});
  for (const int seconds : {1, 2}) {
    const auto sent = static_cast<std::uint64_t>(seconds) * 10;
    directory.setTraffic(kFirst, {std::chrono::seconds(seconds), {{"/a", kTwist, Role::kPublisher, sent, 0}}});
  }
  EXPECT_EQ(directory.topic("/a").publishers.at(0).traffic, (TopicInfo::Traffic{20, 0, 10}));
}

TEST(Directory, ListsWhoTakesAnyTypeOnceWhereItsEndpointsAreOfSeveralParticipants) {
  Directory directory;
  directory.addParticipant(kFirst, 11, {7410});
  directory.addParticipant(kSecond, 11, {7412}, kFirst);
  directory.addEndpoint(kFirstsSubscriber, {"/a", "*", Role::kSubscriber});
  directory.addEndpoint(EndpointId{2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3}, {"/a", kTwist, Role::kSubscriber});
  EXPECT_EQ(directory.topic("/a").subscribers, (std::vector<TopicInfo::Endpoint>{{kTwist, 11}}));
}

}  // namespace pongsim::transport
