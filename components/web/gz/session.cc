#include "web/gz/session.hh"

#include <google/protobuf/message.h>
#include <ignition/msgs/bytes.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/publishers.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>

#include <algorithm>
#include <charconv>
#include <utility>
#include <variant>

#include "pongsim/node.hh"
#include "web/gz/definitions.hh"
#include "web/server/access.hh"
#include "web/world/message_form.hh"
#include "web/world/read_only_service.hh"

namespace pongsim::web::gz {

namespace {

namespace im = ignition::msgs;

constexpr std::size_t kMostPublishers = 100;
// limit of requests for lists that wait until the worlds have listed their topics
constexpr int kMostDeferred = 10;
// key of queued changes, different from those of topics
constexpr std::uint64_t kListsKey = 0;

/// @return Whether a key is required and the client has sent it.
bool isKey(std::string_view sent, std::string_view key) { return !key.empty() && isSameSecret(sent, key); }

}  // namespace

struct GzSession::Deferred {
  /// Null when the session has ended.
  GzSession* session = nullptr;
  int topics = 0;
  int types = 0;

  void answer() {
    if (!session->worlds_->areListsKnown()) return;
    for (; topics > 0; --topics) session->sendTopics();
    for (; types > 0; --types) session->sendTopicsTypes();
  }
};

GzSession::GzSession(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, const AssetSource& assets,
                     const GzSettings& settings, std::shared_ptr<void> counted)
    : client_(std::move(client)),
      worlds_(std::move(worlds)),
      assets_(assets),
      settings_(settings),
      counted_(std::move(counted)),
      isAuthorized_(settings.authorizationKey.empty() && settings.adminAuthorizationKey.empty()),
      subscriptions_(std::make_shared<Subscriptions>(client_, worlds_, settings_)),
      deferred_(std::make_shared<Deferred>(Deferred{this})) {
  // `changed` runs on a world's thread; the update runs on the server's
  watch_ = worlds_->watch(
      {.changed = [to = client_, subscriptions = std::weak_ptr(subscriptions_), deferred = std::weak_ptr(deferred_)] {
        to->sendWhenFree(kListsKey, [subscriptions, deferred]() -> Frame {
          if (const auto there = subscriptions.lock()) there->follow();
          if (const auto there = deferred.lock(); there && there->session != nullptr) there->answer();
          return {};
        });
      }});
}

GzSession::~GzSession() { deferred_->session = nullptr; }

void GzSession::text(std::string_view message) { binary(std::as_bytes(std::span(message))); }

void GzSession::binary(std::span<const std::byte> message) {
  const auto call = readCall({reinterpret_cast<const char*>(message.data()), message.size()});
  if (!call) return error("", "a message must have four parts: operation,topic,type,payload");
  if (call->operation == "auth") return auth(*call);
  if (!isAuthorized_) return error(call->topic, "say 'auth,,,KEY' first");
  const auto found = operations().find(call->operation);
  if (found == operations().end()) {
    return error(call->topic, "there is no operation '" + std::string(call->operation.substr(0, 40)) + "'");
  }
  (this->*found->second)(*call);
}

const std::map<std::string_view, GzSession::Operation>& GzSession::operations() {
  static const std::map<std::string_view, Operation> all = {{"protos", &GzSession::protos},
                                                            {"topics", &GzSession::topics},
                                                            {"topics-types", &GzSession::topicsTypes},
                                                            {"worlds", &GzSession::worlds},
                                                            {"scene", &GzSession::scene},
                                                            {"particle_emitters", &GzSession::particleEmitters},
                                                            {"sub", &GzSession::subscribe},
                                                            {"image", &GzSession::image},
                                                            {"unsub", &GzSession::unsubscribe},
                                                            {"throttle", &GzSession::throttle},
                                                            {"adv", &GzSession::advertise},
                                                            {"pub", &GzSession::publish},
                                                            {"pub_in", &GzSession::publish},
                                                            {"req", &GzSession::request},
                                                            {"asset", &GzSession::asset}};
  return all;
}

void GzSession::auth(const Call& call) {
  const bool isOpen = settings_.authorizationKey.empty() && settings_.adminAuthorizationKey.empty();
  // the key may contain commas; gzweb sends it as payload
  isAuthorized_ = isAuthorized_ || isOpen || isKey(call.payload, settings_.authorizationKey) ||
                  isKey(call.payload, settings_.adminAuthorizationKey);
  client_->sendBinary({isAuthorized_ ? "authorized" : "invalid", {}});
}

void GzSession::protos(const Call&) {
  static const Payload text(definitions());
  client_->sendBinary({{}, text});
}

/// @return Whether all worlds have listed their topics; they start when the first client connects.
void GzSession::topics(const Call&) {
  if (worlds_->areListsKnown()) return sendTopics();
  deferred_->topics = std::min(deferred_->topics + 1, kMostDeferred);
}

void GzSession::topicsTypes(const Call&) {
  if (worlds_->areListsKnown()) return sendTopicsTypes();
  deferred_->types = std::min(deferred_->types + 1, kMostDeferred);
}

void GzSession::sendTopics() {
  im::StringMsg_V list;
  for (const auto& place : worlds_->topics()) {
    if (place.topic.publishers > 0) list.add_data(place.topic.name);
  }
  client_->sendBinary(frame("pub", "topics", list));
}

void GzSession::sendTopicsTypes() {
  im::Publishers list;
  for (const auto& place : worlds_->topics()) {
    if (place.topic.publishers == 0) continue;
    auto& publisher = *list.add_publisher();
    publisher.set_topic(place.topic.name);
    publisher.set_msg_type(place.topic.type);
  }
  client_->sendBinary(frame("pub", "topics-types", list));
}

void GzSession::worlds(const Call&) {
  im::StringMsg_V list;
  for (const auto& world : worlds_->all()) list.add_data(world->world());
  client_->sendBinary(frame("pub", "worlds", list));
}

void GzSession::scene(const Call& call) { requestFromWorld(call, "/scene/info", "ignition.msgs.Scene"); }

void GzSession::particleEmitters(const Call& call) {
  requestFromWorld(call, "/particle_emitters", "ignition.msgs.ParticleEmitter_V");
}

/// Calls a service of the world that the request names. The response is empty if there is no such service.
void GzSession::requestFromWorld(const Call& call, const char* service, const char* type) {
  const auto answer = [client = client_, operation = std::string(call.operation), type](const CallResult& result,
                                                                                        const Message& reply) {
    client->sendBinary(result ? frame("pub", operation, reply) : frame("pub", operation, *newMessage(type)));
  };
  const auto world = worlds_->find(call.topic);
  if (!world) return client_->sendBinary(frame("pub", call.operation, *newMessage(type)));
  // without looking into the lists of services, which do not exist yet for the first client
  world->request({"/world/" + world->world() + service, "ignition.msgs.Empty", type}, std::make_shared<im::Empty>(),
                 answer);
}

void GzSession::subscribe(const Call& call) {
  if (const std::string fault = subscriptions_->add(call.topic, false); !fault.empty()) error(call.topic, fault);
}

void GzSession::image(const Call& call) {
  if (const std::string fault = subscriptions_->add(call.topic, true); !fault.empty()) error(call.topic, fault);
}

void GzSession::unsubscribe(const Call& call) { subscriptions_->remove(call.topic); }

void GzSession::throttle(const Call& call) {
  double hz = 0;
  std::from_chars(call.payload.data(), call.payload.data() + call.payload.size(), hz);
  if (const std::string fault = subscriptions_->limit(call.topic, hz); !fault.empty()) error(call.topic, fault);
}

void GzSession::advertise(const Call& call) {
  if (const auto type = messageTypeName(call.type)) {
    publisherFor(call, *type);
  } else {
    error(call.topic, "there is no message type '" + std::string(call.type) + "'");
  }
}

void GzSession::publish(const Call& call) {
  const auto message = readMessage(call.type, MessageForm::kProtobuf, std::as_bytes(std::span(call.payload)));
  if (const auto* fault = std::get_if<std::string>(&message)) return error(call.topic, *fault);
  RemotePublisher* const publisher = publisherFor(call, *messageTypeName(call.type));
  if (publisher != nullptr && !publisher->publish(Payload(call.payload))) {
    error(call.topic, "the world is too slow: a message was dropped");
  }
}

/// @return A publisher on the request's topic; null if that is impossible, after an error message to the client.
RemotePublisher* GzSession::publisherFor(const Call& call, const std::string& type) {
  const std::pair key(std::string(call.topic), type);
  if (const auto found = publishers_.find(key); found != publishers_.end()) return found->second.get();
  std::string fault;
  const auto all = worlds_->all();
  if (!client_->mayWrite()) fault = "this client is read-only";
  if (const auto name = topicNameError(call.topic)) fault = "the topic's name " + *name;
  if (publishers_.size() >= kMostPublishers)
    fault = "a client can publish on at most " + std::to_string(kMostPublishers) + " topics";
  if (all.empty()) fault = "there is no world";
  std::unique_ptr<RemotePublisher> publisher;
  if (fault.empty()) {
    // a topic that several worlds subscribe to is published in all of them
    const auto place = worlds_->findTopic(key.first);
    publisher = (place ? place->world : all.front())->advertise(key.first, type);
    if (!publisher) fault = "the world is too slow";
  }
  if (!fault.empty()) {
    error(call.topic, fault);
    return nullptr;
  }
  return publishers_.emplace(key, std::move(publisher)).first->second.get();
}

void GzSession::request(const Call& call) {
  const auto found = worlds_->findService(call.topic);
  if (!found) return client_->sendBinary(textFrame("req", call.topic, "service_not_found"));
  const OwnService& service = found->service;
  if (!client_->mayWrite() && !isReadOnlyService(call.topic)) return error(call.topic, "this client is read-only");
  if (messageTypeName(call.type) != service.requestType) {
    return error(call.topic, "the service takes " + service.requestType + ", not '" + std::string(call.type) + "'");
  }
  auto request = readMessage(call.type, MessageForm::kProtobuf, std::as_bytes(std::span(call.payload)));
  if (const auto* fault = std::get_if<std::string>(&request)) return error(call.topic, *fault);
  found->world->request(service, std::shared_ptr<const Message>(std::move(std::get<MessagePointer>(request))),
                        [client = client_, service](const CallResult& result, const Message& reply) {
                          if (result) return client->sendBinary(frame("req", service.name, reply));
                          // an empty response, like Fortress's, and a reason
                          client->sendBinary({head("req", service.name, service.replyType), {}});
                          client->sendBinary(textFrame("error", service.name, result.error));
                        });
}

void GzSession::asset(const Call& call) {
  // gzweb sends the address as payload
  const std::string_view address = call.payload.empty() ? call.topic : call.payload;
  if (address.empty()) return client_->sendBinary(textFrame("asset", "", "asset_uri_missing"));
  Asset file = assets_.fetch(address);
  if (!file.error.empty()) return client_->sendBinary(textFrame("asset", address, "asset_not_found"));
  im::Bytes bytes;
  bytes.set_data(std::move(file.bytes));
  client_->sendBinary(frame("asset", address, bytes));
}

void GzSession::error(std::string_view about, std::string_view text) {
  client_->sendBinary(textFrame("error", about, text));
}

}  // namespace pongsim::web::gz
