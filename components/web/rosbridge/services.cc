#include "web/rosbridge/services.hh"

#include <algorithm>
#include <span>
#include <utility>
#include <variant>

#include "web/foxglove/fields.hh"
#include "web/world/message_form.hh"
#include "web/world/read_only_service.hh"

namespace pongsim::web::rosbridge {

namespace {

using nlohmann::json;

/// What an answer repeats of the call.
struct Called {
  std::string service;
  std::optional<std::string> id;
};

std::string response(const Called& called, const json& values, bool isDone) {
  json answer = {{"op", "service_response"}, {"service", called.service}, {"values", values}, {"result", isDone}};
  if (called.id) answer["id"] = *called.id;
  return answer.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// Converts a response to JSON, on the server's thread.
class JsonResponse final : public Callee {
 public:
  JsonResponse(std::shared_ptr<Client> client, Called called, std::string type, std::string bytes)
      : client_(std::move(client)), called_(std::move(called)), type_(std::move(type)), bytes_(std::move(bytes)) {}

  void called() override {
    const auto reply = readMessage(type_, MessageForm::kProtobuf, std::as_bytes(std::span(bytes_)));
    if (const auto* fault = std::get_if<std::string>(&reply))
      return client_->sendText(response(called_, *fault, false));
    const std::string text = writeMessage(*std::get<MessagePointer>(reply), MessageForm::kJson);
    const json values = json::parse(text, nullptr, false);
    client_->sendText(response(called_, values.is_discarded() ? json::object() : values, true));
  }

 private:
  const std::shared_ptr<Client> client_;
  const Called called_;
  const std::string type_;
  const std::string bytes_;
};

}  // namespace

Services::Services(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, RosTopics& topics)
    : client_(std::move(client)), worlds_(std::move(worlds)), topics_(topics) {}

void Services::call(const json& request) {
  const Called called{foxglove::textField(request, "service").value_or(""), foxglove::textField(request, "id")};
  const json arguments = request.value("args", json::object());
  const auto refuse = [&](const std::string& why) { client_->sendText(response(called, why, false)); };
  if (const std::optional<json> values = rosapi(called.service, arguments)) {
    return client_->sendText(response(called, *values, true));
  }
  const auto found = worlds_->findService(called.service);
  if (!found) return refuse("there is no service '" + called.service + "'");
  if (!client_->mayWrite() && !isReadOnlyService(called.service)) return refuse("this client is read-only");
  if (!arguments.is_object()) return refuse("the arguments must be an object");
  const OwnService& service = found->service;
  const std::string text = arguments.dump();
  auto message = readMessage(service.requestType, MessageForm::kJson, std::as_bytes(std::span(text)));
  if (const auto* fault = std::get_if<std::string>(&message)) return refuse(*fault);
  found->world->request(
      service, std::shared_ptr<const Message>(std::move(std::get<MessagePointer>(message))),
      [client = client_, called, type = service.replyType](const CallResult& result, const Message& reply) {
        if (!result) return client->sendText(response(called, result.error, false));
        // not on this thread, the world's: the conversion takes too long
        client->callSoon(
            std::make_shared<JsonResponse>(client, called, type, writeMessage(reply, MessageForm::kProtobuf)));
      });
}

/// @return The response of a service of rosapi; nothing if it is none of those that there are here.
std::optional<json> Services::rosapi(const std::string& service, const json& arguments) {
  if (service == "/rosapi/topics" || service == "/rosapi/topics_and_raw_types") {
    json names = json::array(), types = json::array(), definitions = json::array();
    for (const RosTopic& topic : topics_.all()) {
      if (std::ranges::find(names, json(topic.name)) != names.end()) continue;
      names.push_back(topic.name);
      types.push_back(topic.type);
      definitions.push_back(topics_.definition(topic));
    }
    json values = {{"topics", names}, {"types", types}};
    if (service != "/rosapi/topics") values["typedefs_full_text"] = definitions;
    return values;
  }
  if (service == "/rosapi/topic_type") {
    const auto found = topics_.find(foxglove::textField(arguments, "topic").value_or(""));
    return json{{"type", found.empty() ? "" : found.front().type}};
  }
  if (service == "/rosapi/services") {
    json names = json::array();
    for (const auto& place : worlds_->services()) {
      if (client_->mayWrite() || isReadOnlyService(place.service.name)) names.push_back(place.service.name);
    }
    return json{{"services", names}};
  }
  if (service == "/rosapi/service_type") {
    const auto found = worlds_->findService(foxglove::textField(arguments, "service").value_or(""));
    return json{{"type", found ? found->service.requestType : ""}};
  }
  if (service == "/rosapi/nodes") return json{{"nodes", json::array({"/pongsim"})}};
  return std::nullopt;
}

}  // namespace pongsim::web::rosbridge
