#include "peers.hh"

#include <ignition/msgs/int32.pb.h>
#include <signal.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#ifdef PONGSIM_HAS_IGN_TRANSPORT
#include <ignition/transport/Node.hh>
#endif

#include "calls.hh"
#include "kinds.hh"
#include "pongsim/node.hh"

namespace pongsim::benchmark {

using test::Process;

namespace {

constexpr std::chrono::seconds kSilence{2};

/// Records the ages of messages until `count` have arrived or no more arrive.
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

}  // namespace

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

std::unique_ptr<Process> listener(const char* library, int kind, int count, int pause) {
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

std::unique_ptr<Process> other(const char* command) {
  auto process = std::make_unique<Process>(std::vector<std::string>{"/proc/self/exe", command});
  process->waitForOutput("ready");
  return process;
}

}  // namespace pongsim::benchmark
