// How long messages take from process to process, how many arrive, and what it costs who publishes, also beside
// subscribers that are stopped, slow or killed. Beside ign-transport 11, where Debian's library is installed.
//   pongsim_transport_bench                                the whole of it
//   pongsim_transport_bench listen LIBRARY KIND COUNT MS   its other process: hears so many, takes MS for each
//   pongsim_transport_bench flood                          publishes as fast as it can
//   pongsim_transport_bench kill                           starts listeners and kills them

#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#ifdef PONGSIM_HAS_IGN_TRANSPORT
#include <ignition/transport/Node.hh>
#endif

#include "pongsim/node.hh"
#include "support/process.hh"
#include "support/test_domain.hh"

namespace {

using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;
using pongsim::Message;
using pongsim::test::Process;

constexpr const char* kTopic = "/measured";
constexpr const char* kFloodTopic = "/flood";
constexpr std::chrono::seconds kSilence{2};

/// What is sent: at what rate, how often.
struct Kind {
  const char* name;
  double rate;
  int count;
};
constexpr Kind kKinds[] = {{"Twist", 1000, 2000},
                           {"LaserScan, 640 beams", 100, 300},
                           {"Image, 640x480 RGB", 30, 100},
                           {"PointCloudPacked, 2 MB", 10, 50},
                           {"Image, 1920x1080 RGB", 10, 30}};
constexpr int kImage = 2;

ignition::msgs::Image image(unsigned width, unsigned height) {
  ignition::msgs::Image message;
  message.set_width(width);
  message.set_height(height);
  message.mutable_data()->assign(std::size_t{3} * width * height, 'x');
  return message;
}

ignition::msgs::LaserScan scan() {
  ignition::msgs::LaserScan message;
  for (int i = 0; i < 640; ++i) message.add_ranges(1 + 0.01 * i);
  return message;
}

ignition::msgs::PointCloudPacked cloud() {
  ignition::msgs::PointCloudPacked message;
  message.mutable_data()->assign(2'000'000, 'x');
  return message;
}

/// Calls `use` with an empty message of the kind, ready to be sent.
template <class Use>
void withMessage(int kind, Use use) {
  switch (kind) {
    case 0:
      return use(ignition::msgs::Twist());
    case 1:
      return use(scan());
    case 2:
      return use(image(640, 480));
    case 3:
      return use(cloud());
    default:
      return use(image(1920, 1080));
  }
}

template <class M>
void stamp(M& message) {
  const auto now = Clock::now().time_since_epoch();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(now);
  message.mutable_header()->mutable_stamp()->set_sec(seconds.count());
  message.mutable_header()->mutable_stamp()->set_nsec(static_cast<std::int32_t>((now - seconds).count()));
}

template <class M>
Microseconds age(const M& message) {
  const auto& time = message.header().stamp();
  return Clock::now().time_since_epoch() - std::chrono::seconds(time.sec()) - std::chrono::nanoseconds(time.nsec());
}

/// @return What so large a part of the durations does not exceed [us].
double quantile(std::vector<Microseconds> all, double part) {
  std::ranges::sort(all);
  return all[std::min(all.size() - 1, static_cast<std::size_t>(part * static_cast<double>(all.size())))].count();
}

/// Of durations.
std::string summary(const std::vector<Microseconds>& all) {
  if (all.empty()) return "none";
  char text[120];
  std::snprintf(text, sizeof text, "median %7.1f us, 99.9 %% %8.1f us, worst %8.1f us", quantile(all, 0.5),
                quantile(all, 0.999), quantile(all, 1));
  return text;
}

/// How long each of many calls took, and in how many of them the thread had to wait for another one, or was pushed away
/// by one.
struct Calls {
  std::vector<Microseconds> took;
  int waits = 0;
  int pushes = 0;

