// Runs a world for a long time while other processes come and go. Its memory must not grow, and every lost message must
// be counted. Prints a line every ten seconds. Exit code 1 if a check fails.
//   pongsim_transport_soak MINUTES
//   pongsim_transport_soak hear MS   subscriber process: receives numbers, pauses MS after each, reports on SIGTERM

#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/int32.pb.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "pongsim/node.hh"
#include "support/proc.hh"
#include "support/process.hh"
#include "support/test_domain.hh"

namespace {

using Clock = std::chrono::steady_clock;
using ignition::msgs::Int32;
using pongsim::test::Process;

constexpr const char* kNumbers = "/soak/numbers";
constexpr std::chrono::seconds kLinePeriod{10};
// Deadline on a machine with far more work than processors, where this process has the lowest priority.
constexpr std::chrono::seconds kPatience{600};
// A process that does not run for six seconds counts as dead, because its lease ends. Messages published until it is
// discovered again are sent to nobody, so nobody counts them.
constexpr std::chrono::seconds kOutOfSight{4};
constexpr std::chrono::seconds kFoundAgain{30};
// How much memory may grow after the first fifth of the time [bytes]; less than a leak of one byte per message.
constexpr std::uint64_t kGrowth = 8 << 20;

std::atomic<bool> stopped = false;

/// Counts the gaps in a sequence of received numbers, and those after a process did not run, which nobody counts.
class Gaps {
 public:
  void take(std::int64_t number) {
    look();
    look(taken_);
    const std::int64_t gap = heard_ > 0 ? number - last_ - 1 : 0;
    missed_ += gap;
    if (taken_ < pause_ + kFoundAgain) unseen_ += gap;
    last_ = number;
    ++heard_;
  }
  /// Call before each dispatch.
  void look() { look(looked_); }

  std::int64_t heard() const { return heard_; }
  std::int64_t missed() const { return missed_; }
  /// @return How many were missed after a process did not run.
  std::int64_t unseen() const { return unseen_; }
  bool areEvenWith(std::uint64_t dropped) const {
    const std::int64_t uncounted = missed_ - static_cast<std::int64_t>(dropped);
    return uncounted >= 0 && uncounted <= unseen_;
  }

 private:
  void look(Clock::time_point& last) {
    const Clock::time_point now = Clock::now();
    if (last > Clock::time_point::min() && now > last + kOutOfSight) pause_ = now;
    last = now;
  }

  std::int64_t last_ = 0, heard_ = 0, missed_ = 0, unseen_ = 0;
  Clock::time_point looked_ = Clock::time_point::min(), taken_ = Clock::time_point::min();
  Clock::time_point pause_ = Clock::time_point::min();
};

int hear(int pauseMs) {
  signal(SIGTERM, [](int) { stopped = true; });
  pongsim::Transport transport;
  Gaps gaps;
  pongsim::Subscription subscription;
  // Bounds for what was dropped before the first number, which leaves no gap: what was counted before the last dispatch
  // without a number, and what was counted at the first number.
  std::uint64_t least = 0, most = 0;
  subscription = transport.node().subscribe<Int32>(kNumbers, [&](const Int32& message) {
    if (gaps.heard() == 0) most = subscription.dropped();
    gaps.take(message.data());
    if (!stopped) std::this_thread::sleep_for(std::chrono::milliseconds(pauseMs));
  });
  std::puts("ready");
  std::fflush(stdout);
  const auto dispatch = [&] {
    const std::uint64_t before = subscription.dropped();
    gaps.look();
    transport.dispatchFor(std::chrono::milliseconds(20));
    if (gaps.heard() == 0) least = before;
  };
  const auto dropped = [&] {
    const std::uint64_t all = subscription.dropped(), missed = static_cast<std::uint64_t>(gaps.missed());
    return all - std::clamp(all > missed ? all - missed : 0, least, most);
  };
  while (!stopped) dispatch();
  // wait for a further message, because only that shows the last gap
  for (const auto end = Clock::now() + kPatience; Clock::now() < end;) {
    dispatch();
    if (gaps.areEvenWith(dropped())) break;
  }
  std::printf(
      "heard %lld missed %lld dropped %llu unseen %lld of all dropped %llu, before the first %llu to %llu: %s\n",
      static_cast<long long>(gaps.heard()), static_cast<long long>(gaps.missed()),
      static_cast<unsigned long long>(dropped()), static_cast<long long>(gaps.unseen()),
      static_cast<unsigned long long>(subscription.dropped()), static_cast<unsigned long long>(least),
      static_cast<unsigned long long>(most), gaps.areEvenWith(dropped()) ? "even" : "not even");
  return 0;
}

/// Publishes numbers at 1 kHz from a thread of its own.
class Numbers {
 public:
  Numbers()
      : publisher_(transport_.node().advertise<Int32>(kNumbers)), thread_([this] {
          Int32 message;
          for (auto next = Clock::now(); !isOver_; next += std::chrono::milliseconds(1)) {
            message.set_data(message.data() + 1);
            publisher_.publish(message);
            std::this_thread::sleep_until(next);
          }
        }) {}
  ~Numbers() {
    isOver_ = true;
    thread_.join();
  }
  std::uint64_t sent() const { return publisher_.sent(); }

