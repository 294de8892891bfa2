#include "ign/bridge.hh"

#include <algorithm>
#include <set>
#include <span>
#include <vector>

#include "ign/names.hh"
#include "ign/replies.hh"

namespace pongsim::ign {

namespace {

constexpr std::string_view kAnyType = "*";

}  // namespace

Bridge::Bridge(const Node& simulation, const Logger& log, const std::string& address, Generation generation)
    : simulation_(simulation),
      log_(log),
      generation_(generation),
      topicsVersion_(simulation_.ownTopicsVersion() - 1),
      servicesVersion_(simulation_.ownServicesVersion() - 1),
      subscribers_(address),
      courier_(
          log, address,
          [this] {
            haveReadersChanged_ = true;
            simulation_.wake();
          },
          [this] {
            areSubscribersAsked_ = true;
            simulation_.wake();
          }),
      calls_(generation),
      gateway_(simulation_.openGateway(
          [this](const std::string& service, const Message& request, Message& reply, std::chrono::nanoseconds timeout) {
            return calls_.call(service, request, reply, timeout);
          })) {
  courier_.post([this] { offers_ = std::make_unique<Services>(); });
}

Bridge::~Bridge() {
  calls_.end();
  gateway_ = {};
  for (auto& [key, out] : outgoing_) {
    out.heard = {};
    courier_.close(std::move(out.topic));
  }
  for (auto& [name, topic] : incoming_) {
    topic->end();
    courier_.post([topic = std::move(topic)] { topic->unsubscribe(); });
  }
  for (const auto& [name, service] : services_) endService(service);
  awaitReplies();
}

void Bridge::update() {
  if (const std::uint64_t version = simulation_.ownTopicsVersion(); version != topicsVersion_) {
    topicsVersion_ = version;
    followTopics();
  }
  if (const std::uint64_t version = simulation_.ownServicesVersion(); version != servicesVersion_) {
    servicesVersion_ = version;
    followServices();
  }
  if (areSubscribersAsked_.load(std::memory_order_relaxed) && areSubscribersAsked_.exchange(false)) listSubscriptions();
  if (haveReadersChanged_.load(std::memory_order_relaxed) && haveReadersChanged_.exchange(false)) followReaders();
  if (haveTypesCome_.load(std::memory_order_relaxed) && haveTypesCome_.exchange(false)) {
    for (const auto& [name, topic] : incoming_) topic->openNewTypes(simulation_);
  }
}

void Bridge::followTopics() {
  const std::vector<OwnTopic> topics = simulation_.ownTopics();
  followOutgoing(topics);
  followIncoming(topics);
}

void Bridge::followOutgoing(const std::vector<OwnTopic>& topics) {
  std::set<std::pair<std::string, std::string>> there;
  for (const OwnTopic& topic : topics) {
    if (topic.publishers > 0) there.emplace(topic.name, topic.type);
  }
  for (auto each = outgoing_.begin(); each != outgoing_.end();) {
    const auto current = each++;
    if (there.contains(current->first)) continue;
    current->second.heard = {};
    courier_.close(std::move(current->second.topic));
    outgoing_.erase(current);
  }
  for (const auto& key : there) {
    Out& out = outgoing_[key];
    if (out.topic) continue;
    out.topic = std::make_shared<OutgoingTopic>(key.first, wireType(key.second, generation_));
    courier_.open(out.topic);
  }
}

void Bridge::followIncoming(const std::vector<OwnTopic>& topics) {
  std::map<std::string, std::set<std::string>> there;
  for (const OwnTopic& topic : topics) {
    if (topic.subscriptions > 0) there[topic.name].insert(topic.type);
  }
  subscriptions_.clear();
  for (const auto& [name, types] : there) {
    for (const std::string& type : types) {
      subscriptions_.emplace_back(
          name, type == kAnyType ? ignition::transport::kGenericMessageType : wireType(type, generation_));
    }
  }
  for (auto each = incoming_.begin(); each != incoming_.end();) {
    const auto current = each++;
    if (there.contains(current->first)) continue;
    current->second->end();
    courier_.post([topic = std::move(current->second)] { topic->unsubscribe(); });
    incoming_.erase(current);
  }
  for (auto& [name, types] : there) {
    const bool takesAny = types.erase(std::string(kAnyType)) > 0;
    std::shared_ptr<IncomingTopic>& topic = incoming_[name];
    const bool isNew = !topic;
    if (isNew) {
      topic = std::make_shared<IncomingTopic>(name, log_, [this] {
        haveTypesCome_ = true;
        simulation_.wake();
      });
    }
    topic->listenTo(simulation_, types, takesAny);
    if (isNew) courier_.post([topic] { topic->subscribe(); });
  }
}

void Bridge::followReaders() {
  for (auto& [key, out] : outgoing_) {
    const bool isHeard = out.topic->isHeard;
    if (!isHeard) out.heard = {};
    if (!isHeard || out.heard) continue;
    out.heard = simulation_.subscribeBytesAtOnce(
        key.first, key.second,
        [this, topic = out.topic](std::size_t size, const std::function<void(std::span<std::byte>)>& write) {
          Payload payload(size);
          write(payload.bytes());
          courier_.send(topic, std::move(payload));
        },
        {.relays = true, .ownOnly = true});
  }
}

void Bridge::followServices() {
  const std::vector<OwnService> offered = simulation_.ownServices();
  std::erase_if(services_, [&](const auto& each) {
    if (std::ranges::find(offered, each.second->service()) != offered.end()) return false;
    endService(each.second);
    return true;
  });
  for (const OwnService& service : offered) {
    std::shared_ptr<OfferedService>& place = services_[service.name];
    if (place) continue;
    place = std::make_shared<OfferedService>(simulation_, service, generation_);
    courier_.post([this, offer = place] { offers_->advertise(offer); });
  }
}

/// Fortress's server does not answer, and its clients do not ask.
void Bridge::listSubscriptions() {
  if (generation_ != Generation::kGz) return;
  courier_.post([this, subscriptions = subscriptions_] { subscribers_.send(subscriptions); });
}

void Bridge::endService(const std::shared_ptr<OfferedService>& service) {
  service->end();
  courier_.post([this, service] { offers_->unadvertise(*service); });
}

}  // namespace pongsim::ign
