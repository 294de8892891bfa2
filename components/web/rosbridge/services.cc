#include "web/rosbridge/services.hh"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "web/foxglove/fields.hh"
#include "web/rosbridge/rosapi.hh"
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
  if (const std::optional<json> values =
          Rosapi(topics_, *worlds_, client_->mayWrite()).call(called.service, arguments)) {
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

}  // namespace pongsim::web::rosbridge
