#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "cli/console.hh"
#include "cli/stop_signal.hh"
#include "cli/topic_command.hh"
#include "cli/topic_name.hh"
#include "pongsim/node.hh"

namespace pongsim::cli {

namespace {

using Clock = std::chrono::steady_clock;

/// How long a wait may last before the rest of the world is looked at.
constexpr std::chrono::milliseconds kLongestWait{100};
/// When a user should hear that there is nothing to hear.
constexpr std::chrono::seconds kPatience{1};

class Echo {
 public:
  explicit Echo(const EchoOptions& options) : options_(options) {
    if (options.duration) end_ = start_ + *options.duration;
  }

  int run();

 private:
  bool over() const { return done_ || signal_.stopped() || (end_ && Clock::now() >= *end_) || outputIsClosed(); }
  Clock::duration wait() const {
    if (!end_) return kLongestWait;
    return std::clamp<Clock::duration>(*end_ - Clock::now(), Clock::duration::zero(), kLongestWait);
  }
  std::string findType();
  bool typeIsWrong();
  void sayWaiting();
  void show(const Message& message);
  int fail(const std::string& message, const std::string& hint = {});

  const EchoOptions& options_;
  // before the transport, whose threads inherit the signals' mask
  StopSignal signal_;
  Transport transport_;
  const Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> end_;
  std::string type_;
  bool saidWaiting_ = false;
  bool done_ = false;
  int exitCode_ = kDone;
  std::uint64_t shown_ = 0;
};

int Echo::run() {
  type_ = options_.type.empty() ? findType() : options_.type;
  if (type_.empty()) return exitCode_;

  const Subscription subscription =
      transport_.node().subscribe(options_.topic, type_, [this](const Message& message) { show(message); });
  signal_.onStop([this] { transport_.wake(); });
  while (!over()) {
    transport_.dispatchFor(wait());
    if (shown_ == 0 && typeIsWrong()) break;
  }
  signal_.onStop({});
  return exitCode_;
}

/// Waits for a publisher.
/// @return The type of its messages, or nothing where the echo is over before there is one that can be read.
std::string Echo::findType() {
  TopicInfo topic;
  while (topic.publishers.empty() && !over()) {
    topic = transport_.waitForTopic(options_.topic, true, wait());
    if (topic.publishers.empty()) sayWaiting();
  }
  if (topic.publishers.empty()) {
    if (end_ && Clock::now() >= *end_) {
      fail("no publisher on " + options_.topic, nearestTopic(options_.topic, transport_.discover(kDiscoveryTime)));
    }
    return {};
  }
  const std::string& type = topic.publishers.front().type;
  for (const TopicInfo::Endpoint& publisher : topic.publishers) {
    if (publisher.type == type) continue;
    fail(options_.topic + " has publishers of " + type + " and of " + publisher.type, "choose with -m TYPE");
    return {};
  }
  if (messageTypeName(type) == type) return type;
  fail(options_.topic + " has messages of the unknown type '" + type + "'");
  return {};
}

/// @return Whether all the topic's publishers have another type than the user asked for, after saying so.
bool Echo::typeIsWrong() {
  if (options_.type.empty()) return false;
  const TopicInfo topic = transport_.waitForTopic(options_.topic, true, std::chrono::nanoseconds::zero());
  const auto fits = [this](const TopicInfo::Endpoint& publisher) { return publisher.type == type_; };
  if (topic.publishers.empty()) {
    sayWaiting();
    return false;
  }
  if (std::any_of(topic.publishers.begin(), topic.publishers.end(), fits)) return false;
  fail("the publisher of " + options_.topic + " has " + topic.publishers.front().type + ", not " + type_);
  return true;
}

/// Once, and not at once.
void Echo::sayWaiting() {
  if (saidWaiting_ || Clock::now() - start_ < kPatience) return;
  saidWaiting_ = true;
  const std::string hint = nearestTopic(options_.topic, transport_.discover(kDiscoveryTime));
  say("waiting for a publisher on " + options_.topic + (hint.empty() ? "" : "\n  hint: " + hint));
}

void Echo::show(const Message& message) {
  if (done_) return;
  try {
    if (!print((options_.json ? messageJson(message) : messageText(message)) + "\n")) {
      done_ = true;
      exitCode_ = outputIsClosed() ? kDone : kFailed;
    }
  } catch (const std::exception& error) {
    fail(error.what());
  }
  if (++shown_ == options_.count) done_ = true;
}

int Echo::fail(const std::string& message, const std::string& hint) {
  done_ = true;
  return exitCode_ = cli::fail(message, hint);
}

}  // namespace

int echoTopic(const EchoOptions& options) { return Echo(options).run(); }

}  // namespace pongsim::cli
