#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ign/courier.hh"
#include "ign/generation.hh"
#include "ign/incoming_topic.hh"
#include "ign/outgoing_topic.hh"
#include "ign/remote_calls.hh"
#include "ign/services.hh"
#include "ign/subscriber_list.hh"
#include "pongsim/log.hh"
#include "pongsim/node.hh"

namespace pongsim::ign {

/// Connects a transport's topics and services with ign-transport, under the same names. Messages of the transport's own
/// publishers are sent to ign-transport while it has subscribers; messages published on ign-transport are delivered to
/// the transport's own subscriptions. For the simulation's thread, on which no function of the library is called. Must
/// not outlive the transport.
class Bridge {
 public:
  /// @param log Must outlive this.
  /// @param address IPv4 address at which this process uses ign-transport.
  Bridge(const Node& simulation, const Logger& log, const std::string& address, Generation generation);
  ~Bridge();
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;

  /// To be called in each step: handles topics, services and subscribers that were added or removed.
  void update();

 private:
  struct Out {
    std::shared_ptr<OutgoingTopic> topic;
    Subscription heard;
  };

  void followTopics();
  void followOutgoing(const std::vector<OwnTopic>& topics);
  void followIncoming(const std::vector<OwnTopic>& topics);
  void followReaders();
  void followServices();
  void listSubscriptions();
  void endService(const std::shared_ptr<OfferedService>& service);

  Node simulation_;
  const Logger& log_;
  const Generation generation_;
  std::uint64_t topicsVersion_;
  std::uint64_t servicesVersion_;
  std::atomic<bool> haveReadersChanged_ = false;
  std::atomic<bool> haveTypesCome_ = false;
  std::atomic<bool> areSubscribersAsked_ = false;
  /// Only used on the courier's thread.
  std::unique_ptr<Services> offers_;
  const SubscriberList subscribers_;
  Courier courier_;
  RemoteCalls calls_;
  Gateway gateway_;
  /// Keyed by name and type.
  std::map<std::pair<std::string, std::string>, Out> outgoing_;
  std::map<std::string, std::shared_ptr<IncomingTopic>> incoming_;
  /// Names and types of the topics to which the world subscribes.
  std::vector<std::pair<std::string, std::string>> subscriptions_;
  std::map<std::string, std::shared_ptr<OfferedService>> services_;
};

}  // namespace pongsim::ign
