#include "web/system/traffic_channel.hh"

#include <nlohmann/json.hpp>

namespace pongsim::web {

using nlohmann::json;

struct TrafficChannel::Viewer {
  std::shared_ptr<Client> client;
  std::uint64_t key = 0;
  std::function<std::string(std::uint64_t)> head;
};

std::shared_ptr<void> TrafficChannel::open(const std::shared_ptr<Client>& client, std::uint64_t key,
                                           std::function<std::string(std::uint64_t timeNs)> head) {
  return std::make_shared<Viewer>(Viewer{client, key, std::move(head)});
}

std::string TrafficChannel::ask(const std::shared_ptr<void>& opened, const json&) {
  const auto& viewer = *static_cast<const Viewer*>(opened.get());
  json clients = json::array();
  for (const auto& each : book_->all()) {
    json topics = json::object();
    for (const auto& [topic, count] : each->counts()) topics[topic] = {count.messages, count.bytes};
    clients.push_back({{"number", each->number()},
                       {"address", each->address()},
                       {"protocol", each->protocol()},
                       {"isYou", each.get() == &viewer.client->traffic()},
                       {"topics", std::move(topics)}});
  }
  const json content = {{"clients", std::move(clients)}};
  const std::string text = content.dump(-1, ' ', false, json::error_handler_t::replace);
  viewer.client->sendData(viewer.key, 1, {viewer.head(0), Payload(text)});
  return {};
}

}  // namespace pongsim::web
