#include "pongsim/node.hh"

#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "transport/bus.hh"
#include "transport/names/topic_name.hh"
#include "transport/names/type_name.hh"
#include "transport/network/network.hh"

namespace pongsim {

namespace {

using Moment = CallGuard::Moment;

/// @return `call`, made by the guard where there is one.
template <class... Arguments>
std::function<void(Arguments...)> guarded(CallGuard* guard, std::function<void(Arguments...)> call,
                                          Moment moment = Moment::kDispatch) {
  if (guard == nullptr || !call) return call;
  return [guard, moment, inner = std::move(call)](Arguments... arguments) {
    guard->call(moment, [&] { inner(arguments...); });
  };
}

void checkRate(const SubscriptionOptions& options) {
  const std::optional<double>& rate = options.messagesPerSecond;
  if (!rate || (std::isfinite(*rate) && *rate > 0)) return;
  throw std::invalid_argument("a subscription at " + std::to_string(*rate) +
                              " messages a second: the rate must be above 0");
}

}  // namespace

Publisher::Publisher() = default;
Publisher::Publisher(std::unique_ptr<transport::PublisherState> state) : state_(std::move(state)) {}
Publisher::Publisher(Publisher&&) noexcept = default;
Publisher& Publisher::operator=(Publisher&&) noexcept = default;
Publisher::~Publisher() = default;

bool Publisher::hasSubscribers() const { return state_ && state_->bus.hasSubscribers(*state_); }

std::uint64_t Publisher::newSubscribers() { return state_ ? state_->bus.newSubscribers(*state_) : 0; }

void Publisher::publish(const Message& message) {
  if (state_) state_->bus.publish(*state_, message);
}

void Publisher::publish(const Message& message, const Bulk& bulk) {
  if (state_) state_->bus.publish(*state_, message, bulk);
}

void Publisher::publishBytes(std::span<const std::byte> bytes) {
  if (state_) state_->bus.publishBytes(*state_, bytes);
}

std::uint64_t Publisher::sent() const { return state_ ? state_->sent.load() : 0; }

bool Publisher::waitForSubscribers(std::chrono::nanoseconds timeout) const {
  return state_ && state_->bus.waitForSubscribers(*state_, timeout);
}

bool Publisher::waitForDelivery(std::chrono::nanoseconds timeout) const {
  return state_ && state_->bus.waitForDelivery(state_->channel, timeout);
}

Subscription::Subscription() = default;
Subscription::Subscription(std::unique_ptr<transport::SubscriptionState> state) : state_(std::move(state)) {}
Subscription::Subscription(Subscription&&) noexcept = default;
Subscription& Subscription::operator=(Subscription&&) noexcept = default;
Subscription::~Subscription() = default;

std::uint64_t Subscription::received() const { return state_ ? state_->received() : 0; }

std::uint64_t Subscription::dropped() const { return state_ ? state_->dropped() : 0; }

CallGuard::~CallGuard() = default;

Node Node::guardedBy(CallGuard& guard) const {
  Node node = *this;
  node.guard_ = &guard;
  return node;
}

Node Node::within(std::string_view nameSpace) const {
  Node node = *this;
  node.nameSpace_ = transport::absoluteTopic(fullName(nameSpace));
  return node;
}

Node Node::below(std::string_view nameSpace) const {
  Node node = within(nameSpace);
  node.nameSpace_ += "/";
  return node;
}

std::string Node::fullName(std::string_view name) const {
  if (nameSpace_.empty() || name.empty()) return std::string(name);
  if (nameSpace_.ends_with('/')) {
    if (name.starts_with(nameSpace_)) return std::string(name);
    return nameSpace_ + std::string(name.starts_with('/') ? name.substr(1) : name);
  }
  if (name.starts_with('/')) return std::string(name);
  return nameSpace_ + "/" + std::string(name);
}

void Node::wake() { bus_->wake(*queue_); }

Publisher Node::advertise(std::string_view topic, std::string_view type, const PublisherOptions& options) {
  return advertiseAs(transport::knownType(type), topic, options);
}

Publisher Node::advertiseBytes(std::string_view topic, std::string_view type, const PublisherOptions& options) {
  return advertiseAs(transport::anyType(type), topic, options);
}

Publisher Node::advertiseAs(const std::string& type, std::string_view topic, const PublisherOptions& options) {
  auto state = std::make_unique<transport::PublisherState>(*bus_, *queue_, fullName(topic), type, options);
  if (guard_ != nullptr) guard_->advertised(state->channel.topic, state->channel.type);
  return Publisher(std::move(state));
}

Subscription Node::subscribe(std::string_view topic, std::string_view type,
                             std::function<void(const Message&)> received, const SubscriptionOptions& options) {
  checkRate(options);
  const std::string name = transport::knownType(type);
  return Subscription(std::make_unique<transport::SubscriptionState>(*bus_, *queue_, fullName(topic), name,
                                                                     guarded(guard_, std::move(received)), options));
}

Subscription Node::subscribeBytes(std::string_view topic, std::string_view type,
                                  std::function<void(std::span<const std::byte>)> received,
                                  const SubscriptionOptions& options) {
  checkRate(options);
  const std::string name = transport::anyType(type);
  return Subscription(std::make_unique<transport::SubscriptionState>(*bus_, *queue_, fullName(topic), name,
                                                                     guarded(guard_, std::move(received)), options));
}

Subscription Node::subscribeAnyType(std::string_view topic, ReceivedOfAnyType received,
                                    const SubscriptionOptions& options) {
  checkRate(options);
  return Subscription(std::make_unique<transport::SubscriptionState>(*bus_, *queue_, fullName(topic),
                                                                     guarded(guard_, std::move(received)), options));
}

Subscription Node::subscribeAtOnce(std::string_view topic, std::string_view type, HeardAtOnce heard,
                                   const SubscriptionOptions& options) {
  checkRate(options);
  const std::string name = transport::knownType(type);
  return Subscription(std::make_unique<transport::SubscriptionState>(
      *bus_, *queue_, fullName(topic), name, guarded(guard_, std::move(heard), Moment::kPublish), options));
}

Subscription Node::subscribeBytesAtOnce(std::string_view topic, std::string_view type, HeardBytesAtOnce heard,
                                        const SubscriptionOptions& options) {
  checkRate(options);
  const std::string name = transport::anyType(type);
  return Subscription(std::make_unique<transport::SubscriptionState>(
      *bus_, *queue_, fullName(topic), name, guarded(guard_, std::move(heard), Moment::kPublish), options));
}

std::vector<OwnTopic> Node::ownTopics() const { return bus_->ownTopics(*queue_); }

std::uint64_t Node::ownTopicsVersion() const { return queue_->ownTopicsVersion.load(std::memory_order_relaxed); }

std::vector<OwnService> Node::ownServices() const { return bus_->ownServices(*queue_); }

std::uint64_t Node::ownServicesVersion() const { return bus_->ownServicesVersion(); }

Gateway::Gateway() = default;
Gateway::Gateway(std::unique_ptr<transport::GatewayState> state) : state_(std::move(state)) {}
Gateway::Gateway(Gateway&&) noexcept = default;
Gateway& Gateway::operator=(Gateway&&) noexcept = default;
Gateway::~Gateway() = default;

Gateway Node::openGateway(CallElsewhere call) {
  return Gateway(std::make_unique<transport::GatewayState>(*bus_, std::move(call)));
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
      ServiceAnswer answer = ServiceAnswer::refused("the system is switched off or set aside");
      guard->call(Moment::kDispatch, [&] {
        answer = ServiceAnswer::refused("the system failed");
        try {
          answer = inner(request, reply);
        } catch (const std::exception& error) {
          answer = ServiceAnswer::refused(error.what());
          throw;
        }
      });
      return answer;
    };
  }
  return Service(std::make_unique<transport::ServiceState>(*bus_, *queue_, fullName(service), requestType, replyType,
                                                           std::move(handler)));
}

