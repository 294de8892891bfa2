#include "ign/courier.hh"

#include <chrono>
#include <string>
#include <utility>

namespace pongsim::ign {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostParcels = 10'000;
constexpr std::size_t kMostBytes = 64 << 20;
// Limit of all payloads that exist, including those in ZeroMQ's queues for stopped subscribers [bytes].
constexpr std::size_t kMostHeld = 512 << 20;
// Interval of checks for new subscribers.
constexpr std::chrono::milliseconds kLookPeriod{20};
// Least interval of answers to requests for the list of subscribers: anybody can send many.
constexpr std::chrono::milliseconds kAnswerPeriod{100};

}  // namespace

Courier::Courier(const Logger& log, const std::string& address, std::function<void()> heardChanged,
                 std::function<void()> subscribersAsked)
    : log_(log),
      heardChanged_(std::move(heardChanged)),
      subscribersAsked_(std::move(subscribersAsked)),
      heartbeats_(address),
      thread_([this] { work(); }) {}

Courier::~Courier() {
  {
    const std::lock_guard lock(mutex_);
    mustEnd_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Courier::post(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  changed_.notify_one();
}

void Courier::open(std::shared_ptr<OutgoingTopic> topic) {
  post([this, topic = std::move(topic)] {
    if (topic->advertise()) topics_.push_back(topic);
  });
}

void Courier::close(std::shared_ptr<OutgoingTopic> topic) {
  post([this, topic = std::move(topic)] {
    std::erase(topics_, topic);
    topic->unadvertise();
  });
}

void Courier::send(const std::shared_ptr<OutgoingTopic>& topic, Payload payload) {
  std::deque<Parcel> tooMany;
  bool mustWake = false;
  {
    const std::lock_guard lock(mutex_);
    waitingBytes_ += payload.size();
    while (!parcels_.empty() && (parcels_.size() >= kMostParcels || waitingBytes_ > kMostBytes)) {
      waitingBytes_ -= parcels_.front().payload.size();
      tooMany.push_back(std::move(parcels_.front()));
      parcels_.pop_front();
    }
    parcels_.push_back({topic, std::move(payload)});
    mustWake = std::exchange(isWaiting_, false);
  }
  if (mustWake) changed_.notify_one();
  for (const Parcel& parcel : tooMany) drop(parcel);
}

void Courier::work() {
  std::deque<Parcel> parcels;
  std::deque<std::function<void()>> tasks;
  Clock::time_point nextLook = Clock::now();
  while (true) {
    bool isLast = false;
    {
      std::unique_lock lock(mutex_);
      isWaiting_ = true;
      changed_.wait_until(lock, nextLook, [this] { return mustEnd_ || !tasks_.empty() || !parcels_.empty(); });
      isWaiting_ = false;
      isLast = mustEnd_;
      tasks.swap(tasks_);
      parcels.swap(parcels_);
      waitingBytes_ = 0;
    }
    // messages first, because a task may close their topic
    deliver(parcels);
    for (const std::function<void()>& task : tasks) task();
    tasks.clear();
    if (isLast) return;
    if (Clock::now() < nextLook) continue;
    look();
    nextLook = Clock::now() + kLookPeriod;
  }
}

void Courier::deliver(std::deque<Parcel>& parcels) {
  for (Parcel& parcel : parcels) {
    if (Payload::total() > kMostHeld) {
      drop(parcel);
    } else if (parcel.topic->isHeard) {
      parcel.topic->send(std::move(parcel.payload));
    }
  }
  parcels.clear();
}

void Courier::drop(const Parcel& parcel) {
  const std::uint64_t count = ++dropped_;
  {
    const std::lock_guard lock(mutex_);
    const std::int64_t now = Clock::now().time_since_epoch() / std::chrono::seconds(1);
    if (now < nextWarning_) return;
    nextWarning_ = now + 1;
  }
  log_.warning("topic '" + parcel.topic->name + "': a message was dropped, " + std::to_string(count) +
               " so far: ign-transport subscribers are too slow or stopped");
}

void Courier::look() {
  heartbeats_.read();
  bool hasChanged = false;
  for (const auto& topic : topics_) hasChanged = topic->look(heartbeats_) || hasChanged;
  if (hasChanged) heardChanged_();
  if (Clock::now() < nextAnswer_ || !heartbeats_.takeRequest()) return;
  nextAnswer_ = Clock::now() + kAnswerPeriod;
  subscribersAsked_();
}

}  // namespace pongsim::ign