  void measure(const std::function<void()>& call) {
    rusage before{}, after{};
    getrusage(RUSAGE_THREAD, &before);
    const auto begin = Clock::now();
    call();
    took.push_back(Clock::now() - begin);
    getrusage(RUSAGE_THREAD, &after);
    waits += after.ru_nvcsw > before.ru_nvcsw ? 1 : 0;
    pushes += after.ru_nivcsw > before.ru_nivcsw ? 1 : 0;
  }
};

/// Calls `publish` at the rate, and `between` after each, half a period later.
Calls publishAt(double rate, int count, const std::function<void()>& publish,
                const std::function<void()>& between = {}) {
  Calls calls;
  const auto start = Clock::now();
  const auto sleepUntil = [&](double period) {
    std::this_thread::sleep_until(start +
                                  std::chrono::duration_cast<Clock::duration>(period / rate * std::chrono::seconds(1)));
  };
  for (int i = 0; i < count; ++i) {
    sleepUntil(i);
    calls.measure(publish);
    if (!between) continue;
    sleepUntil(i + 0.5);
    between();
  }
  return calls;
}

/// The listening process: until it has `count` messages or hears nothing any more.
class Listener {
 public:
  Listener(std::size_t count, std::chrono::milliseconds pause) : count_(count), pause_(pause) {}

  template <class M>
  void hear(const M& message) {
    const Microseconds took = age(message);
    {
      const std::lock_guard lock(mutex_);
      ages_.push_back(took);
      last_ = Clock::now();
    }
    std::this_thread::sleep_for(pause_);
  }

  bool isOver() {
    const std::lock_guard lock(mutex_);
    return ages_.size() >= count_ || (!ages_.empty() && Clock::now() - last_ > kSilence);
  }

  void report() {
    const std::lock_guard lock(mutex_);
    std::printf("%zu of %zu, %s\n", ages_.size(), count_, summary(ages_).c_str());
  }

