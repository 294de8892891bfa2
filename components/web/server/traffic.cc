#include "web/server/traffic.hh"

#include <algorithm>
#include <utility>

namespace pongsim::web {

namespace {

// of one client; a client that publishes and subscribes to ever new ones must not fill the memory
constexpr std::size_t kMostCountedTopics = 4000;

}  // namespace

ClientTraffic::ClientTraffic(std::uint64_t number, std::string address, std::string protocol)
    : number_(number), address_(std::move(address)), protocol_(std::move(protocol)) {}

void ClientTraffic::name(std::uint64_t key, const std::string& topic) {
  const std::lock_guard lock(mutex_);
  const bool isCounted = byTopic_.contains(topic) || byTopic_.size() < kMostCountedTopics;
  if (!isCounted && byKey_.size() >= kMostCountedTopics) return;
  byKey_[key] = &byTopic_[isCounted ? topic : ""];
}

void ClientTraffic::add(std::optional<std::uint64_t> key, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  const auto found = key ? byKey_.find(*key) : byKey_.end();
  Count& count = found != byKey_.end() ? *found->second : byTopic_[""];
  ++count.messages;
  count.bytes += bytes;
}

std::map<std::string, ClientTraffic::Count> ClientTraffic::counts() const {
  const std::lock_guard lock(mutex_);
  return byTopic_;
}

std::shared_ptr<ClientTraffic> TrafficBook::add(std::string address, std::string protocol) {
  const std::lock_guard lock(mutex_);
  auto client = std::make_shared<ClientTraffic>(next_++, std::move(address), std::move(protocol));
  std::erase_if(clients_, [](const auto& each) { return each.expired(); });
  clients_.push_back(client);
  return client;
}

std::vector<std::shared_ptr<const ClientTraffic>> TrafficBook::all() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<const ClientTraffic>> clients;
  for (const auto& each : clients_) {
    if (auto client = each.lock()) clients.push_back(std::move(client));
  }
  return clients;
}

}  // namespace pongsim::web