 private:
  pongsim::Transport transport_;
  pongsim::Publisher publisher_;
  std::atomic<bool> isOver_ = false;
  std::thread thread_;
};

/// The world, its visitors, and the checks.
class Soak {
 public:
  explicit Soak(Clock::duration time) : time_(time), world_({PONGSIM_PROGRAM, "run", PONGSIM_WORLD}) {
    check(world_.waitForError("pongsim: world '", kPatience), "the world does not start: " + world_.error());
  }

  int run() {
    std::printf("%8s %12s %12s %10s %10s %8s %8s %10s\n", "s", "steps heard", "numbers", "world MB", "here MB", "came",
                "killed", "dropped");
    const auto subscription = transport_.node().subscribe<ignition::msgs::Clock>("/clock", [this](const auto& message) {
      clock_.take(message.sim().sec() * 1000 + message.sim().nsec() / 1'000'000);
    });
    const auto take = [this] {
      clock_.look();
      transport_.dispatchFor(std::chrono::milliseconds(20));
    };
    std::thread others([this] {
      for (std::size_t i = 0; !isOver_ && isFine_; ++i) visit(i);
    });
    const auto start = Clock::now();
    for (auto next = start + kLinePeriod; Clock::now() < start + time_ && isFine_;) {
      take();
      if (Clock::now() < next) continue;
      next += kLinePeriod;
      report(Clock::now() - start, subscription.dropped());
    }
    // a message is counted as dropped before its gap shows
    const auto isEven = [&] { return clock_.areEvenWith(subscription.dropped()); };
    for (const auto end = Clock::now() + kPatience; !isEven() && Clock::now() < end;) take();
    check(clock_.heard() > 0, "no step was heard");
    const std::string counts = "of the clock " + std::to_string(clock_.missed()) + " messages are missing, " +
                               std::to_string(subscription.dropped()) + " are counted as dropped, " +
                               std::to_string(clock_.unseen()) + " were missed after a process did not run";
    check(isEven(), counts + "; the world says: " + world_.error());
    if (clock_.unseen() > 0) std::puts(counts.c_str());
    isOver_ = true;
    others.join();
    world_.kill(SIGINT);
    check(world_.wait(kPatience) == 0, "the world does not end as it should: " + world_.error());
    std::puts(isFine_ ? "fine" : "failed");
    return isFine_ ? 0 : 1;
  }

 private:
  void check(bool holds, const std::string& otherwise) {
    if (holds) return;
    std::printf("FAILED: %s\n", otherwise.c_str());
    std::fflush(stdout);
    isFine_ = false;
  }