 private:
  std::size_t count_;
  std::chrono::milliseconds pause_;
  std::mutex mutex_;
  std::vector<Microseconds> ages_;
  Clock::time_point last_;
};

void sayReady() {
  std::puts("ready");
  std::fflush(stdout);
}

template <class M>
void listenHere(Listener& listener) {
  pongsim::Transport transport;
  const auto subscription =
      transport.node().subscribe<M>(kTopic, [&listener](const M& message) { listener.hear(message); });
  sayReady();
  while (!listener.isOver()) transport.dispatchFor(std::chrono::milliseconds(20));
}

template <class M>
void listenByIgnition([[maybe_unused]] Listener& listener) {
#ifdef PONGSIM_HAS_IGN_TRANSPORT
  ignition::transport::Node node;
  std::function<void(const M&)> hear = [&listener](const M& message) { listener.hear(message); };
  node.Subscribe(kTopic, hear);
  sayReady();
  while (!listener.isOver()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
#endif
}

int listen(const std::string& library, int kind, std::size_t count, int pause) {
  Listener listener(count, std::chrono::milliseconds(pause));
  withMessage(kind, [&]<class M>(const M&) {
    library == "ignition" ? listenByIgnition<M>(listener) : listenHere<M>(listener);
  });
  listener.report();
  return 0;
}

int flood() {
  pongsim::Transport transport;
  auto publisher = transport.node().advertise<ignition::msgs::Int32>(kFloodTopic);
  sayReady();
  ignition::msgs::Int32 message;
  for (auto next = Clock::now();; next += std::chrono::milliseconds(1)) {
    for (int i = 0; i < 100; ++i) publisher.publish(message);
    std::this_thread::sleep_until(next);
  }
}

std::unique_ptr<Process> listener(const char* library, int kind, int count, int pause = 0) {
  auto process = std::make_unique<Process>(std::vector<std::string>{
      "/proc/self/exe", "listen", library, std::to_string(kind), std::to_string(count), std::to_string(pause)});
  process->waitForOutput("ready");
  return process;
}

std::string reportOf(Process& process) {
  process.wait();
  const std::string text = process.output();
  const std::size_t begin = text.find('\n') + 1;
  return text.substr(begin, text.rfind('\n') - begin);
}

/// One publishes, several listen.
void measureMany(int kind, int listeners) {
  const Kind& what = kKinds[kind];
  std::printf("%s at %.0f Hz to %d processes\n", what.name, what.rate, listeners);
  withMessage(kind, [&]<class M>(M message) {
    std::vector<std::unique_ptr<Process>> others;
    for (int i = 0; i < listeners; ++i) others.push_back(listener("pongsim", kind, what.count));
    pongsim::Transport transport;
    auto publisher = transport.node().advertise<M>(kTopic);
    // all of them are there for the first message
    while (transport.watchTopic(kTopic, std::chrono::milliseconds(200)).subscribers.size() < others.size()) continue;
    const std::string publishing = summary(publishAt(what.rate, what.count, [&] {
                                             stamp(message);
                                             publisher.publish(message);
                                           }).took);
    for (const auto& other : others) std::printf("  pongsim       %s\n", reportOf(*other).c_str());
    std::printf("  (publishing)  %s\n", publishing.c_str());
  });
  std::fflush(stdout);
}

void measureDelivery(int kind) {
  const Kind& what = kKinds[kind];
  std::string there, publishing;
  withMessage(kind, [&]<class M>(M message) {
    const auto other = listener("pongsim", kind, what.count);
    pongsim::Transport transport;
    auto publisher = transport.node().advertise<M>(kTopic);
    publisher.waitForSubscribers(pongsim::test::kDeadline);
    publishing = summary(publishAt(what.rate, what.count, [&] {
                           stamp(message);
                           publisher.publish(message);
                         }).took);
    there = reportOf(*other);
  });
  std::printf("%s at %.0f Hz\n  pongsim       %s\n  (publishing)  %s\n", what.name, what.rate, there.c_str(),
              publishing.c_str());
#ifdef PONGSIM_HAS_IGN_TRANSPORT
  withMessage(kind, [&]<class M>(M message) {
    const auto other = listener("ignition", kind, what.count);
    ignition::transport::Node node;
    auto publisher = node.Advertise<M>(kTopic);
    while (!publisher.HasConnections()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    // it says so before the first message would arrive
    std::this_thread::sleep_for(std::chrono::seconds(1));
    publishAt(what.rate, what.count, [&] {
      stamp(message);
      publisher.Publish(message);
    });
    there = reportOf(*other);
  });
  std::printf("  ign-transport %s\n", there.c_str());
#endif
  std::fflush(stdout);
}

void printCalls(const char* name, const Calls& calls) {
  std::printf("  %-27s %s, %d waited, %d pushed away\n", name, summary(calls.took).c_str(), calls.waits, calls.pushes);
}

/// What a write takes, when nothing is in its way.
void doNothing() {
  const auto end = Clock::now() + std::chrono::microseconds(10);
  while (Clock::now() < end) continue;
}

/// Other processes, which may behave badly.
struct Company {
  std::vector<std::unique_ptr<Process>> processes;
  /// Called from a thread of its own, again and again.
  std::function<void()> trouble;
};

/// What was found in four seconds beside others.
struct Window {
  Calls writes;
  /// Between two writes the same thread did nothing for as long: what held that up was the machine.
  Calls nothing;
  std::uint64_t came = 0;
  std::uint64_t dropped = 0;
};

/// Publishes a Twist at 1 kHz.
Window measureBeside(Company company) {
  Window window;
  pongsim::Transport transport;
  const auto subscription =
      transport.node().subscribe<ignition::msgs::Int32>(kFloodTopic, [](const ignition::msgs::Int32&) {});
  auto publisher = transport.node().advertise<ignition::msgs::Twist>(kTopic);
  if (!company.processes.empty()) publisher.waitForSubscribers(std::chrono::seconds(2));
  std::atomic<bool> isOver = false;
  std::thread troubled([&] {
    while (!isOver && company.trouble) company.trouble();
  });
  ignition::msgs::Twist message;
  window.writes = publishAt(
      1000, 4000,
      [&] {
        stamp(message);
        publisher.publish(message);
      },
      [&] {
        window.nothing.measure(doNothing);
        transport.dispatch();
      });
  isOver = true;
  troubled.join();
  window.came = subscription.received();
  window.dropped = subscription.dropped();
  for (auto& each : company.processes) {
    each->kill(SIGTERM);
    each->kill(SIGCONT);
    each->wait();
  }
  return window;
}

/// Tells of the window in which the machine was quietest, whatever the writes took in it.
void measureTrouble(const char* name, const std::function<Company()>& meet) {
  constexpr int kMostWindows = 6;
  constexpr double kQuiet = 40;
  Window quietest;
  double least = 0;
  int windows = 0;
  while (windows < kMostWindows && (windows == 0 || least > kQuiet)) {
    Window window = measureBeside(meet());
    const double held = quantile(window.nothing.took, 0.999);
    if (windows++ > 0 && held >= least) continue;
    least = held;
    quietest = std::move(window);
  }
  printCalls(name, quietest.writes);
  printCalls("  10 us of nothing", quietest.nothing);
  std::printf("    the quietest of %d windows", windows);
  if (quietest.came > 0) {
    std::printf("; %llu messages came meanwhile, %llu were dropped", static_cast<unsigned long long>(quietest.came),
                static_cast<unsigned long long>(quietest.dropped));
  }
  std::printf("\n");
  std::fflush(stdout);
}

Company oneListener(int pause = 0) {
  Company company;
  company.processes.push_back(listener("pongsim", 0, 1'000'000, pause));
  return company;
}

Company stoppedListener() {
  Company company = oneListener();
  company.trouble = [pid = company.processes.front()->pid()] {
    kill(pid, SIGSTOP);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  };
  return company;
}

/// @return A process that does what this program's command says.
std::unique_ptr<Process> other(const char* command) {
  auto process = std::make_unique<Process>(std::vector<std::string>{"/proc/self/exe", command});
  process->waitForOutput("ready");
  return process;
}

Company killedListeners() {
  Company company;
  company.processes.push_back(other("kill"));
  return company;
}

Company flooder() {
  Company company = oneListener();
  company.processes.push_back(other("flood"));
  return company;
}

void measureTroubles() {
  std::printf("publishing a Twist at 1 kHz, each of 4,000 times\n");
  measureTrouble("nobody listens", [] { return Company(); });
  measureTrouble("one listens", [] { return oneListener(); });
  measureTrouble("one takes 20 ms a message", [] { return oneListener(20); });
  measureTrouble("one is stopped", stoppedListener);
  measureTrouble("one after another is killed", killedListeners);
  measureTrouble("one sends 100,000 a second", flooder);
}

/// Starts listeners and kills one after another, until it is asked to end. Not done by who publishes: a process that
/// forks copies each page that it writes to afterwards.
int killListeners() {
  sigset_t ending;
  sigemptyset(&ending);
  sigaddset(&ending, SIGTERM);
  sigprocmask(SIG_BLOCK, &ending, nullptr);
  sayReady();
  constexpr timespec kLife{0, 100'000'000};
  for (bool isOver = false; !isOver;) {
    const auto next = listener("pongsim", 0, 1'000'000);
    isOver = sigtimedwait(&ending, nullptr, &kLife) > 0;
    next->kill(SIGKILL);
    next->wait();
  }
  return 0;
}

}  // namespace

int main(int count, char** texts) {
  const std::vector<std::string> arguments(texts + 1, texts + count);
  if (!arguments.empty() && arguments[0] == "flood") return flood();
  if (!arguments.empty() && arguments[0] == "kill") return killListeners();
  if (arguments.size() == 5 && arguments[0] == "listen") {
    return listen(arguments[1], std::stoi(arguments[2]), std::stoul(arguments[3]), std::stoi(arguments[4]));
  }
  if (!arguments.empty()) {
    std::fprintf(stderr, "pongsim_transport_bench: error: takes no options\n");
    return 2;
  }
  // for this process and those that it starts
  pongsim::test::testDomain();
  setenv("IGN_IP", "127.0.0.1", 1);
  for (int kind = 0; kind < static_cast<int>(std::size(kKinds)); ++kind) measureDelivery(kind);
  measureMany(kImage, 5);
  measureTroubles();
  return 0;
}
