#include "web/world/heard_topic.hh"

#include <algorithm>
#include <utility>

namespace pongsim::web {

HeardTopic::HeardTopic(std::string topic, std::string messageType)
    : name(std::move(topic)), type(std::move(messageType)) {}

void HeardTopic::add(std::shared_ptr<const Listener> listener) {
  const std::lock_guard lock(mutex_);
  if (last_) listener->heard(last_->message, last_->timeNs);
  ears_.push_back({std::move(listener)});
}

void HeardTopic::remove(const Listener& listener) {
  const std::lock_guard lock(mutex_);
  std::erase_if(ears_, [&](const Ear& each) { return each.listener.get() == &listener; });
  // a later subscription receives the latched message again
  if (ears_.empty()) last_.reset();
}

void HeardTopic::keepLast(bool keeps) {
  const std::lock_guard lock(mutex_);
  keepsLast_ = keeps;
  if (!keeps) last_.reset();
}

void HeardTopic::heard(std::size_t size, const std::function<void(std::span<std::byte>)>& write, std::uint64_t timeNs) {
  const std::lock_guard lock(mutex_);
  bool isWanted = false;
  for (Ear& ear : ears_) {
    ear.wants = !ear.listener->wants || ear.listener->wants();
    isWanted = isWanted || ear.wants;
  }
  if (!isWanted && (!keepsLast_ || ears_.empty())) return;
  Payload message(size);
  write(message.bytes());
  for (const Ear& ear : ears_) {
    if (ear.wants) ear.listener->heard(message, timeNs);
  }
  if (keepsLast_) last_ = Last{std::move(message), timeNs};
}

}  // namespace pongsim::web
