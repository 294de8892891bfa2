#include "log/command/recording.hh"

#include <algorithm>
#include <utility>

#include "pongsim/program/keystore.hh"
#include "shared/program/console.hh"

namespace pongsim::log {

namespace {

constexpr std::chrono::milliseconds kDiscoveryInterval{200};
/// Maximum duration of a discovery: a process that is stopped does not answer.
constexpr std::chrono::milliseconds kDiscoveryTime{300};
// in addition to the limit of 64 MiB per topic
constexpr std::size_t kQueueLength = 20'000;

}  // namespace

Recording::Recording(Transport& transport, Writer& writer, const TopicChoice& choice, CanWrite canWrite)
    : transport_(transport), writer_(writer), choice_(choice), canWrite_(std::move(canWrite)) {
  for (const std::string& topic : choice_.names()) subscribe(topic);
}

void Recording::goOn() {
  const Clock::time_point now = Clock::now();
  if (now >= nextDiscovery_) {
    discover();
    nextDiscovery_ = Clock::now() + kDiscoveryInterval;
  }
  transport_.dispatchFor(std::max<Clock::duration>(nextDiscovery_ - now, std::chrono::milliseconds(1)));
  if (failure_ != nullptr) std::rethrow_exception(failure_);
}

void Recording::discover() {
  for (const TopicInfo& topic : transport_.discover(kDiscoveryTime)) {
    if (!choice_.has(topic.name) || !isUseful(topic) || refused_.contains(topic.name)) continue;
    try {
      subscribe(topic.name);
    } catch (const KeystoreError& error) {
      // it was not requested by name
      refused_.insert(topic.name);
      cli::say(std::string(error.what()) + "; it is not recorded");
    }
  }
}

bool Recording::isUseful(const TopicInfo& topic) const {
  return std::ranges::any_of(topic.publishers, [&](const TopicInfo::Endpoint& publisher) {
    return !canWrite_ || canWrite_(topic.name, publisher.type);
  });
}

void Recording::subscribe(const std::string& topic) {
  if (subscriptions_.contains(topic)) return;
  subscriptions_[topic] = transport_.node().subscribeAnyType(
      topic, [this, topic](std::string_view type, std::span<const std::byte> bytes) { take(topic, type, bytes); },
      {.queueLength = kQueueLength});
}

void Recording::take(const std::string& topic, std::string_view type, std::span<const std::byte> bytes) {
  if (failure_ != nullptr) return;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  try {
    writer_.write({std::chrono::duration_cast<std::chrono::nanoseconds>(now).count(), topic, type,
                   std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())});
    ++messages_;
    receivedTopics_.insert(topic);
  } catch (...) {
    // exceptions must not pass through the caller, which is the transport
    failure_ = std::current_exception();
  }
}

std::map<std::string, std::uint64_t> Recording::lost() const {
  std::map<std::string, std::uint64_t> lost;
  for (const auto& [topic, subscription] : subscriptions_) {
    if (subscription.dropped() > 0) lost[topic] = subscription.dropped();
  }
  return lost;
}

}  // namespace pongsim::log
