#include "cli/topic/topic_reader.hh"

#include <algorithm>
#include <vector>

#include "cli/look_around.hh"
#include "cli/topic/topic_command.hh"
#include "cli/topic/topic_name.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

/// Maximum length of a wait before other things are checked.
constexpr std::chrono::milliseconds kLongestWait{100};
/// After this time the user is told that nothing has arrived.
constexpr std::chrono::seconds kPatience{1};

}  // namespace

TopicReader::TopicReader(const ReadOptions& options) : options_(options), type_(options.type) {
  if (options.duration) end_ = start_ + *options.duration;
}

int TopicReader::run(TopicTask& task) {
  if (type_.empty()) findType();
  if (!exitCode_ && !type_.empty()) {
    exitCode_ = task.begin(type_);
    if (!exitCode_) read(task);
  }
  return exitCode_ ? *exitCode_ : task.end(isTimeOver());
}

bool TopicReader::isOver() const {
  return exitCode_ || signal_.stopped() || isTimeOver() || outputIsClosed() || taken_ == options_.count;
}

TopicReader::Clock::duration TopicReader::wait() const {
  if (!end_) return kLongestWait;
  return std::clamp<Clock::duration>(*end_ - Clock::now(), Clock::duration::zero(), kLongestWait);
}

void TopicReader::read(TopicTask& task) {
  const auto take = [&](const Message& message) {
    if (exitCode_ || taken_ == options_.count) return;
    ++taken_;
    exitCode_ = task.take(message);
  };
  const Subscription subscription = transport_.node().subscribe(options_.topic, type_, take);
  const StopSignal::Callback wake(signal_, [this] { transport_.wake(); });
  while (!isOver()) {
    transport_.dispatchFor(wait());
    if (taken_ == 0) refuseWrongType();
    if (!exitCode_) exitCode_ = task.tick();
  }
}

/// Waits for a publisher, and sets `type_` to the type of its messages.
void TopicReader::findType() {
  TopicInfo topic;
  while (topic.publishers.empty() && !isOver()) {
    topic = transport_.waitForTopic(options_.topic, true, wait());
    if (topic.publishers.empty()) sayWaiting();
  }
  if (topic.publishers.empty()) {
    if (!isTimeOver()) return;
    return fail("no publisher on " + options_.topic, nearestTopic(options_.topic, topicsAround(transport_)));
  }
  const std::string& type = topic.publishers.front().type;
  for (const TopicInfo::Endpoint& publisher : topic.publishers) {
    if (publisher.type == type) continue;
    return fail(options_.topic + " has publishers of " + type + " and of " + publisher.type, "choose with -m TYPE");
  }
  if (messageTypeName(type) != type) {
    return fail(options_.topic + " has messages of the unknown type '" + type + "'");
  }
  type_ = type;
}

/// Fails if all publishers of the topic have a type other than the requested one.
void TopicReader::refuseWrongType() {
  if (options_.type.empty()) return;
  const TopicInfo topic = transport_.waitForTopic(options_.topic, true, std::chrono::nanoseconds::zero());
  if (topic.publishers.empty()) return sayWaiting();
  const auto fits = [this](const TopicInfo::Endpoint& publisher) { return publisher.type == type_; };
  if (std::any_of(topic.publishers.begin(), topic.publishers.end(), fits)) return;
  fail("the publisher of " + options_.topic + " has " + topic.publishers.front().type + ", not " + type_);
}

/// Once, and after a while.
void TopicReader::sayWaiting() {
  if (saidWaiting_ || Clock::now() - start_ < kPatience) return;
  saidWaiting_ = true;
  const std::string hint = nearestTopic(options_.topic, topicsAround(transport_));
  say("waiting for a publisher on " + options_.topic + (hint.empty() ? "" : "\n  hint: " + hint));
}

void TopicReader::fail(const std::string& message, const std::string& hint) { exitCode_ = cli::fail(message, hint); }

}  // namespace pongsim::cli
