#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "ign/courier.hh"
#include "ign/incoming_topic.hh"
#include "ign/outgoing_topic.hh"
#include "ign/remote_calls.hh"
#include "ign/services.hh"
#include "pongsim/log.hh"
#include "pongsim/node.hh"

namespace pongsim::ign {

/// Puts the topics and services of this transport on ign-transport, under their names: what its own publishers say goes
/// there while somebody listens there, what is said there goes to its own subscriptions. For the simulation's thread,
/// which calls nothing of the library's; must not outlive the transport.
class Bridge {
 public:
  /// @param log Must outlive it.
  /// @param address At which this process speaks ign-transport.
  Bridge(const Node& simulation, const Logger& log, const std::string& address);
  ~Bridge();
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;

  /// To be called in each step: follows topics, services and readers that have come or gone.
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
  void endService(const std::shared_ptr<OfferedService>& service);

  Node simulation_;
  const Logger& log_;
  std::uint64_t topicsVersion_;
  std::uint64_t servicesVersion_;
  std::atomic<bool> haveReadersChanged_ = false;
  std::atomic<bool> haveTypesCome_ = false;
  /// Of the courier's thread.
  std::unique_ptr<Services> offers_;
  Courier courier_;
  RemoteCalls calls_;
  Gateway gateway_;
  /// By name and type.
  std::map<std::pair<std::string, std::string>, Out> outgoing_;
  std::map<std::string, std::shared_ptr<IncomingTopic>> incoming_;
  std::map<std::string, std::shared_ptr<OfferedService>> services_;
};

}  // namespace pongsim::ign
