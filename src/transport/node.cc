#include "pongsim/node.hh"

#include <algorithm>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "transport/any_type.hh"
#include "transport/bus.hh"
#include "transport/deadline.hh"
#include "transport/names/topic_name.hh"
#include "transport/names/type_name.hh"

namespace pongsim {

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

void Node::wake() { bus_->delivery().wake(*queue_); }

Publisher Node::advertise(std::string_view topic, std::string_view type, const PublisherOptions& options) {
  return advertiseAs(transport::knownType(type), topic, options);
}

Publisher Node::advertiseBytes(std::string_view topic, std::string_view type, const PublisherOptions& options) {
  return advertiseAs(transport::anyType(type), topic, options);
}

Publisher Node::advertiseAs(const std::string& type, std::string_view topic, const PublisherOptions& options) {
  Publisher publisher(bus_->addPublisher(*queue_, fullName(topic), type, options, guard_).release());
  if (guard_ != nullptr) guard_->advertised(publisher.state_->channel.topic, type);
  return publisher;
}

Subscription Node::subscribe(std::string_view topic, std::string_view type,
                             std::function<void(const Message&)> received, const SubscriptionOptions& options) {
  const std::string name = transport::knownType(type);
  return {*bus_,
          {&bus_->addSubscription(*queue_, fullName(topic), name, std::move(received), options, guard_), nullptr}};
}

Subscription Node::subscribeBytes(std::string_view topic, std::string_view type,
                                  std::function<void(std::span<const std::byte>)> received,
                                  const SubscriptionOptions& options) {
  const std::string name = transport::anyType(type);
  return {*bus_,
          {&bus_->addSubscription(*queue_, fullName(topic), name, std::move(received), options, guard_), nullptr}};
}

Subscription Node::subscribeAnyType(std::string_view topic, ReceivedOfAnyType received,
                                    const SubscriptionOptions& options) {
  return {*bus_, {nullptr, &bus_->addAnyType(*queue_, fullName(topic), std::move(received), options, guard_)}};
}

Subscription Node::subscribeAtOnce(std::string_view topic, std::string_view type, HeardAtOnce heard,
                                   const SubscriptionOptions& options) {
  const std::string name = transport::knownType(type);
  return {*bus_, {&bus_->addSubscription(*queue_, fullName(topic), name, std::move(heard), options, guard_), nullptr}};
}

Subscription Node::subscribeBytesAtOnce(std::string_view topic, std::string_view type, HeardBytesAtOnce heard,
                                        const SubscriptionOptions& options) {
  const std::string name = transport::anyType(type);
  return {*bus_, {&bus_->addSubscription(*queue_, fullName(topic), name, std::move(heard), options, guard_), nullptr}};
}

void Subscription::End::operator()(transport::Bus* bus) const {
  if (inbox != nullptr) bus->end(*inbox);
  if (any != nullptr) bus->end(*any);
}

template <class Count>
std::uint64_t Subscription::sum(const Count& count) const {
  if (!bus_) return 0;
  transport::Delivery& delivery = bus_->delivery();
  const End& end = bus_.get_deleter();
  if (end.inbox != nullptr) return count(delivery, *end.inbox);
  std::uint64_t all = 0;
  for (const transport::Inbox* inbox : end.any->inboxesNow(delivery)) all += count(delivery, *inbox);
  return all;
}

std::uint64_t Subscription::received() const {
  return sum([](auto& delivery, const auto& inbox) { return delivery.received(inbox); });
}

std::uint64_t Subscription::dropped() const {
  return sum([](auto& delivery, const auto& inbox) { return delivery.dropped(inbox); });
}

std::vector<OwnTopic> Node::ownTopics() const { return bus_->ownTopics(*queue_); }

std::optional<std::string> Node::refusal(std::string_view topic, const Message& message) const {
  return bus_->refusal(*queue_, fullName(topic), message);
}

std::uint64_t Node::ownTopicsVersion() const { return queue_->ownTopicsVersion.load(std::memory_order_relaxed); }

std::vector<OwnService> Node::ownServices() const {
  std::vector<OwnService> services = bus_->server().services(*queue_);
  if (queue_->alsoLists == nullptr) return services;
  // if both offer a name, the other queue's service is listed
  std::vector<OwnService> others = bus_->server().services(*queue_->alsoLists);
  std::ranges::move(services, std::back_inserter(others));
  std::ranges::stable_sort(others, {}, &OwnService::name);
  const auto twice = std::ranges::unique(others, {}, &OwnService::name);
  others.erase(twice.begin(), twice.end());
  return others;
}

std::uint64_t Node::ownServicesVersion() const { return bus_->server().version(); }

Gateway Node::openGateway(CallElsewhere call) {
  Gateway gateway;
  const std::uint64_t number = bus_->client().addGateway(std::move(call));
  gateway.client_ = {&bus_->client(), {number}};
  return gateway;
}

void Gateway::End::operator()(transport::ServiceClient* client) const { client->endGateway(number); }

Service Node::serve(std::string_view service, std::string_view requestType, std::string_view replyType,
                    ServiceHandler handler) {
  if (guard_ != nullptr) {
    handler = [guard = guard_, inner = std::move(handler)](const Message& request, Message& reply) {
      ServiceAnswer answer = ServiceAnswer::refused("the system is switched off or set aside");
      guard->call(CallGuard::Moment::kDispatch, [&] {
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
  const bool isOfWorld = guard_ == nullptr || guard_->isOfWorld();
  return Service(*bus_,
                 bus_->addService(*queue_, fullName(service), requestType, replyType, std::move(handler), isOfWorld));
}

void Service::End::operator()(transport::Bus* bus) const { bus->end(*offer); }

CallResult Node::call(std::string_view service, const Message& request, Message& reply,
                      std::chrono::nanoseconds timeout) {
  if (queue_->dispatcher == std::this_thread::get_id()) {
    throw std::logic_error("a service was called within dispatch, which must not wait");
  }
  return bus_->client().call(*queue_, fullName(service), request, reply, transport::deadlineAfter(timeout));
}

PendingRequest Node::request(std::string_view service, const Message& request, std::string_view replyType,
                             Answered answered) {
  if (guard_ != nullptr && answered) {
    answered = [guard = guard_, inner = std::move(answered)](const CallResult& result, const Message& reply) {
      guard->call(CallGuard::Moment::kDispatch, [&] { inner(result, reply); });
    };
  }
  transport::ServiceClient& client = bus_->client();
  const bool isOwn = guard_ != nullptr && guard_->isActing();
  const std::optional<std::uint64_t> number =
      client.post(*queue_, fullName(service), request, transport::knownType(replyType), std::move(answered), isOwn);
  PendingRequest pending;
  if (number) pending.client_ = {&client, {*number}};
  return pending;
}

void PendingRequest::Forget::operator()(transport::ServiceClient* client) const { client->forget(number); }

}  // namespace pongsim
