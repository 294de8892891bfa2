#include "web/rosbridge/session.hh"

#include <algorithm>
#include <deque>
#include <utility>

#include "web/foxglove/fields.hh"

namespace pongsim::web::rosbridge {

namespace {

using nlohmann::json;

// key of queued changes, different from those of topics
constexpr std::uint64_t kChangesKey = 0;
// limit of messages that wait until the worlds have listed their topics
constexpr std::size_t kMostDeferred = 1000;
constexpr std::size_t kMostDeferredBytes = std::size_t{4} << 20;
constexpr std::size_t kLongestName = 40;

}  // namespace

struct RosbridgeSession::State {
  State(const std::shared_ptr<Client>& to, const std::shared_ptr<Worlds>& all, RosTopics& topics)
      : client(to), worlds(all), subscriptions(to, topics), publications(to, all, topics), services(to, all, topics) {}

  void receive(const json& request) {
    const std::string operation = foxglove::textField(request, "op").value_or("");
    if (operation == "subscribe") return report(request, subscriptions.add(request));
    if (operation == "unsubscribe") return report(request, subscriptions.remove(request));
    if (operation == "advertise") return report(request, publications.advertise(request));
    if (operation == "unadvertise") return report(request, publications.unadvertise(request));
    if (operation == "publish") return report(request, publications.publish(request));
    if (operation == "call_service") return services.call(request);
    if (operation == "set_level" || operation == "status_level") {
      isQuiet = foxglove::textField(request, "level") == "none";
      return;
    }
    report(request, operation.empty() ? "a message must be an object in JSON with an 'op'"
                                      : "there is no operation '" + operation.substr(0, kLongestName) + "'");
  }

  /// Tells the client what is wrong; empty: nothing.
  void report(const json& request, const std::string& fault) {
    if (fault.empty() || isQuiet) return;
    json status = {{"op", "status"}, {"level", "error"}, {"msg", fault}};
    if (const auto id = foxglove::textField(request, "id")) status["id"] = *id;
    client->sendText(status.dump(-1, ' ', false, json::error_handler_t::replace));
  }

  void changed() {
    if (!worlds->areListsKnown()) return;
    subscriptions.follow();
    deferredBytes = 0;
    for (const std::string& message : std::exchange(deferred, {})) receive(foxglove::parseJson(message));
  }

  void defer(std::string_view message) {
    deferredBytes += message.size();
    if (deferred.size() >= kMostDeferred || deferredBytes > kMostDeferredBytes) {
      return client->close(1008, "too many messages before the worlds have listed their topics");
    }
    deferred.emplace_back(message);
  }

  const std::shared_ptr<Client> client;
  const std::shared_ptr<Worlds> worlds;
  Subscriptions subscriptions;
  Publications publications;
  Services services;
  bool isQuiet = false;
  std::deque<std::string> deferred;
  std::size_t deferredBytes = 0;
};

RosbridgeSession::RosbridgeSession(std::shared_ptr<Client> client, const std::shared_ptr<Worlds>& worlds,
                                   RosTopics& topics)
    : state_(std::make_shared<State>(client, worlds, topics)) {
  // `changed` runs on a world's thread; the update runs on the server's
  watch_ = worlds->watch({.changed = [to = std::move(client), state = std::weak_ptr(state_)] {
    to->sendWhenFree(kChangesKey, [state]() -> Frame {
      if (const auto there = state.lock()) there->changed();
      return {};
    });
  }});
}

RosbridgeSession::~RosbridgeSession() = default;

void RosbridgeSession::text(std::string_view message) {
  if (!state_->worlds->areListsKnown()) return state_->defer(message);
  state_->receive(foxglove::parseJson(message));
}

void RosbridgeSession::binary(std::span<const std::byte>) {
  state_->report({}, "messages to the server must be texts in JSON");
}

bool isRosbridge(std::string_view message) { return message.starts_with('{'); }

}  // namespace pongsim::web::rosbridge
