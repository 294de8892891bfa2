#include "transport/gate.hh"

#include <algorithm>
#include <utility>

#include "transport/bus.hh"
#include "transport/deadline.hh"
#include "transport/dispatch_queue.hh"
#include "transport/names/topic_name.hh"

namespace pongsim::transport {

Gate::Gate(Transport& transport, const std::vector<std::string>& topics)
    : bus_(*transport.bus_), queue_(*transport.queue_) {
  for (const std::string& topic : topics) topics_.push_back({absoluteTopic(topic), {}, 0});
  bus_.delivery().setGate(this);
  bus_.setRequestLimit(queue_, bus_.server().nextNumber());
  for (const std::string& topic : topics) {
    subscriptions_.push_back(transport.node().subscribeAnyType(topic, [](auto, auto) {}));
  }
}

Gate::~Gate() {
  bus_.delivery().setGate(nullptr);
  bus_.setRequestLimit(queue_, Inbox::kNoLimit);
  // what was held
  queue_.waiting = true;
}

bool Gate::isCompleteNow(Wanted wanted) const {
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    if (topics_[i].marks.size() < wanted[i]) return false;
  }
  return true;
}

bool Gate::isComplete(Wanted wanted) const {
  const WaitingLock lock(bus_.delivery().mutex);
  return isCompleteNow(wanted);
}

std::size_t Gate::waiting(std::size_t topic) const {
  const WaitingLock lock(bus_.delivery().mutex);
  return topics_[topic].marks.size();
}

Gate::Mark Gate::lastOf(Wanted wanted) const {
  if (!isCompleteNow(wanted)) return {bus_.delivery().nextArrival(), bus_.server().nextNumber()};
  Mark last{limit_, 0};
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    if (wanted[i] == 0) continue;
    const Mark& mark = topics_[i].marks[wanted[i] - 1];
    last = {std::max(last.end, mark.end), std::max(last.nextRequest, mark.nextRequest)};
  }
  return last;
}

bool Gate::wait(Wanted wanted, std::chrono::nanoseconds timeout) {
  WaitingLock lock(bus_.delivery().mutex);
  queue_.arrived.wait_until(lock, deadlineAfter(timeout), [&]() REQUIRES(waitingRole) {
    return queue_.woken || queue_.requestsWaiting || queue_.answersWaiting || !queue_.foundTypes.empty() ||
           isCompleteNow(wanted);
  });
  return std::exchange(queue_.woken, false);
}

std::size_t Gate::serve(Wanted wanted) {
  std::uint64_t limit = 0;
  {
    const WaitingLock lock(bus_.delivery().mutex);
    limit = lastOf(wanted).nextRequest;
  }
  return bus_.serve(queue_, limit);
}

void Gate::pass(Wanted wanted) {
  {
    const WaitingLock lock(bus_.delivery().mutex);
    limit_ = lastOf(wanted).end;
    for (std::size_t i = 0; i < topics_.size(); ++i) {
      Topic& topic = topics_[i];
      const std::size_t count = std::min<std::size_t>(wanted[i], topic.marks.size());
      if (count == 0) continue;
      topic.limit = topic.marks[count - 1].end;
      topic.marks.erase(topic.marks.begin(), topic.marks.begin() + static_cast<std::ptrdiff_t>(count));
    }
    queue_.waiting = true;
  }
  bus_.dispatch(queue_);
}

void Gate::setPaused(bool isPaused) {
  if (std::exchange(isPaused_, isPaused) == isPaused) return;
  bus_.setRequestLimit(queue_, isPaused ? Inbox::kNoLimit : bus_.server().nextNumber());
}

bool Gate::isHeard(std::string_view topic) const {
  return bus_.isHeardOutside(queue_, topic.empty() ? "" : absoluteTopic(topic));
}

std::string Gate::publishers(std::string_view topic) const {
  return bus_.publishersOutside(queue_, absoluteTopic(topic));
}

void Gate::arrived(const Channel& channel, std::uint64_t end) {
  const auto found = std::ranges::find(topics_, channel.topic, &Topic::name);
  if (found != topics_.end()) found->marks.push_back({end, bus_.server().nextNumber()});
}

std::uint64_t Gate::limitOf(const Channel& channel) const {
  const auto found = std::ranges::find(topics_, channel.topic, &Topic::name);
  return found != topics_.end() ? found->limit : limit_;
}

void Gate::forget() {
  for (Topic& topic : topics_) topic.marks.clear();
}

}  // namespace pongsim::transport
