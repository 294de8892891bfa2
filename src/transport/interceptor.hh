#pragma once

#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "pongsim/interception.hh"
#include "pongsim/node.hh"
#include "transport/locks.hh"

namespace pongsim::transport {

class Bus;
class Channel;
class DispatchQueue;
class Parcel;

/// What an `Interception` has.
class Interceptor {
 public:
  Interceptor(Bus& bus, DispatchQueue& queue, Node node, std::string topic, Interception::Taken taken);

  Bus& bus;
  DispatchQueue& queue;
  const std::string topic;

  /// Takes an outgoing message. @param pass Publishes it.
  void takeOutgoing(std::string_view type, std::span<const std::byte> bytes,
                    const std::function<void(std::span<const std::byte>)>& pass);

  /// Takes an incoming message, once for all subscriptions that have it.
  /// @return What goes on, until the next call or `release`.
  std::span<Parcel* const> takeIncoming(Channel& channel, Parcel& parcel);
  void release();

  Publisher& publisherOf(std::string_view type);

 private:
  void call(const Interception::Crossing& crossing);

  Node node_;
  Interception::Taken taken_;
  /// A publisher may use another thread than `dispatch`.
  std::recursive_mutex calling_;
  const Parcel* last_ = nullptr;
  std::vector<Parcel*> passed_;
  /// By type, for what is sent later.
  std::map<std::string, Publisher, std::less<>> publishers_;
};

}  // namespace pongsim::transport
