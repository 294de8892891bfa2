#include "pongsim/node.hh"

#include <exception>
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

CallGuard::~CallGuard() = default;

Node Node::guardedBy(CallGuard& guard) const {
  Node node(*bus_);
  node.guard_ = &guard;
  return node;
}

Publisher Node::advertise(std::string_view topic, std::string_view type) {
  auto state = std::make_unique<transport::PublisherState>(*bus_, bus_->addPublisher(topic, type));
  if (guard_ != nullptr) guard_->advertised(state->channel.topic, state->channel.type);
  return Publisher(std::move(state));
}

Subscription Node::subscribe(std::string_view topic, std::string_view type,
                             std::function<void(const Message&)> received, std::size_t queueLength) {
  if (guard_ != nullptr) {
    received = [guard = guard_, inner = std::move(received)](const Message& message) {
      if (!guard->enter()) return;
      try {
        inner(message);
      } catch (const std::exception& error) {
        guard->failed(error);
      }
      guard->leave();
    };
  }
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
  if (guard_ != nullptr) {
    handler = [guard = guard_, inner = std::move(handler)](const Message& request, Message& reply) {
      if (!guard->enter()) return ServiceAnswer::refused("the system is switched off");
      ServiceAnswer answer = false;
      try {
        answer = inner(request, reply);
      } catch (const std::exception& error) {
        guard->failed(error);
        answer = ServiceAnswer::refused(error.what());
      }
      guard->leave();
      return answer;
    };
  }
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
