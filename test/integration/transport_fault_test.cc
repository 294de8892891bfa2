// Failing or killed peers do not slow a world down, fill its memory or leave anything behind.

#include <gtest/gtest.h>
#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "pongsim/node.hh"
#include "support/proc.hh"
#include "support/pseudo_terminal.hh"
#include "support/regex.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::test {
namespace {

// Far more than is kept for a stopped subscriber, far less than a leak would add.
#ifdef __SANITIZE_ADDRESS__
// the sanitizer keeps this much of the freed memory
constexpr std::uint64_t kSomeMemory = (200 + 256) << 20;
#else
constexpr std::uint64_t kSomeMemory = 200 << 20;
#endif

/// The pong world, which publishes its clock in each step, and a reliable subscriber.
class TransportFault : public testing::Test {
 protected:
  /// @return Whether this many more steps are made, and each arrives or is counted as dropped.
  bool goesOn(std::uint64_t steps) {
    const std::uint64_t until = heard_ + steps;
    const auto deadline = std::chrono::steady_clock::now() + kDeadline;
    // dropped messages are counted before they are missed
    while ((heard_ < until || missed_ != clock_.dropped()) && std::chrono::steady_clock::now() < deadline) {
      transport_.dispatchFor(std::chrono::milliseconds(20));
    }
    EXPECT_EQ(missed_, clock_.dropped());
    return heard_ >= until;
  }

  std::unique_ptr<Process> echo(const std::string& topic) {
    auto process = start({"topic", "-e", "-t", topic});
    EXPECT_TRUE(process->waitForOutput("sim")) << process->error();
    return process;
  }

  void hear(const ignition::msgs::Clock& message) {
    constexpr std::int64_t kMs = 1'000'000;
    const std::int64_t step = message.sim().sec() * 1000 + message.sim().nsec() / kMs;
    if (heard_ > 0) missed_ += static_cast<std::uint64_t>(step - last_ - 1);
    last_ = step;
    ++heard_;
  }

