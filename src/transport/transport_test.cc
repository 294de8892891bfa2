// Who finds whom: in processes, domains and partitions, and on other machines.

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "pongsim/node.hh"
#include "support/proc.hh"
#include "support/process.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"
#include "support/transport/transport_peers.hh"
#include "support/wait_until.hh"

namespace pongsim {

namespace {

using ignition::msgs::StringMsg;
using test::kDeadline;
using test::Process;

class TransportTest : public test::TransportPeersTest {};

}  // namespace

TEST_F(TransportTest, FindsEveryTopicOfEveryProcess) {
  constexpr int kProcesses = 4;
  constexpr int kTopics = 200;
  std::vector<std::unique_ptr<Process>> others;
  for (int i = 0; i < kProcesses; ++i) others.push_back(peer({"offer", std::to_string(kTopics), "0"}));
  for (const auto& other : others) ASSERT_TRUE(other->waitForOutput("ready"));

  Transport newcomer;
  const std::vector<TopicInfo> topics = newcomer.discover(kDeadline);
  EXPECT_EQ(topics.size(), kProcesses * kTopics);
  EXPECT_TRUE(std::ranges::is_sorted(topics, {}, &TopicInfo::name));
  for (const TopicInfo& topic : topics) {
    ASSERT_EQ(topic.publishers.size(), 1) << topic.name;
    EXPECT_EQ(topic.publishers[0].type, "ignition.msgs.StringMsg");
    EXPECT_EQ(topic.name.substr(1, topic.name.rfind('/') - 1), std::to_string(topic.publishers[0].pid));
  }

  const auto finder = peer({"discover"});
  EXPECT_EQ(finder->wait(), 0);
  EXPECT_EQ(finder->output(), "found 800\n");
}

TEST_F(TransportTest, KnowsWhetherAllHaveAnswered) {
  const auto other = peer({"offer", "3", "0"});
  ASSERT_TRUE(other->waitForOutput("ready"));
  other->kill(SIGSTOP);
  Transport newcomer;
  newcomer.discover(kDeadline);
  EXPECT_FALSE(newcomer.heardAll());
  other->kill(SIGCONT);
  EXPECT_TRUE(test::waitUntil([&] { return newcomer.discover(kDeadline).size() == 3; }));
  EXPECT_TRUE(newcomer.heardAll());
}

TEST_F(TransportTest, FindsEveryServiceOfEveryProcess) {
  constexpr int kProcesses = 4;
  constexpr int kServices = 50;
  std::vector<std::unique_ptr<Process>> others;
  for (int i = 0; i < kProcesses; ++i) others.push_back(peer({"offer", "1", std::to_string(kServices)}));
  for (const auto& other : others) ASSERT_TRUE(other->waitForOutput("ready"));
  Transport newcomer;
  EXPECT_EQ(newcomer.discoverServices(kDeadline).size(), kProcesses * kServices);
  EXPECT_EQ(newcomer.discover(kDeadline).size(), kProcesses);
}

TEST_F(TransportTest, DoesNotListWhatHasEnded) {
  auto other = peer({"offer", "3", "0"});
  ASSERT_TRUE(other->waitForOutput("ready"));
  EXPECT_EQ(transport_.discover(kDeadline).size(), 3);
  other->kill(SIGTERM);
  EXPECT_EQ(other->wait(), 0) << other->error();
  Transport newcomer;
  EXPECT_TRUE(newcomer.discover(kDeadline).empty());
}

TEST_F(TransportTest, WaitsForATopicThatIsNotThereYet) {
  EXPECT_TRUE(transport_.waitForTopic("/chatter", true, std::chrono::nanoseconds(0)).publishers.empty());
  const auto other = peer({"say", "/chatter", "1", "0"});
  const TopicInfo topic = transport_.waitForTopic("chatter", true, kDeadline);
  EXPECT_EQ(topic.name, "/chatter");
  ASSERT_EQ(topic.publishers.size(), 1);
  EXPECT_EQ(topic.publishers[0].pid, other->pid());
}

TEST_F(TransportTest, KeepsPartitionsApart) {
  Process::Options elsewhere;
  elsewhere.environment["IGN_PARTITION"] = "elsewhere";
  const auto other = peer({"offer", "3", "0"}, elsewhere);
  ASSERT_TRUE(other->waitForOutput("ready"));
  EXPECT_TRUE(transport_.discover(kDeadline).empty());
  // by Gazebo's later name too
  for (const char* name : {"IGN_PARTITION", "GZ_PARTITION"}) {
    const auto finder = peer({"discover"}, {.environment = {{name, "elsewhere"}}, .folder = {}});
    EXPECT_EQ(finder->wait(), 0);
    EXPECT_EQ(finder->output(), "found 3\n") << name;
  }
}

TEST_F(TransportTest, OpensSocketsOnLoopbackOnly) {
  const Publisher publisher = node_.advertise<StringMsg>("/chatter");
  const Subscription subscription = node_.subscribe<StringMsg>("/other", [](const StringMsg&) {});
  const std::set<std::string> sockets = test::socketsOf(getpid(), "udp");
  EXPECT_GE(sockets.size(), 2);
  for (const std::string& socket : sockets) EXPECT_TRUE(socket.starts_with("0100007F:")) << socket;
  for (const char* table : {"udp6", "tcp", "tcp6"}) EXPECT_TRUE(test::socketsOf(getpid(), table).empty()) << table;
}

TEST_F(TransportTest, UsesNoSharedMemoryOfFastDds) {
  const auto other = listener();
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  ASSERT_TRUE(publisher.waitForSubscribers(kDeadline));
  for (const pid_t process : {getpid(), other->pid()}) {
    for (const std::string& name : test::sharedMemoryOf(process))
      EXPECT_EQ(name.find("fast"), std::string::npos) << name;
  }
}

TEST_F(TransportTest, WorksWhereThereIsNothingButLoopback) {
  if (Process({"unshare", "-rn", "true"}).wait() != 0) GTEST_SKIP() << "no network namespace can be made here";
  Process alone({"unshare", "-rn", "sh", "-c",
                 "ip link set lo up && (" TRANSPORT_PEER " listen /chatter & listener=$!; " TRANSPORT_PEER
                 " say /chatter 5 0; result=$?; kill $listener; wait $listener; exit $result)"});
  EXPECT_EQ(alone.wait(), 0) << alone.error();
  EXPECT_NE(alone.output().find("got 4"), std::string::npos);
}

namespace {

/// Two network namespaces with a wire between them stand for two machines. PEER is another machine's program. Both wait
/// for the wire, because Fast DDS leaves out interfaces that have no carrier when it starts.
constexpr const char* kTwoMachines = R"sh(
  ip link set lo up
  ip link add here type veth peer name there
  unshare -n sh -c 'while ! ip link set there up 2>/dev/null; do sleep 0.01; done
    ip link set lo up; ip addr add 10.7.7.2/24 dev there
    until ip link show there | grep -q "state UP"; do sleep 0.01; done; exec '"$PEER" &
  other=$!
  until [ "$(readlink /proc/$other/ns/net)" != "$(readlink /proc/self/ns/net)" ]; do sleep 0.01; done
  ip link set there netns $other && ip addr add 10.7.7.1/24 dev here && ip link set here up
  until ip link show here | grep -q "state UP"; do sleep 0.01; done
)sh";

bool twoMachinesCanBeMade() {
  return Process({"unshare", "-rn", "sh", "-c", "ip link add here type veth peer name there && unshare -n true"})
             .wait() == 0;
}

}  // namespace

