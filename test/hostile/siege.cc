#include "hostile/siege.hh"

#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <thread>

#include "support/proc.hh"
#include "support/test_domain.hh"

namespace pongsim::hostile {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using test::kDeadline;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::size_t entries(pid_t pid, const char* folder) {
  std::error_code ignored;
  const std::filesystem::directory_iterator all("/proc/" + std::to_string(pid) + "/" + folder, ignored);
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

/// @return The lowest count within 40 ms, because the library briefly opens a descriptor now and then, to list sockets.
std::size_t fewestEntries(pid_t pid, const char* folder) {
  std::size_t fewest = entries(pid, folder);
  for (int i = 0; i < 20; ++i) {
    std::this_thread::sleep_for(milliseconds(2));
    fewest = std::min(fewest, entries(pid, folder));
  }
  return fewest;
}

}  // namespace

Siege::Siege()
    : domain_(test::testDomain()),
      world_({PONGSIM_PROGRAM, "run", PONGSIM_WORLD}),
      publisher_({TRANSPORT_PEER, "flood", "/chatter", "ignition.msgs.StringMsg", "1000"}),
      clock_(transport_.node().subscribe<ignition::msgs::Clock>("/clock", [this](const auto&) { ++steps_; })),
      chatter_(
          transport_.node().subscribe<ignition::msgs::StringMsg>("/chatter", [this](const auto&) { ++messages_; })) {
  const auto end = Clock::now() + kDeadline;
  while (steps_ < 100 || messages_ < 100) {
    transport_.dispatchFor(milliseconds(20));
    if (Clock::now() > end) throw std::runtime_error("the world is not heard: " + world_.error());
  }
}

void Siege::hear(milliseconds duration, Figures& figures) {
  const auto start = Clock::now();
  const std::uint64_t steps = steps_, messages = messages_;
  while (Clock::now() < start + duration) {
    transport_.dispatchFor(milliseconds(20));
    figures.memoryMost = std::max(figures.memoryMost, test::memoryOf(world_.pid()));
  }
  figures.seconds = since(start);
  figures.steps = steps_ - steps;
  figures.messages = messages_ - messages;
}

Figures Siege::rest(milliseconds duration) {
  Figures figures;
  figures.memoryBefore = test::memoryOf(world_.pid());
  hear(duration, figures);
  figures.memoryAfter = test::memoryOf(world_.pid());
  return figures;
}

Figures Siege::attack(const std::vector<std::string>& arguments, milliseconds duration) {
  Figures figures;
  const std::set<std::string> before = list();
  figures.memoryBefore = test::memoryOf(world_.pid());
  figures.threadsBefore = fewestEntries(world_.pid(), "task");
  figures.descriptorsBefore = fewestEntries(world_.pid(), "fd");
  {
    std::vector<std::string> command = {RTPS_FUZZ, "--domain", std::to_string(domain_), "--seconds",
                                        std::to_string(std::chrono::duration<double>(duration).count())};
    command.insert(command.end(), arguments.begin(), arguments.end());
    test::Process attacker(command);
    if (!attacker.waitForOutput("strikes at ")) throw std::runtime_error("no attack: " + attacker.error());
    hear(duration, figures);
    attacker.wait();
    figures.attacker = attacker.output() + attacker.error();
  }
  const auto end = Clock::now();
  figures.isHeardAfterwards = newcomerHears();
  figures.recovery = since(end);
  do {
    transport_.dispatchFor(milliseconds(20));
    figures.isListedAsBefore = list() == before;
  } while (!figures.isListedAsBefore && since(end) < std::chrono::duration<double>(kDeadline).count());
  figures.clean = since(end);
  figures.memoryAfter = test::memoryOf(world_.pid());
  figures.threadsAfter = fewestEntries(world_.pid(), "task");
  figures.descriptorsAfter = fewestEntries(world_.pid(), "fd");
  return figures;
}

bool Siege::newcomerHears() {
  Transport newcomer;
  bool hasHeard = false;
  const auto subscription =
      newcomer.node().subscribe<ignition::msgs::Clock>("/clock", [&](const auto&) { hasHeard = true; });
  for (const auto end = Clock::now() + kDeadline; !hasHeard && Clock::now() < end;) {
    newcomer.dispatchFor(milliseconds(1));
    transport_.dispatch();
  }
  return hasHeard;
}

/// @return The topics that this process has discovered.
std::set<std::string> Siege::list() {
  std::set<std::string> names;
  for (const TopicInfo& each : transport_.discover(kDeadline)) names.insert(each.name);
  return names;
}

bool Siege::endsWell() {
  world_.kill(SIGINT);
  const std::optional<int> code = world_.wait();
  complaints_ = world_.error();
  return code == 0;
}

}  // namespace pongsim::hostile