  std::unique_ptr<Process> world_ = startServedWorld("pong_world.sdf");
  std::uint64_t heard_ = 0;
  std::uint64_t missed_ = 0;
  std::int64_t last_ = 0;
  Transport transport_;
  const Subscription clock_ =
      transport_.node().subscribe<ignition::msgs::Clock>("/clock", [this](const auto& message) { hear(message); });
};

TEST_F(TransportFault, OfAStoppedSubscriberHoldsUpNothing) {
  const auto other = echo("/clock");
  ASSERT_TRUE(goesOn(100));
  const std::uint64_t memory = memoryOf(world_->pid());
  other->kill(SIGSTOP);
  // more than is kept for it
  EXPECT_TRUE(goesOn(3000));
  EXPECT_LT(memoryOf(world_->pid()), memory + kSomeMemory);
  other->kill(SIGCONT);
  const std::size_t before = other->output().size();
  EXPECT_TRUE(goesOn(100));
  const auto deadline = std::chrono::steady_clock::now() + kDeadline;
  while (other->output().size() == before && std::chrono::steady_clock::now() < deadline) goesOn(1);
  EXPECT_GT(other->output().size(), before) << "it hears nothing any more";
  EXPECT_EQ(lines(world_->error()).size(), 1U) << world_->error();
}

TEST_F(TransportFault, OfSubscribersThatAreKilledHoldsUpNothing) {
  ASSERT_TRUE(goesOn(100));
  const std::uint64_t memory = memoryOf(world_->pid());
  for (int i = 0; i < 20 && !HasFailure(); ++i) {
    const auto other = echo("/clock");
    other->kill(SIGKILL);
    EXPECT_TRUE(goesOn(20)) << "after the death of number " << i;
  }
  EXPECT_TRUE(goesOn(1000));
  EXPECT_LT(memoryOf(world_->pid()), memory + kSomeMemory);
  EXPECT_EQ(runToEnd({"topic", "-et", "/clock", "-n", "3"}).exitCode, 0);
}

TEST_F(TransportFault, OfASlowSubscriberIsCountedAndHoldsUpNothing) {
  const auto terminal = PseudoTerminal::open();
  if (!terminal) GTEST_SKIP() << "no terminal can be had here";
  // nobody reads the terminal: the program blocks once its buffer is full
  const Process slow({"sh", "-c", "exec " PONGSIM_PROGRAM " topic -e -t /clock >" + terminal->name()});
  const std::uint64_t memory = memoryOf(world_->pid());
  const Regex subscriber("  " + std::to_string(slow.pid()) +
                         ", ignition\\.msgs\\.Clock, [0-9.]+ Hz, \\d+ received, [1-9]\\d* dropped\n");
  std::string said;
  const auto deadline = std::chrono::steady_clock::now() + kDeadline;
  while (!subscriber.isIn(said) && std::chrono::steady_clock::now() < deadline && goesOn(500)) {
    said = runToEnd({"topic", "-i", "-t", "/clock"}).output;
  }
  EXPECT_TRUE(subscriber.isIn(said)) << said;
  EXPECT_TRUE(goesOn(1000));
  EXPECT_LT(memoryOf(world_->pid()), memory + kSomeMemory);
}

TEST_F(TransportFault, OfAFloodHoldsUpNothing) {
  ASSERT_TRUE(goesOn(100));
  const std::uint64_t memory = memoryOf(world_->pid());
  Process flood({TRANSPORT_PEER, "flood", "/cmd_vel", "ignition.msgs.Twist", "100000"});
  ASSERT_TRUE(flood.waitForOutput("ready"));
  EXPECT_TRUE(goesOn(1000));
  const std::string said = runToEnd({"topic", "-i", "-t", "/cmd_vel"}).output;
  EXPECT_TRUE(
      Regex(std::to_string(world_->pid()) + ", ignition\\.msgs\\.Twist, [1-9]\\d* Hz, [1-9]\\d* received").isIn(said))
      << said;
  EXPECT_LT(memoryOf(world_->pid()), memory + kSomeMemory);
}

/// @return Whether the topics discovered by `transport` meet the condition in time.
bool seesSoon(Transport& transport, const std::function<bool(const std::set<std::string>&)>& isDone) {
  const auto deadline = std::chrono::steady_clock::now() + kDeadline;
  std::set<std::string> names;
  while (!isDone(names) && std::chrono::steady_clock::now() < deadline) {
    names.clear();
    for (const TopicInfo& each : transport.discover(kDeadline)) names.insert(each.name);
    transport.dispatchFor(std::chrono::milliseconds(20));
  }
  return isDone(names);
}

/// Expects that a killed participant is removed when its lease ends, and a living one is not.
void forgetsTheKilled() {
  Transport transport;
  std::vector<std::unique_ptr<Process>> others;
  std::vector<std::string> topics;
  for (int i = 0; i < 3; ++i) {
    others.push_back(std::make_unique<Process>(std::vector<std::string>{TRANSPORT_PEER, "offer", "1", "0"}));
    topics.push_back("/" + std::to_string(others[i]->pid()) + "/0");
  }
  const auto sees = [&](const std::set<std::string>& wanted) {
    return seesSoon(transport, [&](const std::set<std::string>& names) { return names == wanted; });
  };
  ASSERT_TRUE(sees({topics.begin(), topics.end()}));
  for (int i = 0; i < 2; ++i) {
    others[i]->kill(SIGKILL);
    others[i]->wait();
  }
  EXPECT_TRUE(sees({topics[2]}));
  others[2]->kill(SIGSTOP);
  EXPECT_TRUE(sees({}));
  others[2]->kill(SIGCONT);
  EXPECT_TRUE(sees({topics[2]})) << "it is back";
  others[2]->kill(SIGTERM);
}

TEST(Transport, ForgetsWhoWasKilled) {
  testDomain();
  forgetsTheKilled();
}

TEST(Transport, ForgetsWhoWasKilledOfASecuredDomain) {
  testDomain();
  const TempFolder folder;
  const std::string keys = folder.path() / "keys";
  ASSERT_EQ(runToEnd({"security", "init", keys}).exitCode, 0);
  setenv("PONGSIM_SECURITY", keys.c_str(), 1);
  forgetsTheKilled();
  unsetenv("PONGSIM_SECURITY");
}

// Counts how often a write waits for another thread: its duration would also depend on the load of the machine.
TEST(Transport, HoldsUpNobodyWhoPublishes) {
  testDomain();
  Transport transport;
  Publisher publisher = transport.node().advertise<ignition::msgs::StringMsg>("/texts");
  const Subscription flooded =
      transport.node().subscribe<ignition::msgs::Twist>("/flood", [](const ignition::msgs::Twist&) {});
  Process flood({TRANSPORT_PEER, "flood", "/flood", "ignition.msgs.Twist", "100000"});
  ASSERT_TRUE(flood.waitForOutput("ready"));
  std::vector<std::unique_ptr<Process>> listeners;
  for (int i = 0; i < 3; ++i) {
    listeners.push_back(std::make_unique<Process>(std::vector<std::string>{TRANSPORT_PEER, "listen", "/texts"}));
    ASSERT_TRUE(listeners.back()->waitForOutput("ready"));
  }
  listeners[1]->kill(SIGSTOP);
  listeners[2]->kill(SIGKILL);

  constexpr int kWrites = 5000;
  int waits = 0;
  ignition::msgs::StringMsg message;
  for (int i = 0; i < kWrites; ++i) {
    rusage before{};
    rusage after{};
    getrusage(RUSAGE_THREAD, &before);
    publisher.publish(message);
    getrusage(RUSAGE_THREAD, &after);
    waits += after.ru_nvcsw > before.ru_nvcsw ? 1 : 0;
    transport.dispatchFor(std::chrono::microseconds(200));
  }
  EXPECT_TRUE(listeners[0]->waitForOutput("got"));
  // the outbox's lock is rarely taken, and held only briefly
#ifdef __SANITIZE_THREAD__
  // longer with the sanitizer
  EXPECT_LT(waits, kWrites / 50);
#else
  EXPECT_LT(waits, kWrites / 200);
#endif
}

TEST(Transport, LeavesNothingBehindHoweverItEnds) {
  testDomain();
  const TempFolder folder;
  std::set<std::string> shared;
  const Process::Options options{.environment = {{"TMPDIR", folder.path()}, {"HOME", folder.path()}}, .folder = {}};
  const std::vector<std::string> run = {PONGSIM_PROGRAM, "run", ownWorld("pong_world.sdf")};
  for (int signal : {SIGKILL, SIGINT}) {
    Process world(run, options);
    ASSERT_TRUE(world.waitForError("pongsim: world '")) << world.error();
    Process other({PONGSIM_PROGRAM, "topic", "-e", "-t", "/clock"}, options);
    ASSERT_TRUE(other.waitForOutput("sim")) << other.error();
    shared.merge(sharedMemoryOf(world.pid()));
    shared.merge(sharedMemoryOf(other.pid()));
    other.kill(SIGKILL);
    world.kill(signal);
    EXPECT_EQ(world.wait(), signal == SIGKILL ? 128 + SIGKILL : 0);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  for (const std::string& name : shared) EXPECT_FALSE(std::filesystem::exists("/dev/shm/" + name)) << name;
}

TEST(Transport, OfARunIsOnLoopbackOnly) {
  const auto world = startServedWorld("pong_world.sdf");
  const std::set<std::string> sockets = socketsOf(world->pid(), "udp");
  EXPECT_GE(sockets.size(), 2U);
  for (const std::string& socket : sockets) EXPECT_TRUE(socket.starts_with("0100007F:")) << socket;
  for (const char* table : {"udp6", "tcp", "tcp6"}) EXPECT_TRUE(socketsOf(world->pid(), table).empty()) << table;
}

TEST(Transport, OfARunIsOpenToTheNetworkThatItIsToldAndSaysSo) {
  if (Process({"unshare", "-rn", "ip", "addr", "add", "10.7.7.1/24", "dev", "lo"}).wait() != 0) {
    GTEST_SKIP() << "no network namespace can be made here";
  }
  testDomain();
  Process world({"unshare", "-rn", "sh", "-c",
                 "ip link set lo up && ip addr add 10.7.7.1/24 dev lo && exec " PONGSIM_PROGRAM
                 " run --network 10.7.7.1 " +
                     ownWorld("pong_world.sdf")});
  ASSERT_TRUE(world.waitForError("pongsim: open to the network of lo, 10\\.7\\.7\\.1: ")) << world.error();
  bool isOpen = false;
  for (const std::string& socket : socketsOf(world.pid(), "udp")) {
    isOpen = isOpen || socket.starts_with("0107070A:");
    // this address, and the discovery ports
    EXPECT_TRUE(socket.starts_with("0100007F:") || socket.starts_with("0107070A:") || socket.starts_with("0100FFEF:"))
        << socket;
  }
  EXPECT_TRUE(isOpen);
  for (const char* table : {"udp6", "tcp", "tcp6"}) EXPECT_TRUE(socketsOf(world.pid(), table).empty()) << table;
}

TEST(Transport, RefusesANetworkThatIsNoneAndSaysWhichThereAre) {
  const Outcome run = runToEnd({"run", ownWorld("pong_world.sdf"), "--network", "eth99"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_TRUE(run.error.starts_with("pongsim: error: this machine has no network interface 'eth99'; it has "))
      << run.error;
  EXPECT_NE(run.error.find("lo (127.0.0.1)"), std::string::npos) << run.error;
  EXPECT_EQ(lines(run.error).size(), 1U) << run.error;
}

TEST(Transport, FindsAllOfManyProcesses) {
  testDomain();
  constexpr int kOffering = 25;
  std::vector<std::unique_ptr<Process>> others;
  for (int i = 0; i < kOffering; ++i) {
    others.push_back(std::make_unique<Process>(std::vector<std::string>{TRANSPORT_PEER, "offer", "20", "8"}));
  }
  for (int i = 0; i < 5; ++i) {
    others.push_back(std::make_unique<Process>(std::vector<std::string>{TRANSPORT_PEER, "listen", "/chatter"}));
  }
  for (const auto& other : others) ASSERT_TRUE(other->waitForOutput("ready")) << other->error();
  EXPECT_EQ(lines(runToEnd({"topic", "-l"}).output).size(), 500U);
  EXPECT_EQ(lines(runToEnd({"service", "-l"}).output).size(), 200U);
  const std::string chatter = runToEnd({"topic", "-lv"}).output;
  EXPECT_NE(chatter.find("/chatter [ignition.msgs.StringMsg] 0 publishers, 5 subscribers\n"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::test
