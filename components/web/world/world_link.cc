#include "web/world/world_link.hh"

#include <google/protobuf/message.h>

#include <utility>

#include "web/world/client_endpoints.hh"

namespace pongsim::web {

namespace {

// Limits of requests queued for a world with long steps.
constexpr std::size_t kMostTasks = 4096;
constexpr std::size_t kMostBytes = std::size_t{32} << 20;

}  // namespace

RemotePublisher::~RemotePublisher() {
  // 0 bytes: never refused, because the publisher would stay open until the world ends
  link_->post(0, [number = number_](ClientEndpoints& endpoints) { endpoints.close(number); });
}

bool RemotePublisher::publish(Payload message) {
  const std::size_t size = message.size() + 1;
  return link_->post(size, [number = number_, message = std::move(message)](ClientEndpoints& endpoints) {
    endpoints.publish(number, message.bytes());
  });
}

WorldLink::WorldLink(std::string world, std::function<void()> wake)
    : world_(std::move(world)), wake_(std::move(wake)) {}

std::shared_ptr<const Lists> WorldLink::lists() const {
  const std::lock_guard lock(mutex_);
  return lists_;
}

std::optional<WorldSettings> WorldLink::settings() const {
  const std::lock_guard lock(mutex_);
  return settings_;
}

void WorldLink::setSettings(const WorldSettings& settings) {
  const std::lock_guard lock(mutex_);
  settings_ = settings;
}

std::shared_ptr<void> WorldLink::subscribe(const std::string& topic, const std::string& type, Listener listener) {
  const auto shared = std::make_shared<const Listener>(std::move(listener));
  const std::pair key(topic, type);
  std::shared_ptr<SharedSubscription> subscription;
  {
    const std::lock_guard lock(mutex_);
    Counted& counted = subscriptions_[key];
    if (!counted.subscription) counted.subscription = std::make_shared<SharedSubscription>(topic, type);
    ++counted.listeners;
    subscription = counted.subscription;
  }
  subscription->add(shared);
  haveSubscriptionsChanged_.store(true, std::memory_order_release);
  changed();
  return {subscription.get(), [link = shared_from_this(), key, subscription, shared](void*) {
            subscription->remove(*shared);
            link->unsubscribe(key);
          }};
}

void WorldLink::unsubscribe(const std::pair<std::string, std::string>& key) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = subscriptions_.find(key);
    if (found != subscriptions_.end() && --found->second.listeners == 0) subscriptions_.erase(found);
  }
  haveSubscriptionsChanged_.store(true, std::memory_order_release);
  changed();
}

std::unique_ptr<RemotePublisher> WorldLink::advertise(const std::string& topic, const std::string& type) {
  const std::uint64_t number = nextPublisher_++;
  if (!post(1, [=](ClientEndpoints& endpoints) { endpoints.open(number, topic, type); })) return nullptr;
  return std::make_unique<RemotePublisher>(shared_from_this(), number);
}

void WorldLink::request(const OwnService& service, std::shared_ptr<const Message> request, Answered answered) {
  if (post(request->SpaceUsedLong() + 1, [service, request, answered](ClientEndpoints& endpoints) {
        endpoints.request(service, *request, answered);
      }))
    return;
  answered({CallOutcome::kNoAnswer, "too many messages wait for the world '" + world_ + "', or it has ended"},
           *newMessage("Empty"));
}

/// @param bytes Size of its data; 0 for a task that must not be refused.
bool WorldLink::post(std::size_t bytes, Task task) {
  {
    const std::lock_guard lock(mutex_);
    if (!wake_) return false;
    if (bytes > 0 && (tasks_.size() >= kMostTasks || taskBytes_ + bytes > kMostBytes)) return false;
    tasks_.push_back(std::move(task));
    taskBytes_ += bytes;
  }
  changed();
  return true;
}

void WorldLink::changed() {
  hasWork_.store(true, std::memory_order_release);
  const std::lock_guard lock(mutex_);
  if (wake_) wake_();
}

std::vector<WorldLink::Task> WorldLink::takeTasks() {
  const std::lock_guard lock(mutex_);
  taskBytes_ = 0;
  return std::exchange(tasks_, {});
}

/// @return Those with listeners.
std::vector<std::shared_ptr<SharedSubscription>> WorldLink::subscriptions() {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<SharedSubscription>> all;
  for (const auto& [key, counted] : subscriptions_) all.push_back(counted.subscription);
  return all;
}

void WorldLink::setLists(std::shared_ptr<const Lists> lists) {
  const std::lock_guard lock(mutex_);
  lists_ = std::move(lists);
}

std::vector<WorldLink::Task> WorldLink::end() {
  const std::lock_guard lock(mutex_);
  wake_ = nullptr;
  lists_ = std::make_shared<const Lists>();
  settings_.reset();
  subscriptions_.clear();
  return std::exchange(tasks_, {});
}

}  // namespace pongsim::web