  void report(Clock::duration now, std::uint64_t dropped) {
    constexpr double kMega = 1 << 20;
    const std::uint64_t world = pongsim::test::memoryOf(world_.pid());
    const std::uint64_t here = pongsim::test::memoryOf(getpid());
    std::printf("%8.0f %12lld %12llu %10.1f %10.1f %8d %8d %10llu\n", std::chrono::duration<double>(now).count(),
                static_cast<long long>(clock_.heard()), static_cast<unsigned long long>(numbers_.sent()),
                static_cast<double>(world) / kMega, static_cast<double>(here) / kMega, came_.load(), killed_.load(),
                static_cast<unsigned long long>(dropped + droppedByOthers_));
    std::fflush(stdout);
    if (now < time_ / 5) {
      worldAtFirst_ = std::max(worldAtFirst_, world);
      hereAtFirst_ = std::max(hereAtFirst_, here);
      return;
    }
    check(world < worldAtFirst_ + kGrowth, "the world's memory grows");
    check(here < hereAtFirst_ + kGrowth, "a publisher's memory grows");
  }

  std::unique_ptr<Process> come(std::vector<std::string> arguments, const std::string& sign) {
    auto process = std::make_unique<Process>(arguments);
    ++came_;
    check(process->waitForOutput(sign, kPatience), arguments.at(1) + " hears nothing: " + process->error());
    return process;
  }

  /// @param trouble Disturbs the subscriber before it reports.
  void visitNumbers(int pauseMs, const std::function<void(Process&)>& trouble) {
    const auto other = come({"/proc/self/exe", "hear", std::to_string(pauseMs)}, "ready");
    trouble(*other);
    other->kill(SIGTERM);
    check(other->wait(2 * kPatience) == 0, "a subscriber does not end");
    long long heard = 0, missed = 0, dropped = 0;
    const std::string said = other->output();
    const bool isRead =
        std::sscanf(said.c_str(), "ready heard %lld missed %lld dropped %lld", &heard, &missed, &dropped) == 3;
    check(isRead && said.ends_with(": even\n"), "a subscriber says: " + said);
    droppedByOthers_ += static_cast<std::uint64_t>(dropped);
  }

  /// Starts subscribers in turn: one that listens for a while, one that is slow or stopped, one that is killed.
  void visit(std::size_t number) {
    using std::chrono::milliseconds;
    const auto sleep = [](milliseconds time) { std::this_thread::sleep_for(time); };
    switch (number % 6) {
      case 0:
        return visitNumbers(0, [&](Process&) { sleep(milliseconds(1000)); });
      case 1:
        return visitNumbers(5, [&](Process&) { sleep(milliseconds(2000)); });
      case 2:
        return visitNumbers(0, [&](Process& other) {
          sleep(milliseconds(100));
          other.kill(SIGSTOP);
          sleep(milliseconds(2500));
          other.kill(SIGCONT);
          sleep(milliseconds(300));
        });
      case 3: {
        const auto other = come({PONGSIM_PROGRAM, "topic", "-e", "-t", "/clock"}, "sim");
        other->kill(SIGKILL);
        ++killed_;
        return;
      }
      case 4: {
        const auto other = come({"/proc/self/exe", "hear", "0"}, "ready");
        sleep(milliseconds(50));
        other->kill(SIGKILL);
        ++killed_;
        return;
      }
      default: {
        Process caller({PONGSIM_PROGRAM, "service", "-s", "/gazebo/worlds", "--timeout", "600000", "--req", ""});
        ++came_;
        check(caller.wait(kPatience) == 0, "a service does not answer: " + caller.error());
      }
    }
  }

  Clock::duration time_;
  std::atomic<bool> isFine_ = true;
  std::atomic<bool> isOver_ = false;
  Process world_;
  pongsim::Transport transport_;
  Numbers numbers_;
  Gaps clock_;
  std::uint64_t worldAtFirst_ = 0, hereAtFirst_ = 0;
  std::atomic<int> came_ = 0, killed_ = 0;
  std::atomic<std::uint64_t> droppedByOthers_ = 0;
};

}  // namespace

int main(int count, char** texts) {
  const std::vector<std::string> arguments(texts + 1, texts + count);
  if (arguments.size() == 2 && arguments[0] == "hear") return hear(std::stoi(arguments[1]));
  const int minutes = arguments.size() == 1 ? std::atoi(arguments[0].c_str()) : 0;
  if (minutes <= 0) {
    std::fprintf(stderr, "pongsim_transport_soak: error: takes a number of minutes\n");
    return 2;
  }
  pongsim::test::testDomain();
  return Soak(std::chrono::minutes(minutes)).run();
}
