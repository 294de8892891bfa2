#include "web/foxglove/session.hh"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <string>
#include <utility>
#include <variant>

#include "web/foxglove/fields.hh"
#include "web/foxglove/status.hh"
#include "web/foxglove/wire.hh"
#include "web/typed/asset_address.hh"

namespace pongsim::web::foxglove {

namespace {

using nlohmann::json;

// key of data that belongs to no subscription; subscription ids have 32 bits
constexpr std::uint64_t kListsKey = std::uint64_t{1} << 32;
constexpr std::uint64_t kTimeKey = kListsKey + 1;
// maximum per message of a client
constexpr std::size_t kMostErrors = 10;

/// @return An id by which a client that reconnects recognizes the same run.
std::string sessionId() {
  static const auto start = std::chrono::system_clock::now().time_since_epoch();
  return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(start).count());
}

/// Sends a client the time of the first world.
class TimeSender final : public Callee {
 public:
  TimeSender(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds)
      : client_(std::move(client)), worlds_(std::move(worlds)) {}

  void called() override {
    isTurn_ = !isTurn_;
    if (!isTurn_) return;
    const auto worlds = worlds_->all();
    const std::uint64_t timeNs = worlds.empty() ? sent_ : worlds.front()->timeNs();
    if (timeNs == sent_) return;
    sent_ = timeNs;
    client_->sendData(kTimeKey, 1, timeFrame(timeNs));
  }

 private:
  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  /// At most 60 times per second.
  bool isTurn_ = false;
  std::uint64_t sent_ = 0;
};

using ParameterOperation = std::string (Parameters::*)(const json&);

/// @return The handler of an operation on parameters; null for other operations.
ParameterOperation parameterOperation(std::string_view operation) {
  if (operation == "getParameters") return &Parameters::get;
  if (operation == "setParameters") return &Parameters::set;
  if (operation == "subscribeParameterUpdates") return &Parameters::subscribe;
  if (operation == "unsubscribeParameterUpdates") return &Parameters::unsubscribe;
  return nullptr;
}

Channel channelOf(const std::shared_ptr<OwnChannel>& channel) {
  Channel result;
  result.topic = channel->topic();
  result.encoding = "pongsim";
  result.schemaName = channel->schemaName();
  result.source = channel.get();
  result.open = [channel](const std::shared_ptr<Client>& client, std::uint64_t key, Head head) {
    return channel->open(client, key, std::move(head));
  };
  result.ask = [channel](const std::shared_ptr<void>& opened, const json& wish) { return channel->ask(opened, wish); };
  return result;
}

}  // namespace

FoxgloveSession::FoxgloveSession(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds,
                                 TopicChannels& channels, const OwnChannels* own, TypedChannels* typed, LogChannel& log,
                                 const AssetSource& assets)
    : client_(std::move(client)),
      worlds_(std::move(worlds)),
      assets_(assets),
      report_(std::make_shared<Report>(
          Report{Subscriptions(client_),
                 ServiceCalls(client_, worlds_, channels, own != nullptr ? MessageForm::kProtobuf : MessageForm::kJson),
                 Graph(client_, worlds_), channels, own, typed, log})),
      publications_(client_, worlds_),
      parameters_(std::make_shared<Parameters>(client_, worlds_)) {
  sendServerInfo();
  report_->follow();
  // `changed` runs on a world's thread; the update runs on the server's
  watch_ = worlds_->watch({.changed = [to = client_, report = std::weak_ptr(report_)] {
    to->sendWhenFree(kListsKey, [report]() -> Frame {
      if (const auto there = report.lock()) there->follow();
      return {};
    });
  }});
  timeSender_ = std::make_shared<TimeSender>(client_, worlds_);
  regularly_ = client_->callRegularly(timeSender_);
}

void FoxgloveSession::sendServerInfo() {
  json capabilities = {"time", "services", "connectionGraph", "assets", "parameters", "parametersSubscribe"};
  if (client_->mayWrite()) capabilities.push_back("clientPublish");
  json worlds = json::array();
  for (const auto& world : worlds_->all()) worlds.push_back(world->world());
  client_->sendText(textOf({{"op", "serverInfo"},
                            {"name", "pongsim"},
                            {"capabilities", std::move(capabilities)},
                            {"supportedEncodings", {"json", "protobuf"}},
                            {"metadata", {{"worlds", textOf(worlds)}}},
                            {"sessionId", sessionId()}}));
}

