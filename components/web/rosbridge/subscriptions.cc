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
#include "web/rosbridge/rosout.hh"
#include "web/server/traffic.hh"
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
  Compression compression = Compression::kNone;
  std::uint64_t key = 0;
  std::size_t depth = 1;
  RosDefinition definition;
  /// Only used on the server's thread; null: messages are in CDR already.
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

  /// @return The next of what waits; empty: there is none.
  Frame next() {
    while (const std::optional<Payload> message = take()) {
      if (Frame frame = frameOf(message->bytes()); frame.size() > 0) return frame;
    }
    return {};
  }

  bool isEmpty() {
    const std::lock_guard lock(mutex);
    return waiting.empty();
  }

 private:
  std::optional<Payload> take() {
    const std::lock_guard lock(mutex);
    if (waiting.empty()) return std::nullopt;
    Payload message = std::move(waiting.front());
    waiting.pop_front();
    return message;
  }

  Frame frameOf(std::span<const std::byte> message) const {
    json publish = {{"op", "publish"}, {"topic", topic.name}};
    const auto put = [&](std::span<const std::byte> payload) {
      if (compression != Compression::kCborRaw) {
        publish["msg"] = readCdr(definition, payload, compression == Compression::kNone ? Form::kJson : Form::kCbor);
        return;
      }
      const std::uint64_t ns = topic.place.world ? topic.place.world->timeNs() : 0;
      const auto* const begin = reinterpret_cast<const std::uint8_t*>(payload.data());
      publish["msg"] = {{"secs", ns / kNanoseconds},
                        {"nsecs", ns % kNanoseconds},
                        {"bytes", json::binary(std::vector<std::uint8_t>(begin, begin + payload.size()))}};
    };
    try {
      if (!encoder) put(message);
      if (encoder) {
        encoder->encode(message, [&](std::size_t index, std::span<const std::byte> payload) {
          if (index == topic.index) put(payload);
        });
      }
    } catch (const std::runtime_error&) {
      // not a message of the topic's type, from another process
      return {};
    }
    if (compression == Compression::kNone)
      return {publish.dump(-1, ' ', false, json::error_handler_t::replace), {}, true};
    const std::vector<std::uint8_t> bytes = json::to_cbor(publish);
    return {std::string(bytes.begin(), bytes.end()), {}};
  }
};

Subscriptions::Subscriptions(std::shared_ptr<Client> client, RosTopics& topics)
    : client_(std::move(client)), topics_(topics) {}

std::string Subscriptions::add(const json& request) {
  const auto name = foxglove::textField(request, "topic");
  if (!name) return "a subscription must have a topic";
  if (const auto error = topicNameError(*name)) return "the topic's name '" + *name + "' " + *error;
  if (const std::string& fault = topics_.fault(); !fault.empty() && *name != kRosout) return fault;
  const std::string wantedCompression = foxglove::textField(request, "compression").value_or("none");
  const std::optional<Compression> compression = compressionOf(wantedCompression);
  if (!compression) {
    return "messages can have the compression 'none', 'cbor' or 'cbor-raw', not '" + wantedCompression + "'";
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
      *compression};
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

std::optional<Subscriptions::Compression> Subscriptions::compressionOf(std::string_view name) {
  if (name == "none") return Compression::kNone;
  if (name == "cbor") return Compression::kCbor;
  if (name == "cbor-raw") return Compression::kCborRaw;
  return std::nullopt;
}

/// Makes the sources those that there are now; those that stay are kept.
void Subscriptions::open(const std::string& name, Wanted& wanted, std::span<const RosTopic> all) {
  if (name == kRosout) {
    if (wanted.sources.empty()) wanted.sources.push_back(rosout(wanted));
    return;
  }
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

/// @return A source with what the client wishes, without a definition and an encoder.
std::shared_ptr<Subscriptions::Source> Subscriptions::newSource(RosTopic topic, const Wanted& wanted) {
  auto source = std::make_shared<Source>();
  source->key = nextKey_++;
  client_->traffic().name(source->key, topic.name);
  double interval = std::numeric_limits<double>::infinity();
  std::size_t queue = 0;
  for (const auto& [id, wish] : wanted.wishes) {
    interval = std::min(interval, wish.interval);
    queue = std::max(queue, wish.queue);
    source->compression = std::max(source->compression, wish.compression);
  }
  source->depth = queue > 0 ? queue : queueDepth(topic.place.topic.type);
  if (interval > 0) source->rate.set(1 / interval);
  source->topic = std::move(topic);
  return source;
}

std::optional<Subscriptions::Opened> Subscriptions::sourceOf(const RosTopic& topic, const Wanted& wanted) {
  std::unique_ptr<TopicEncoder> encoder = topics_.encoder(topic);
  if (!encoder) return std::nullopt;
  std::optional<RosDefinition> definition = readDefinition(encoder->topics()[topic.index].schema);
  if (!definition) return std::nullopt;
  const std::shared_ptr<Source> source = newSource(topic, wanted);
  source->encoder = std::move(encoder);
  source->definition = std::move(*definition);

  Listener listener;
  listener.wants = [source] { return source->rate.passes(gz::Rate::Clock::now()); };
  listener.received = [source, client = client_](const Payload& message, std::uint64_t) {
    source->add(message);
    sendSoon(*client, source);
  };
  return Opened{source,
                topic.place.world->subscribe(topic.place.topic.name, topic.place.topic.type, std::move(listener))};
}

Subscriptions::Opened Subscriptions::rosout(const Wanted& wanted) {
  const std::shared_ptr<Source> source = newSource({std::string(kRosout), std::string(kRosoutType), {}, 0}, wanted);
  source->definition = rosoutDefinition();
  source->depth = std::max(source->depth, RecentLog::kKept);
  return {source, topics_.log().watch([source, client = client_](const RecentLog::Line& line) {
            source->add(Payload(rosoutMessage(line)));
            sendSoon(*client, source);
          })};
}

/// Sends what waits, one message in each turn of the topic.
void Subscriptions::sendSoon(Client& client, const std::shared_ptr<Source>& source) {
  client.sendWhenFree(source->key, [source, to = &client]() -> Frame {
    Frame frame = source->next();
    if (!source->isEmpty()) sendSoon(*to, source);
    return frame;
  });
}

}  // namespace pongsim::web::rosbridge
