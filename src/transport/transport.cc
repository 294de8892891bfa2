#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/node.hh"
#include "transport/bus.hh"
#include "transport/deadline.hh"
#include "transport/names/service_name.hh"
#include "transport/names/topic_name.hh"
#include "transport/network/network.hh"

namespace pongsim {

Transport::Transport(const TransportOptions& options)
    : bus_(std::make_shared<transport::Bus>(
          options.network
              ? std::make_unique<transport::Network>(options.domain, options.interface, options.announceLater)
              : nullptr)),
      queue_(&bus_->addQueue()) {}

Transport::Transport(const Transport& other, Sharing) : bus_(other.bus_), queue_(&bus_->addQueue()) {}

Transport::~Transport() = default;

void Transport::announce() {
  if (transport::Network* network = bus_->network()) network->announce();
}

std::optional<std::string> Transport::openTo() const {
  const transport::Network* network = bus_->network();
  if (network == nullptr || !network->interface()) return std::nullopt;
  return network->interface()->name + ", " + network->interface()->address;
}

std::size_t Transport::dispatch() { return bus_->dispatch(*queue_); }

void Transport::discard() { bus_->discard(*queue_); }

std::size_t Transport::dispatchFor(std::chrono::nanoseconds timeout) {
  bus_->delivery().wait(*queue_, timeout);
  return bus_->dispatch(*queue_);
}

void Transport::wake() { bus_->delivery().wake(*queue_); }

bool Transport::heardAll() const { return bus_->network() == nullptr || bus_->network()->heardAll(); }

std::vector<TopicInfo> Transport::discover(std::chrono::nanoseconds timeout) {
  transport::Network* network = bus_->network();
  if (network == nullptr) return {};
  network->discover(timeout);
  return network->directory().topics();
}

TopicInfo Transport::waitForTopic(std::string_view topic, bool wantPublisher, std::chrono::nanoseconds timeout) {
  const std::string name = transport::absoluteTopic(topic);
  transport::Network* network = bus_->network();
  if (network == nullptr) return {name, {}, {}};
  network->announce();
  network->directory().waitForTopic(name, wantPublisher ? transport::Role::kPublisher : transport::Role::kSubscriber,
                                    transport::deadlineAfter(timeout));
  return network->directory().topic(name);
}

TopicInfo Transport::watchTopic(std::string_view topic, std::chrono::nanoseconds duration) {
  const std::string name = transport::absoluteTopic(topic);
  transport::Network* network = bus_->network();
  if (network == nullptr) return {name, {}, {}};
  network->watchTraffic(duration);
  return network->directory().topic(name);
}

std::vector<ServiceInfo> Transport::discoverServices(std::chrono::nanoseconds timeout) {
  transport::Network* network = bus_->network();
  if (network == nullptr) return {};
  network->discover(timeout);
  return network->directory().services();
}

ServiceInfo Transport::waitForService(std::string_view service, std::chrono::nanoseconds timeout) {
  const std::string name = transport::absoluteService(service);
  transport::Network* network = bus_->network();
  if (network == nullptr) return {name, {}};
  network->announce();
  network->directory().waitForTopic(transport::requestTopic(name), transport::Role::kSubscriber,
                                    transport::deadlineAfter(timeout));
  return network->directory().service(name);
}

}  // namespace pongsim