void FoxgloveSession::Report::follow() {
  std::vector<Channel> all = topics.all();
  if (own != nullptr) {
    for (const auto& channel : own->all()) all.push_back(channelOf(channel));
  }
  if (typed != nullptr) std::ranges::move(typed->all(), std::back_inserter(all));
  all.push_back(log.channel());
  subscriptions.follow(std::move(all));
  calls.follow();
  graph.follow();
}

void FoxgloveSession::text(std::string_view text) {
  const json message = parseJson(text);
  const auto operation = textField(message, "op");
  if (!operation) return sendError("a text message must be a JSON object with an 'op'");
  const auto withId = [](auto&& handle, const char* what) {
    return [handle, what](const json& value) {
      const auto id = idOf(value);
      return id ? handle(*id) : "the id of a " + std::string(what) + " must be a number";
    };
  };
  if (*operation == "subscribe") {
    return each(message, "subscriptions", [this](const json& value) { return subscribe(value); });
  }
  if (*operation == "unsubscribe") {
    const auto end = [this](std::uint32_t id) { return report_->subscriptions.unsubscribe(id); };
    return each(message, "subscriptionIds", withId(end, "subscription"));
  }
  if (*operation == "advertise") {
    return each(message, "channels", [this](const json& value) { return publications_.open(value); });
  }
  if (*operation == "unadvertise") {
    const auto end = [this](std::uint32_t id) { return publications_.close(id); };
    return each(message, "channelIds", withId(end, "channel"));
  }
  if (*operation == "ask") {
    const auto ask = [this, &message](std::uint32_t id) { return report_->subscriptions.ask(id, message); };
    const std::string wrong = withId(ask, "subscription")(message.value("subscriptionId", json()));
    return wrong.empty() ? void() : sendError(wrong);
  }
  if (*operation == "fetchAsset") return fetchAsset(message);
  if (const auto handle = parameterOperation(*operation)) {
    const std::string wrong = (*parameters_.*handle)(message);
    return wrong.empty() ? void() : sendError(wrong);
  }
  if (*operation == "subscribeConnectionGraph") return report_->graph.setWanted(true);
  if (*operation == "unsubscribeConnectionGraph") return report_->graph.setWanted(false);
  sendError("there is no operation '" + operation->substr(0, 40) + "'");
}

void FoxgloveSession::binary(std::span<const std::byte> message) {
  const auto received = readBinary(message);
  if (const auto* call = std::get_if<ServiceCall>(&received)) return report_->calls.call(*call);
  const auto* data = std::get_if<ClientData>(&received);
  const std::string what =
      data != nullptr ? publications_.publish(data->channel, data->message) : std::get<std::string>(received);
  if (!what.empty()) sendError(what);
}

void FoxgloveSession::each(const json& message, const char* list,
                           const std::function<std::string(const json&)>& handle) {
  const auto members = listField(message, list);
  if (!members) return sendError("'" + message.value("op", "") + "' must have a list '" + list + "'");
  std::size_t faults = 0;
  for (const json& member : *members) {
    const std::string what = handle(member);
    if (!what.empty() && ++faults <= kMostErrors) sendError(what);
  }
  if (faults > kMostErrors) sendError("and " + std::to_string(faults - kMostErrors) + " more like these");
}

std::string FoxgloveSession::subscribe(const json& subscription) {
  const auto id = idField(subscription, "id");
  const auto channel = idField(subscription, "channelId");
  if (!id || !channel) return "a subscription must have an 'id' and a 'channelId'";
  return report_->subscriptions.subscribe(*id, *channel);
}

void FoxgloveSession::fetchAsset(const json& message) {
  const auto uri = textField(message, "uri");
  const auto id = idField(message, "requestId");
  if (!uri || !id) return sendError("'fetchAsset' must have a 'uri' and a 'requestId'");
  client_->sendBinary(assetFrame(*id, assets_.fetch(typed::sceneAddress(*uri))));
}

void FoxgloveSession::sendError(std::string_view what) { sendStatus(*client_, StatusLevel::kError, what); }

}  // namespace pongsim::web::foxglove
