#include "ros2/wire/graph.hh"

#include <algorithm>
#include <tuple>

namespace pongsim::ros2 {

void Graph::add(const Endpoint& endpoint) {
  const std::lock_guard lock(mutex_);
  endpoints_[endpoint.id] = endpoint;
  ++version_;
}

void Graph::remove(const Guid& endpoint) {
  const std::lock_guard lock(mutex_);
  endpoints_.erase(endpoint);
  ++version_;
}

void Graph::addParticipant(const Guid& participant) {
  const std::lock_guard lock(mutex_);
  if (std::ranges::find(participants_, participant) != participants_.end()) return;
  participants_.push_back(participant);
  ++version_;
}

void Graph::removeParticipant(const Guid& participant) {
  const std::lock_guard lock(mutex_);
  std::erase(participants_, participant);
  std::erase_if(endpoints_, [&](const auto& each) { return each.first.isOfSameParticipant(participant); });
  ++version_;
}

std::uint64_t Graph::version() const {
  const std::lock_guard lock(mutex_);
  return version_;
}

std::vector<Graph::Endpoint> Graph::endpoints() const {
  std::vector<Endpoint> all;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, endpoint] : endpoints_) all.push_back(endpoint);
  }
  std::ranges::sort(all, [](const Endpoint& a, const Endpoint& b) {
    return std::tie(a.contract.topic, a.id) < std::tie(b.contract.topic, b.id);
  });
  return all;
}

std::optional<Graph::Endpoint> Graph::find(const Guid& endpoint) const {
  const std::lock_guard lock(mutex_);
  const auto found = endpoints_.find(endpoint);
  return found == endpoints_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Graph::Endpoint> Graph::endpointsOn(std::string_view topic, Role role) const {
  std::vector<Endpoint> matching;
  const std::lock_guard lock(mutex_);
  for (const auto& [id, endpoint] : endpoints_) {
    if (endpoint.role == role && endpoint.contract.topic == topic) matching.push_back(endpoint);
  }
  return matching;
}

std::vector<Guid> Graph::participants() const {
  const std::lock_guard lock(mutex_);
  return participants_;
}

}  // namespace pongsim::ros2
