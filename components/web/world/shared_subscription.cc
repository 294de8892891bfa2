#include "web/world/shared_subscription.hh"

#include <algorithm>
#include <utility>

namespace pongsim::web {

SharedSubscription::SharedSubscription(std::string topic, std::string messageType)
    : name(std::move(topic)), type(std::move(messageType)) {}

void SharedSubscription::add(std::shared_ptr<const Listener> listener) {
  const std::lock_guard lock(mutex_);
  if (last_) listener->received(last_->message, last_->timeNs);
  subscribers_.push_back({std::move(listener)});
}

void SharedSubscription::remove(const Listener& listener) {
  const std::lock_guard lock(mutex_);
  std::erase_if(subscribers_, [&](const Subscriber& each) { return each.listener.get() == &listener; });
  // a later subscription receives the latched message again
  if (subscribers_.empty()) last_.reset();
}

void SharedSubscription::keepLast(bool keeps) {
  const std::lock_guard lock(mutex_);
  keepsLast_ = keeps;
  if (!keeps) last_.reset();
}

void SharedSubscription::receive(std::size_t size, const std::function<void(std::span<std::byte>)>& write,
                                 std::uint64_t timeNs) {
  const std::lock_guard lock(mutex_);
  bool isWanted = false;
  for (Subscriber& each : subscribers_) {
    each.wants = !each.listener->wants || each.listener->wants();
    isWanted = isWanted || each.wants;
  }
  if (!isWanted && (!keepsLast_ || subscribers_.empty())) return;
  Payload message(size);
  write(message.bytes());
  for (const Subscriber& each : subscribers_) {
    if (each.wants) each.listener->received(message, timeNs);
  }
  if (keepsLast_) last_ = Last{std::move(message), timeNs};
}

}  // namespace pongsim::web
