#include "web/world/world_link.hh"

#include <google/protobuf/message.h>

#include <utility>

#include "web/world/world_side.hh"

namespace pongsim::web {

namespace {

// Limits of requests queued for a world with long steps.
constexpr std::size_t kMostWishes = 4096;
constexpr std::size_t kMostBytes = std::size_t{32} << 20;

}  // namespace

/// Represents a publisher in the world as long as it exists.
class WorldLink::SpokenTopic final : public Voice {
 public:
  SpokenTopic(std::shared_ptr<WorldLink> link, std::uint64_t number) : link_(std::move(link)), number_(number) {}
  SpokenTopic(const SpokenTopic&) = delete;
  SpokenTopic& operator=(const SpokenTopic&) = delete;
  // never refused, however much is queued: otherwise the publisher would exist forever
  ~SpokenTopic() override {
    link_->post(0, [number = number_](WorldSide& side) { side.close(number); });
  }

  bool publish(Payload message) override {
    const std::size_t size = message.size() + 1;
    return link_->post(size, [number = number_, message = std::move(message)](WorldSide& side) {
      side.publish(number, message.bytes());
    });
  }

 private:
  std::shared_ptr<WorldLink> link_;
  std::uint64_t number_;
};

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

std::shared_ptr<void> WorldLink::hear(const std::string& topic, const std::string& type, Listener listener) {
  const auto shared = std::make_shared<const Listener>(std::move(listener));
  const std::pair key(topic, type);
  std::shared_ptr<HeardTopic> heard;
  {
    const std::lock_guard lock(mutex_);
    Heard& place = heard_[key];
    if (!place.topic) place.topic = std::make_shared<HeardTopic>(topic, type);
    ++place.ears;
    heard = place.topic;
  }
  heard->add(shared);
  haveEarsChanged_.store(true, std::memory_order_release);
  changed();
  return {heard.get(), [link = shared_from_this(), key, heard, shared](void*) {
            heard->remove(*shared);
            link->heardNoMore(key);
          }};
}

void WorldLink::heardNoMore(const std::pair<std::string, std::string>& key) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = heard_.find(key);
    if (found != heard_.end() && --found->second.ears == 0) heard_.erase(found);
  }
  haveEarsChanged_.store(true, std::memory_order_release);
  changed();
}

std::shared_ptr<WorldLink::Voice> WorldLink::speak(const std::string& topic, const std::string& type) {
  const std::uint64_t number = nextVoice_++;
  if (!post(1, [=](WorldSide& side) { side.open(number, topic, type); })) return nullptr;
  return std::make_shared<SpokenTopic>(shared_from_this(), number);
}

void WorldLink::request(const OwnService& service, std::shared_ptr<const Message> request, Answered answered) {
  if (post(request->SpaceUsedLong() + 1,
           [service, request, answered](WorldSide& side) { side.request(service, *request, answered); }))
    return;
  answered({CallOutcome::kNoAnswer, "too many messages wait for the world '" + world_ + "', or it has ended"},
           *newMessage("Empty"));
}

/// @param bytes Size of its data; 0 for wishes that must not be refused.
bool WorldLink::post(std::size_t bytes, Wish wish) {
  {
    const std::lock_guard lock(mutex_);
    if (!wake_) return false;
    if (bytes > 0 && (wishes_.size() >= kMostWishes || wishBytes_ + bytes > kMostBytes)) return false;
    wishes_.push_back(std::move(wish));
    wishBytes_ += bytes;
  }
  changed();
  return true;
}

void WorldLink::changed() {
  hasWork_.store(true, std::memory_order_release);
  const std::lock_guard lock(mutex_);
  if (wake_) wake_();
}

std::vector<WorldLink::Wish> WorldLink::takeWishes() {
  const std::lock_guard lock(mutex_);
  wishBytes_ = 0;
  return std::exchange(wishes_, {});
}

/// @return The topics with listeners.
std::vector<std::shared_ptr<HeardTopic>> WorldLink::heardTopics() {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<HeardTopic>> topics;
  for (const auto& [key, heard] : heard_) topics.push_back(heard.topic);
  return topics;
}

void WorldLink::setLists(std::shared_ptr<const Lists> lists) {
  const std::lock_guard lock(mutex_);
  lists_ = std::move(lists);
}

std::vector<WorldLink::Wish> WorldLink::end() {
  const std::lock_guard lock(mutex_);
  wake_ = nullptr;
  lists_ = std::make_shared<const Lists>();
  settings_.reset();
  heard_.clear();
  return std::exchange(wishes_, {});
}

}  // namespace pongsim::web
