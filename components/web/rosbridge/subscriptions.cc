#include "web/rosbridge/subscriptions.hh"

#include <algorithm>
#include <deque>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "pongsim/node.hh"
#include "web/foxglove/fields.hh"
#include "web/gz/rate.hh"
#include "web/world/queue_depth.hh"

namespace pongsim::web::rosbridge {

namespace {

using nlohmann::json;

constexpr std::size_t kMostTopics = 1000;
constexpr std::size_t kMostIds = 100;
constexpr std::size_t kLongestQueue = 1000;
constexpr double kMillisecond = 1e-3;

double numberField(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number() ? std::max(found->get<double>(), 0.0) : 0;
}

}  // namespace

/// One topic of the simulation that a client gets.
struct Subscriptions::Source {
  RosTopic topic;
  Form form = Form::kJson;
  std::uint64_t key = 0;
  std::size_t depth = 1;
  RosDefinition definition;
  /// Only used on the server's thread.
  std::unique_ptr<TopicEncoder> encoder;
  gz::Rate rate{std::numeric_limits<double>::infinity()};
  std::mutex mutex;
  /// Messages that wait until the client can take them.
  std::deque<Payload> waiting;

  /// Adds a message; of too many, the oldest is dropped.
  void add(const Payload& message) {
    const std::lock_guard lock(mutex);
    if (waiting.size() >= depth) waiting.pop_front();
    waiting.push_back(message);
  }

  /// Sends what waits, on the server's thread: JSON is text, which only `sendText` sends.
  void send(Client& client) {
    std::deque<Payload> messages;
    {
      const std::lock_guard lock(mutex);
      messages.swap(waiting);
    }
    for (const Payload& message : messages) send(client, message.bytes());
  }

 private:
  void send(Client& client, std::span<const std::byte> message) const {
    json publish = {{"op", "publish"}, {"topic", topic.name}};
    try {
      encoder->encode(message, [&](std::size_t index, std::span<const std::byte> payload) {
        if (index == topic.index) publish["msg"] = readCdr(definition, payload, form);
      });
    } catch (const std::runtime_error&) {
      // not a message of the topic's type, from another process
      return;
    }
    if (form == Form::kJson) return client.sendText(publish.dump(-1, ' ', false, json::error_handler_t::replace));
    const std::vector<std::uint8_t> bytes = json::to_cbor(publish);
    client.sendBinary({std::string(bytes.begin(), bytes.end()), {}});
  }
};

Subscriptions::Subscriptions(std::shared_ptr<Client> client, RosTopics& topics)
    : client_(std::move(client)), topics_(topics) {}

std::string Subscriptions::add(const json& request) {
  const auto name = foxglove::textField(request, "topic");
  if (!name) return "a subscription must have a topic";
  if (const auto error = topicNameError(*name)) return "the topic's name '" + *name + "' " + *error;
  if (const std::string& fault = topics_.fault(); !fault.empty()) return fault;
  const std::string compression = foxglove::textField(request, "compression").value_or("none");
  if (compression != "none" && compression != "cbor") {
    return "messages can have the compression 'none' or 'cbor', not '" + compression + "'";
  }
  if (!subscriptions_.contains(*name) && subscriptions_.size() >= kMostTopics) {
    return "a client can subscribe to at most " + std::to_string(kMostTopics) + " topics";
  }
  Wanted& wanted = subscriptions_[*name];
  const std::string id = foxglove::textField(request, "id").value_or("");
  if (!wanted.wishes.contains(id) && wanted.wishes.size() >= kMostIds)
    return "'" + *name + "' has too many subscriptions";
  wanted.wishes[id] = {
      numberField(request, "throttle_rate") * kMillisecond,
      static_cast<std::size_t>(std::min(numberField(request, "queue_length"), static_cast<double>(kLongestQueue))),
      compression == "cbor"};
  close(wanted);
  open(*name, wanted, topics_.all());
  const std::string type = fullRosType(foxglove::textField(request, "type").value_or(""));
  if (!type.empty() && !wanted.sources.empty() && wanted.sources.front().source->topic.type != type) {
    return "topic '" + *name + "' has messages of type " + wanted.sources.front().source->topic.type + ", not " + type;
  }
  return {};
}

std::string Subscriptions::remove(const json& request) {
  const auto name = foxglove::textField(request, "topic");
  const auto found = name ? subscriptions_.find(*name) : subscriptions_.end();
  if (found == subscriptions_.end()) return "there is no subscription to '" + name.value_or("") + "'";
  const auto id = foxglove::textField(request, "id");
  if (id) found->second.wishes.erase(*id);
  if (id && !found->second.wishes.empty()) {
    close(found->second);
    open(found->first, found->second, topics_.all());
    return {};
  }
  close(found->second);
  subscriptions_.erase(found);
  return {};
}

void Subscriptions::follow() {
  if (subscriptions_.empty()) return;
  const std::vector<RosTopic> all = topics_.all();
  for (auto& [name, wanted] : subscriptions_) open(name, wanted, all);
}

void Subscriptions::close(Wanted& wanted) {
  for (Opened& opened : wanted.sources) {
    opened.subscription.reset();
    client_->forget(opened.source->key);
  }
  wanted.sources.clear();
}

/// Makes the sources those that there are now; those that stay are kept.
void Subscriptions::open(const std::string& name, Wanted& wanted, std::span<const RosTopic> all) {
  std::vector<Opened> now;
  for (const RosTopic& topic : all) {
    if (topic.name != name) continue;
    const auto same = std::ranges::find_if(wanted.sources, [&](const Opened& opened) {
      const Worlds::TopicPlace& place = opened.source->topic.place;
      return place.world == topic.place.world && place.topic.name == topic.place.topic.name &&
             place.topic.type == topic.place.topic.type;
    });
    if (same != wanted.sources.end()) {
      now.push_back(*same);
    } else if (auto opened = sourceOf(topic, wanted)) {
      now.push_back(std::move(*opened));
    }
  }
  wanted.sources = std::move(now);
}

std::optional<Subscriptions::Opened> Subscriptions::sourceOf(const RosTopic& topic, const Wanted& wanted) {
  auto source = std::make_shared<Source>();
  source->encoder = topics_.encoder(topic);
  if (!source->encoder) return std::nullopt;
  std::optional<RosDefinition> definition = readDefinition(source->encoder->topics()[topic.index].schema);
  if (!definition) return std::nullopt;
  source->definition = std::move(*definition);
  source->topic = topic;
  source->key = nextKey_++;
  double interval = std::numeric_limits<double>::infinity();
  std::size_t queue = 0;
  for (const auto& [id, wish] : wanted.wishes) {
    interval = std::min(interval, wish.interval);
    queue = std::max(queue, wish.queue);
    if (wish.isCbor) source->form = Form::kCbor;
  }
  source->depth = queue > 0 ? queue : queueDepth(topic.place.topic.type);
  if (interval > 0) source->rate.set(1 / interval);

  Listener listener;
  listener.wants = [source] { return source->rate.passes(gz::Rate::Clock::now()); };
  listener.received = [source, client = client_](const Payload& message, std::uint64_t) {
    source->add(message);
    client->sendWhenFree(source->key, [source, weak = std::weak_ptr(client)]() -> Frame {
      if (const auto to = weak.lock()) source->send(*to);
      return {};
    });
  };
  return Opened{source,
                topic.place.world->subscribe(topic.place.topic.name, topic.place.topic.type, std::move(listener))};
}

}  // namespace pongsim::web::rosbridge