CallResult Node::call(std::string_view service, const Message& request, Message& reply,
                      std::chrono::nanoseconds timeout) {
  return bus_->call(*queue_, fullName(service), request, reply, timeout);
}

PendingRequest::PendingRequest() = default;
PendingRequest::PendingRequest(std::unique_ptr<transport::RequestState> state) : state_(std::move(state)) {}
PendingRequest::PendingRequest(PendingRequest&&) noexcept = default;
PendingRequest& PendingRequest::operator=(PendingRequest&&) noexcept = default;
PendingRequest::~PendingRequest() = default;

PendingRequest Node::request(std::string_view service, const Message& request, std::string_view replyType,
                             Answered answered) {
  auto state = std::make_unique<transport::RequestState>(*bus_);
  state->number = bus_->request(*queue_, fullName(service), request, transport::knownType(replyType),
                                guarded(guard_, std::move(answered)));
  if (!state->number) return {};
  return PendingRequest(std::move(state));
}

Transport::Transport(const TransportOptions& options)
    : bus_(std::make_shared<transport::Bus>(
          options.network
              ? std::make_unique<transport::Network>(options.domain, options.interface, options.announceLater)
              : nullptr)),
      queue_(&bus_->addQueue()) {}

Transport::Transport(const Transport& other, Sharing) : bus_(other.bus_), queue_(&bus_->addQueue()) {}

Transport::~Transport() = default;

void Transport::announce() { bus_->announce(); }

std::optional<std::string> Transport::openTo() const {
  const std::optional<NetworkInterface> interface = bus_->interface();
  return interface ? std::optional(interface->name + ", " + interface->address) : std::nullopt;
}

std::size_t Transport::dispatch() { return bus_->dispatch(*queue_); }

std::size_t Transport::dispatchFor(std::chrono::nanoseconds timeout) { return bus_->dispatchFor(*queue_, timeout); }

void Transport::wake() { bus_->wake(*queue_); }

bool Transport::heardAll() const { return bus_->heardAll(); }

std::vector<TopicInfo> Transport::discover(std::chrono::nanoseconds timeout) { return bus_->discover(timeout); }

TopicInfo Transport::waitForTopic(std::string_view topic, bool wantPublisher, std::chrono::nanoseconds timeout) {
  return bus_->waitForTopic(topic, wantPublisher, timeout);
}

TopicInfo Transport::watchTopic(std::string_view topic, std::chrono::nanoseconds duration) {
  return bus_->watchTopic(topic, duration);
}

std::vector<ServiceInfo> Transport::discoverServices(std::chrono::nanoseconds timeout) {
  return bus_->discoverServices(timeout);
}

ServiceInfo Transport::waitForService(std::string_view service, std::chrono::nanoseconds timeout) {
  return bus_->waitForService(service, timeout);
}

}  // namespace pongsim
