#include "ign/incoming_topic.hh"

#include <exception>
#include <utility>

#include "ign/names.hh"

namespace pongsim::ign {

namespace {

// Limits for memory: a peer can publish messages of any number of types.
constexpr std::size_t kMostTypes = 64;
constexpr std::size_t kMostEarly = 64;

const PublisherOptions kRelays{.relays = true, .ownOnly = true};

}  // namespace

IncomingTopic::IncomingTopic(std::string topic, const Logger& log, std::function<void()> wake)
    : name(std::move(topic)), log_(log), wake_(std::move(wake)) {}

void IncomingTopic::subscribe() {
  // a weak pointer, because a thread of the library may still call this after the unsubscription
  node_.SubscribeRaw(name, [topic = weak_from_this()](const char* data, std::size_t size,
                                                      const ignition::transport::MessageInfo& info) {
    if (const auto self = topic.lock()) {
      self->receive(ownType(info.Type()), std::as_bytes(std::span(data, size)));
    }
  });
}

void IncomingTopic::unsubscribe() { node_.Unsubscribe(name); }

void IncomingTopic::listenTo(Node& simulation, const std::set<std::string>& types, bool takesAny) {
  const std::lock_guard lock(mutex_);
  takesAny_ = takesAny;
  if (!takesAny) std::erase_if(publishers_, [&types](const auto& each) { return !types.contains(each.first); });
  for (const std::string& type : types) open(simulation, type);
}

void IncomingTopic::openNewTypes(Node& simulation) {
  const std::lock_guard lock(mutex_);
  for (const Early& early : early_) {
    open(simulation, early.type);
    if (const auto found = publishers_.find(early.type); found != publishers_.end()) {
      found->second.publishBytes(early.bytes);
    }
  }
  early_.clear();
}

void IncomingTopic::end() {
  const std::lock_guard lock(mutex_);
  hasEnded_ = true;
  publishers_.clear();
  early_.clear();
}

/// The mutex must be held by the caller.
void IncomingTopic::open(Node& simulation, const std::string& type) {
  if (publishers_.contains(type)) return;
  try {
    publishers_.emplace(type, simulation.advertiseBytes(name, type, kRelays));
  } catch (const std::exception& error) {
    if (refused_.insert(type).second)
      log_.warning("topic '" + name + "' is not received from ign-transport: " + error.what());
  }
}

void IncomingTopic::receive(const std::string& type, std::span<const std::byte> bytes) {
  const std::lock_guard lock(mutex_);
  if (hasEnded_) return;
  if (const auto found = publishers_.find(type); found != publishers_.end()) {
    found->second.publishBytes(bytes);
    return;
  }
  if (takesAny_ && early_.size() < kMostEarly && publishers_.size() < kMostTypes) {
    early_.push_back({type, {bytes.begin(), bytes.end()}});
    wake_();
    return;
  }
  if (refused_.size() >= kMostTypes || !refused_.insert(type).second) return;
  log_.warning("topic '" + name + "': messages of " + type +
               " arrived by ign-transport without a subscriber of that type" +
               (publishers_.empty() ? "" : "; the world takes " + publishers_.begin()->first));
}

}  // namespace pongsim::ign
