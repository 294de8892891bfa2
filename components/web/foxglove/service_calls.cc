#include "web/foxglove/service_calls.hh"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "web/foxglove/status.hh"
#include "web/world/read_only_service.hh"

namespace pongsim::web::foxglove {

namespace {

using nlohmann::json;

// Foxglove and Lichtblick keep the types of all channels and services in one list by name, and the JSON form of a type
// is not the protobuf form that a channel has of it: so a service's types have names of their own.
enum class Side { kRequest, kResponse };
const char* suffix(Side side) { return side == Side::kRequest ? "_Request" : "_Response"; }

json description(const std::string& type, Side side, MessageForm form, TopicChannels& channels) {
  if (form == MessageForm::kJson) {
    return {{"encoding", "json"},
            {"schemaName", type + suffix(side)},
            {"schemaEncoding", "jsonschema"},
            {"schema", *channels.jsonSchema(type)}};
  }
  return {{"encoding", "protobuf"},
          {"schemaName", type},
          {"schemaEncoding", "protobuf"},
          {"schema", *channels.schema(type)}};
}

std::string failure(std::uint32_t service, std::uint32_t call, const std::string& message) {
  return textOf({{"op", "serviceCallFailure"}, {"serviceId", service}, {"callId", call}, {"message", message}});
}

/// A call that waits for its response.
struct PendingCall {
  std::uint32_t service = 0;
  std::uint32_t call = 0;
  MessageForm form = MessageForm::kJson;
  std::string replyType;
};

/// Converts a response to JSON, on the server's thread.
class JsonReply final : public Callee {
 public:
  JsonReply(std::shared_ptr<Client> client, PendingCall call, std::string bytes)
      : client_(std::move(client)), call_(std::move(call)), bytes_(std::move(bytes)) {}

  void called() override {
    const auto reply = readMessage(call_.replyType, MessageForm::kProtobuf, std::as_bytes(std::span(bytes_)));
    if (const auto* fault = std::get_if<std::string>(&reply)) {
      return client_->sendText(failure(call_.service, call_.call, *fault));
    }
    const std::string text = writeMessage(*std::get<MessagePointer>(reply), MessageForm::kJson);
    client_->sendBinary(replyFrame(call_.service, call_.call, "json", Payload(std::string_view(text))));
  }

 private:
  const std::shared_ptr<Client> client_;
  const PendingCall call_;
  const std::string bytes_;
};

}  // namespace

ServiceCalls::ServiceCalls(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, TopicChannels& channels,
                           MessageForm form)
    : client_(std::move(client)), worlds_(std::move(worlds)), topicChannels_(channels), form_(form) {}

void ServiceCalls::follow() {
  std::vector<Worlds::ServicePlace> wanted = worlds_->services();
  if (!client_->mayWrite())
    std::erase_if(wanted, [](const auto& each) { return !isReadOnlyService(each.service.name); });
  json removed = json::array();
  for (auto each = services_.begin(); each != services_.end();) {
    const auto found = std::ranges::find_if(wanted, [&](const auto& place) {
      return place.world == each->second.world && place.service == each->second.service;
    });
    if (found != wanted.end()) {
      wanted.erase(found);
      ++each;
      continue;
    }
    removed.push_back(each->first);
    each = services_.erase(each);
  }
  if (!removed.empty()) client_->sendText(textOf({{"op", "unadvertiseServices"}, {"serviceIds", std::move(removed)}}));
  if (wanted.empty()) return;
  json added = json::array();
  for (Worlds::ServicePlace& place : wanted) {
    const std::uint32_t id = nextService_++;
    added.push_back({{"id", id},
                     {"name", place.service.name},
                     {"type", place.service.requestType},
                     {"request", description(place.service.requestType, Side::kRequest, form_, topicChannels_)},
                     {"response", description(place.service.replyType, Side::kResponse, form_, topicChannels_)}});
    services_.emplace(id, std::move(place));
  }
  client_->sendText(textOf({{"op", "advertiseServices"}, {"services", std::move(added)}}));
}

void ServiceCalls::call(const ServiceCall& call) {
  const auto found = services_.find(call.service);
  if (found == services_.end()) {
    return client_->sendText(failure(call.service, call.call, "there is no service " + std::to_string(call.service)));
  }
  const bool isJson = call.encoding == "json";
  if (!isJson && call.encoding != "protobuf") {
    return client_->sendText(
        failure(call.service, call.call,
                "requests must be protobuf or json, not '" + std::string(call.encoding.substr(0, 40)) + "'"));
  }
  const MessageForm form = isJson ? MessageForm::kJson : MessageForm::kProtobuf;
  const OwnService& service = found->second.service;
  auto request = readMessage(service.requestType, form, call.request);
  if (const auto* fault = std::get_if<std::string>(&request))
    return client_->sendText(failure(call.service, call.call, *fault));
  found->second.world->request(
      service, std::shared_ptr<const Message>(std::move(std::get<MessagePointer>(request))),
      [client = client_, pending = PendingCall{call.service, call.call, form, service.replyType}](
          const CallResult& result, const Message& reply) {
        if (!result) return client->sendText(failure(pending.service, pending.call, result.error));
        std::string bytes = writeMessage(reply, MessageForm::kProtobuf);
        // not on this thread, the world's: the conversion takes too long
        if (pending.form == MessageForm::kJson)
          return client->callSoon(std::make_shared<JsonReply>(client, pending, bytes));
        client->sendBinary(replyFrame(pending.service, pending.call, "protobuf", Payload(std::string_view(bytes))));
      });
}

}  // namespace pongsim::web::foxglove