TEST_F(TransportTest, TalksToAnotherMachineByTheInterfaceThatItIsGiven) {
  if (!twoMachinesCanBeMade()) GTEST_SKIP() << "no network namespaces with a wire between them can be made here";
  Process machines({"unshare", "-rn", "sh", "-c",
                    "PEER='" TRANSPORT_PEER " listen /chatter'\nPONGSIM_NETWORK=there\nexport PONGSIM_NETWORK\n" +
                        std::string(kTwoMachines) +
                        "PONGSIM_NETWORK=10.7.7.1 " TRANSPORT_PEER " say /chatter 5 100000\nresult=$?\n"
                        "kill $other; wait $other; exit $result"});
  EXPECT_EQ(machines.wait(), 0) << machines.error();
  EXPECT_EQ(
      machines.output(), "ready\n" + [] {
        std::string all;
        for (int i = 0; i < 5; ++i) all += "got 100000 bytes\n";
        return all;
      }());
}

TEST_F(TransportTest, IsFoundOnItsOwnMachineByThoseThatAreClosedWhenItIsOpen) {
  if (!twoMachinesCanBeMade()) GTEST_SKIP() << "no network namespaces with a wire between them can be made here";
  // the first port of the domain is taken on loopback by a closed one, so that the open one has another
  Process machines({"unshare", "-rn", "sh", "-c",
                    "PEER='sleep 1000'\n" + std::string(kTwoMachines) +
                        TRANSPORT_PEER
                        " offer 1 0 & closed=$!\n"
                        "PONGSIM_NETWORK=here " TRANSPORT_PEER " listen /chatter & open=$!\n" TRANSPORT_PEER
                        " say /chatter 5 0; result=$?\n"
                        "kill $open; wait $open; kill $closed; wait $closed; kill $other; exit $result"});
  EXPECT_EQ(machines.wait(), 0) << machines.error();
  EXPECT_NE(machines.output().find("got 4\n"), std::string::npos) << machines.output();
}

TEST_F(TransportTest, DoesNotTalkToAnotherMachineUnlessItIsToldTo) {
  if (!twoMachinesCanBeMade()) GTEST_SKIP() << "no network namespaces with a wire between them can be made here";
  const test::TempFolder folder;
  const std::string said = (folder.path() / "said").string();
  Process machines({"unshare", "-rn", "sh", "-c",
                    "PEER='env PONGSIM_NETWORK=there " TRANSPORT_PEER " offer 3 0 >" + said + "'\n" +
                        std::string(kTwoMachines) + "until grep -qs ready " + said + "; do sleep 0.01; done\n" +
                        TRANSPORT_PEER " discover; result=$?\nkill $other; wait $other; exit $result"});
  EXPECT_EQ(machines.wait(), 0) << machines.error();
  EXPECT_EQ(machines.output(), "found 0\n");
}

TEST_F(TransportTest, RefusesADomainThatIsNone) {
  EXPECT_THROW(Transport({.network = true, .domain = 233}), std::invalid_argument);
}

TEST_F(TransportTest, HearsNothingOfAnotherDomain) {
  // beyond those that tests are given
  Process::Options elsewhere;
  elsewhere.environment["PONGSIM_DOMAIN"] = std::to_string(domain_ + 100);
  const auto other = peer({"offer", "3", "0"}, elsewhere);
  ASSERT_TRUE(other->waitForOutput("ready"));
  EXPECT_TRUE(transport_.discover(kDeadline).empty());
}

}  // namespace pongsim
