#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pongsim/node.hh"
#include "transport/channel.hh"
#include "transport/delivery.hh"
#include "transport/dispatch_queue.hh"
#include "transport/locks.hh"
#include "transport/names/topic_name.hh"
#include "transport/publisher.hh"
#include "transport/services/service_client.hh"
#include "transport/services/service_server.hh"

namespace pongsim::transport {

class AnyType;
class Interceptor;
class Network;
struct TrafficReport;

/// The topics and services of one `Transport`, or of several that share it, each with its own queue: sets up publishers
/// and subscriptions, and dispatches.
class Bus {
 public:
  /// @param network Null for a transport within this process.
  explicit Bus(std::unique_ptr<Network> network);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  /// Null for a transport within this process.
  Network* network() { return network_.get(); }
  Delivery& delivery() { return delivery_; }
  ServiceServer& server() { return server_; }
  ServiceClient& client() { return client_; }

  /// @return A queue that exists as long as the bus.
  DispatchQueue& addQueue();

  /// Types are full names; `queue` is that of the calling transport.
  /// @throws std::invalid_argument for an invalid topic name; std::runtime_error if DDS refuses.
  std::unique_ptr<PublisherState> addPublisher(DispatchQueue& queue, std::string_view topic, const std::string& type,
                                               const PublisherOptions& options, const CallGuard* guard);
  void end(PublisherState& publisher);
  Inbox& addSubscription(DispatchQueue& queue, std::string_view topic, const std::string& type,
                         Inbox::Function function, const SubscriptionOptions& options, CallGuard* guard);
  void end(Inbox& inbox);
  /// A subscription to messages of any type.
  AnyType& addAnyType(DispatchQueue& queue, std::string_view topic, ReceivedOfAnyType received,
                      const SubscriptionOptions& options, CallGuard* guard);
  void end(AnyType& any);
  /// @throws std::invalid_argument if another one has the topic.
  void add(Interceptor& interceptor);
  void end(Interceptor& interceptor);
  /// Gives a message to the subscriptions of the interceptor's queue as if it came from elsewhere, but not to the
  /// interceptor itself.
  void sendInside(const Interceptor& interceptor, std::string_view type, std::span<const std::byte> bytes,
                  bool isCarried);
  Offer& addService(DispatchQueue& queue, std::string_view service, std::string_view requestType,
                    std::string_view replyType, ServiceHandler handler, bool isOfWorld);
  void end(Offer& offer);

  /// The topics of the queue's transport.
  std::vector<OwnTopic> ownTopics(const DispatchQueue& queue);

  std::size_t dispatch(DispatchQueue& queue);
  /// Handles requests and responses only, up to the queue's limit of a gate.
  std::size_t serve(DispatchQueue& queue, std::uint64_t requestLimit);
  void setRequestLimit(DispatchQueue& queue, std::uint64_t limit);
  /// Drops what waits for `dispatch`, as `Transport::discard` says.
  void discard(DispatchQueue& queue);

  /// @return Why a subscription of the queue's transport refuses the message, or nothing.
  std::optional<std::string> refusal(const DispatchQueue& queue, std::string_view topic, const Message& message);

  /// @return Whether somebody outside of the queue's transport, or a carrier for somebody, subscribes to its topic, or
  /// to any of its topics if the name is empty.
  bool isHeardOutside(const DispatchQueue& queue, std::string_view topic);
  /// @return Who publishes on the topic outside of the queue's transport: "process 1234"; "another network" where only
  /// carriers could; empty if nobody does.
  std::string publishersOutside(const DispatchQueue& queue, std::string_view topic);

  /// Warns of a message that can't be used, but not too often.
  void complain(Channel& channel, const ParticipantId& sender, std::string_view what);

 private:
  template <class HandOver>
  std::size_t inDispatch(DispatchQueue& queue, const HandOver& handOver) REQUIRES(dispatchingRole);
  template <class Add>
  auto inChannel(std::string_view topic, const std::string& type, const Add& add) REQUIRES(setUpRole);
  void endUnused(Channel& channel) REQUIRES(setUpRole);
  Inbox& addInbox(std::unique_ptr<Inbox> inbox) REQUIRES(setUpRole);
  void openReader(Channel& channel) REQUIRES(setUpRole);
  Interceptor* interceptorOf(const std::string& topic) const REQUIRES(setUpRole);
  bool handOver(const Arrival& arrival) REQUIRES(dispatchingRole);
  bool handOver(Inbox& inbox, Parcel& parcel) REQUIRES(dispatchingRole);
  void receive(Channel& channel, const ParticipantId& sender, Buffer& sample);
  TrafficReport traffic();

  // input_gate.cc
  void note(DispatchQueue& queue) REQUIRES(dispatchingRole);
  void replace(DispatchQueue& queue) REQUIRES(dispatchingRole);
  Inbox* findInbox(DispatchQueue& queue, const Intake::Place& place);

  // any_type.cc
  std::vector<AnyType*> anyTypesOn(const std::string& topic);
  std::vector<std::string> typesOn(const std::string& topic) const REQUIRES(setUpRole);
  void endAnnouncement(AnyType& any) REQUIRES(setUpRole);
  std::unique_ptr<AnyType> takeAnyType(const AnyType& any) REQUIRES(setUpRole);
  void hear(AnyType& any, const std::string& type) noexcept REQUIRES(setUpRole);
  void addInboxOf(AnyType& any, const std::string& type) REQUIRES(setUpRole);
  void publisherFound(const std::string& topic, const std::string& type);
  void hearFoundTypes(DispatchQueue& queue);

  /// Guards the adding and removing of endpoints.
  std::mutex setUp_;
  /// Declared before members with threads that may access it.
  std::vector<std::unique_ptr<DispatchQueue>> queues_ GUARDED_BY(setUpRole);
  const std::unique_ptr<Network> network_;
  std::map<std::pair<std::string, std::string>, std::unique_ptr<Channel>> channels_ GUARDED_BY(setUpRole);
  std::vector<Interceptor*> interceptors_ GUARDED_BY(setUpRole);
  /// Changed with the set-up mutex held, too.
  std::vector<std::unique_ptr<AnyType>> anyTypes_ GUARDED_BY(waitingRole);
  Delivery delivery_;
  ServiceServer server_;
  ServiceClient client_;
};

/// @return What `add` returns for the channel of a topic; if it throws, the channel goes too, unless it is used.
template <class Add>
auto Bus::inChannel(std::string_view topic, const std::string& type, const Add& add) {
  const std::pair name(absoluteTopic(topic), type);
  auto found = channels_.find(name);
  if (found == channels_.end()) {
    auto channel = std::make_unique<Channel>(name.first, type, delivery_.spareOf(type));
    channel->interceptor = interceptorOf(name.first);
    found = channels_.emplace(name, std::move(channel)).first;
  }
  Channel& channel = *found->second;
  try {
    return add(channel);
  } catch (...) {
    endUnused(channel);
    throw;
  }
}

}  // namespace pongsim::transport
