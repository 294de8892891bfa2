// Measures the latency of messages between processes, how many arrive, and the cost of publishing, also with
// subscribers that are stopped, slow or killed. Compared with ign-transport 11, if Debian's library is installed.
//   pongsim_transport_bench                                all measurements
//   pongsim_transport_bench listen LIBRARY KIND COUNT MS   subscriber process: receives COUNT messages, pauses MS after
//   each pongsim_transport_bench flood                          publishes as fast as it can pongsim_transport_bench
//   kill                           starts listeners and kills them

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#ifdef PONGSIM_HAS_IGN_TRANSPORT
#include <ignition/transport/Node.hh>
#endif

#include "calls.hh"
#include "kinds.hh"
#include "peers.hh"
#include "pongsim/node.hh"
#include "support/process.hh"
#include "support/test_domain.hh"
#include "trouble.hh"

namespace {

using namespace pongsim::benchmark;
using pongsim::test::Process;

/// Measures one publisher with several subscribers.
void measureMany(int kind, int listeners) {
  const Kind& what = kKinds[kind];
  std::printf("%s at %.0f Hz to %d processes\n", what.name, what.rate, listeners);
  withMessage(kind, [&]<class M>(M message) {
    std::vector<std::unique_ptr<Process>> others;
    for (int i = 0; i < listeners; ++i) others.push_back(listener("pongsim", kind, what.count));
    pongsim::Transport transport;
    auto publisher = transport.node().advertise<M>(kTopic);
    // wait until all subscribers are discovered
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

/// @return Processor time of this process and of its children that have ended.
Microseconds processorTime() {
  Microseconds sum{0};
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    for (const timeval& part : {used.ru_utime, used.ru_stime}) {
      sum += std::chrono::seconds(part.tv_sec) + std::chrono::microseconds(part.tv_usec);
    }
  }
  return sum;
}

/// Measures pongsim's transport from one process to another: latency, duration of publishing, and processor time of
/// both processes per message.
void measureOwn(int kind, const char* name) {
  const Kind& what = kKinds[kind];
  withMessage(kind, [&]<class M>(M message) {
    const auto other = listener("pongsim", kind, what.count);
    pongsim::Transport transport;
    auto publisher = transport.node().advertise<M>(kTopic);
    publisher.waitForSubscribers(pongsim::test::kDeadline);
    const Microseconds before = processorTime();
    const std::string publishing = summary(publishAt(what.rate, what.count, [&] {
                                             stamp(message);
                                             publisher.publish(message);
                                           }).took);
    const std::string there = reportOf(*other);
    const double each = (processorTime() - before).count() / what.count;
    std::printf("  %-13s %s\n  (publishing)  %s\n  (processors)  %.0f us a message\n", name, there.c_str(),
                publishing.c_str(), each);
  });
}

void measureDelivery(int kind) {
  const Kind& what = kKinds[kind];
  std::printf("%s at %.0f Hz\n", what.name, what.rate);
  measureOwn(kind, "pongsim");
  if (const char* keystore = std::getenv("PONGSIM_BENCH_KEYSTORE")) {
    setenv("PONGSIM_SECURITY", keystore, 1);
    measureOwn(kind, "secured");
    unsetenv("PONGSIM_SECURITY");
  }
#ifdef PONGSIM_HAS_IGN_TRANSPORT
  std::string there;
  withMessage(kind, [&]<class M>(M message) {
    const auto other = listener("ignition", kind, what.count);
    ignition::transport::Node node;
    auto publisher = node.Advertise<M>(kTopic);
    while (!publisher.HasConnections()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    // ign-transport reports the connection before messages can arrive
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
  // sets the domain of this process and of those that it starts
  pongsim::test::testDomain();
  setenv("IGN_IP", "127.0.0.1", 1);
  for (int kind = 0; kind < static_cast<int>(std::size(kKinds)); ++kind) measureDelivery(kind);
  measureMany(kImage, 5);
  measureTroubles();
  return 0;
}
