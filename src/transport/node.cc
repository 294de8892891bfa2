#include "pongsim/node.hh"

#include <utility>

#include "transport/bus.hh"
#include "transport/network.hh"

namespace pongsim {

Publisher::Publisher() = default;
Publisher::Publisher(std::unique_ptr<transport::PublisherState> state) : state_(std::move(state)) {}
Publisher::Publisher(Publisher&&) noexcept = default;
Publisher& Publisher::operator=(Publisher&&) noexcept = default;
Publisher::~Publisher() = default;

bool Publisher::hasSubscribers() const { return state_ && state_->bus.hasSubscribers(state_->channel); }

void Publisher::publish(const Message& message) {
  if (state_) state_->bus.publish(state_->channel, message);
}

bool Publisher::waitForSubscribers(std::chrono::nanoseconds timeout) const {
  return state_ && state_->bus.waitForSubscribers(state_->channel, timeout);
}

bool Publisher::waitForDelivery(std::chrono::nanoseconds timeout) const {
  return state_ && state_->bus.waitForDelivery(state_->channel, timeout);
}

Subscription::Subscription() = default;
Subscription::Subscription(std::unique_ptr<transport::SubscriptionState> state) : state_(std::move(state)) {}
Subscription::Subscription(Subscription&&) noexcept = default;
Subscription& Subscription::operator=(Subscription&&) noexcept = default;
Subscription::~Subscription() = default;

std::uint64_t Subscription::dropped() const { return state_ ? state_->bus.dropped(state_->inbox) : 0; }

Publisher Node::advertise(std::string_view topic, std::string_view type) {
  return Publisher(std::make_unique<transport::PublisherState>(*bus_, bus_->addPublisher(topic, type)));
}

Subscription Node::subscribe(std::string_view topic, std::string_view type,
                             std::function<void(const Message&)> received, std::size_t queueLength) {
  return Subscription(std::make_unique<transport::SubscriptionState>(
      *bus_, bus_->addSubscription(topic, type, std::move(received), queueLength)));
}

Service::Service() = default;
Service::Service(std::unique_ptr<transport::ServiceState> state) : state_(std::move(state)) {}
Service::Service(Service&&) noexcept = default;
Service& Service::operator=(Service&&) noexcept = default;
Service::~Service() = default;

Service Node::serve(std::string_view service, std::string_view requestType, std::string_view replyType,
                    ServiceHandler handler) {
  return Service(std::make_unique<transport::ServiceState>(
      *bus_, bus_->addService(service, requestType, replyType, std::move(handler))));
}

CallResult Node::call(std::string_view service, const Message& request, Message& reply,
                      std::chrono::nanoseconds timeout) {
  return bus_->call(service, request, reply, timeout);
}

Transport::Transport(const TransportOptions& options)
    : bus_(std::make_unique<transport::Bus>(options.network ? std::make_unique<transport::Network>(options.domain)
                                                            : nullptr)) {}

Transport::~Transport() = default;

std::size_t Transport::dispatch() { return bus_->dispatch(); }

std::size_t Transport::dispatchFor(std::chrono::nanoseconds timeout) { return bus_->dispatchFor(timeout); }

void Transport::wake() { bus_->wake(); }

std::vector<TopicInfo> Transport::discover(std::chrono::nanoseconds timeout) { return bus_->discover(timeout); }

TopicInfo Transport::waitForTopic(std::string_view topic, bool wantPublisher, std::chrono::nanoseconds timeout) {
  return bus_->waitForTopic(topic, wantPublisher, timeout);
}

std::vector<ServiceInfo> Transport::discoverServices(std::chrono::nanoseconds timeout) {
  return bus_->discoverServices(timeout);
}

ServiceInfo Transport::waitForService(std::string_view service, std::chrono::nanoseconds timeout) {
  return bus_->waitForService(service, timeout);
}

}  // namespace pongsim
