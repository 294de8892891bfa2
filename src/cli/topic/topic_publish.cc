#include <algorithm>
#include <chrono>
#include <iterator>
#include <vector>

#include "cli/look_around.hh"
#include "cli/stop_signal.hh"
#include "cli/topic/topic_command.hh"
#include "cli/topic/topic_name.hh"
#include "pongsim/node.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

// A subscriber on a busy machine may take so long to confirm.
constexpr std::chrono::seconds kDeliveryTime{5};

/// @return The exit code, after reporting why none of those who are there is listening.
int failWithoutSubscriber(const std::vector<TopicInfo>& topics, const PublishOptions& options) {
  for (const TopicInfo& topic : topics) {
    if (topic.name != options.topic || topic.subscribers.empty()) continue;
    const std::string& theirs = topic.subscribers.front().type;
    // a subscriber to any type ("*") has not discovered this publisher in time
    if (theirs == options.type || theirs == "*") break;
    return fail("the subscriber of " + options.topic + " takes " + theirs + ", not " + options.type);
  }
  std::vector<TopicInfo> heard;
  std::copy_if(topics.begin(), topics.end(), std::back_inserter(heard),
               [](const TopicInfo& topic) { return !topic.subscribers.empty(); });
  return fail("no subscriber on " + options.topic, nearestTopic(options.topic, heard));
}

/// @return Whether one appears before the timeout or a signal.
bool waitForSubscribers(const Publisher& publisher, std::chrono::nanoseconds timeout, const StopSignal& signal) {
  using Steady = std::chrono::steady_clock;
  constexpr std::chrono::nanoseconds kLongestPause = std::chrono::milliseconds(100);
  const Steady::time_point end = Steady::now() + timeout;
  do {
    const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(end - Steady::now());
    if (publisher.waitForSubscribers(std::clamp(left, std::chrono::nanoseconds::zero(), kLongestPause))) return true;
  } while (Steady::now() < end && !signal.stopped());
  return false;
}

/// @return Whether one of those who are there listens, whether or not there is a way to it yet.
bool hasSubscriber(const std::vector<TopicInfo>& topics, const PublishOptions& options) {
  return std::ranges::any_of(topics, [&](const TopicInfo& topic) {
    return topic.name == options.topic &&
           std::ranges::count(topic.subscribers, options.type, &TopicInfo::Endpoint::type) > 0;
  });
}

/// Publishes, and waits for the period after each message but the last.
/// @return Whether it reached the end without a signal.
bool publishAll(Transport& transport, Publisher& publisher, const PublishOptions& options, StopSignal& signal) {
  using Steady = std::chrono::steady_clock;
  Steady::time_point next = Steady::now();
  for (std::uint64_t sent = 1;; ++sent) {
    publisher.publish(*options.message);
    if (!options.period || sent == options.count) return true;
    // counted from the due time, so that a late message does not delay the next one
    next += std::chrono::duration_cast<Steady::duration>(*options.period);
    for (auto now = Steady::now(); now < next && !signal.stopped(); now = Steady::now()) {
      transport.dispatchFor(next - now);
    }
    if (signal.stopped()) return false;
  }
}

}  // namespace

int publish(const PublishOptions& options) {
  // before the transport, whose threads inherit the signal mask
  StopSignal signal;
  Transport transport;
  Publisher publisher = transport.node().advertise(options.topic, options.type);
  if (!waitForSubscribers(publisher, options.timeout, signal)) {
    if (signal.stopped()) return kFailed;
    // on a busy machine, who is there may not have told so by then
    const std::vector<TopicInfo> topics = topicsAround(transport);
    const bool isThere = publisher.hasSubscribers() || hasSubscriber(topics, options);
    if (!isThere || !waitForSubscribers(publisher, kDiscoveryTime, signal)) {
      return signal.stopped() ? kFailed : failWithoutSubscriber(topics, options);
    }
  }
  const StopSignal::Callback wake(signal, [&transport] { transport.wake(); });
  const bool isAll = publishAll(transport, publisher, options, signal);
  if (!isAll || publisher.waitForDelivery(std::max<std::chrono::nanoseconds>(options.timeout, kDeliveryTime))) {
    return kDone;
  }
  return fail("no subscriber on " + options.topic + " confirmed the message in time");
}

}  // namespace pongsim::cli
