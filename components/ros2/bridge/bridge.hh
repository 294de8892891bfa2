#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/node.hh"
#include "ros2/bridge/mismatches.hh"
#include "ros2/bridge/noise_variances.hh"
#include "ros2/config/settings.hh"
#include "ros2/node/node.hh"

namespace pongsim::ros2 {

/// Passes messages between the topics of the simulation and those of ROS. Topics named in rules follow those, all
/// others that have a pair keep their names and are bridged in the directions in which the simulation uses them. Unless
/// a rule says otherwise, the simulation's topics are subscribed to only while a ROS node subscribes, so that nothing
/// is computed without need.
///
/// Messages to ROS are written to the wire inside the simulation's `publish`; those from ROS are read on DDS's thread
/// and published from there. Everything else is for the simulation's thread. Must not outlive the nodes.
class Bridge {
 public:
  /// What is bridged, for the service that lists it.
  struct Topic {
    std::string ros;
    std::string ignition;
    const Pair* pair = nullptr;
    bool isToRos = false;
    bool isFromRos = false;
    std::size_t readers = 0;
    std::size_t writers = 0;
    std::uint64_t sent = 0;
    std::uint64_t received = 0;
    std::uint64_t dropped = 0;
    std::uint64_t refused = 0;
  };

  Bridge(const Node& simulation, RosNode& ros, const Settings& settings);
  ~Bridge();
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;

  /// Reserves a ROS name used by somebody else, so that no topic of the simulation is bridged to it unless a rule asks
  /// for it.
  void reserve(const std::string& rosName) { reserved_.insert(rosName); }

  /// @param variances Called when topics come or go.
  void useVariances(std::function<NoiseVariances()> variances) { readVariances_ = std::move(variances); }

  /// Call in each step: handles added and removed topics and readers, and warns about nodes that can't connect to a
  /// bridged topic.
  void update();

  std::vector<Topic> topics() const;

  // Settings that can change at run time, effective from the next `update` on.

  /// Whether topics without a rule are bridged.
  void setBridgesAll(bool all);
  /// Whether messages to ROS are stamped with wall time. Latched messages are sent again.
  void setWallTime(bool isUsed);

 private:
  struct BridgedTopic;
  struct Directions {
    bool toRos = false;
    bool fromRos = false;
    bool isLatched = false;
  };

  void followTopics();
  void followRules(const std::vector<OwnTopic>& topics);
  void followReaders();
  void followSubscribers();
  void warnOfOtherTypes(const TopicRule& rule, const std::vector<OwnTopic>& topics);
  bool isTakenByRule(const TopicRule& automatic);
  BridgedTopic* bridgedTopic(const TopicRule& rule);
  void want(BridgedTopic& bridged, const Directions& wanted);
  void openToRos(BridgedTopic& bridged, bool isLatched);
  void openFromRos(BridgedTopic& bridged);
  void read(BridgedTopic& bridged);
  void subscribe(BridgedTopic& bridged);
  std::vector<Offer> offers() const;
  Frames framesOf(const TopicRule& rule) const;
  void followFrames();

  Node simulation_;
  RosNode& ros_;
  Settings settings_;
  std::function<NoiseVariances()> readVariances_;
  NoiseVariances variances_;
  std::set<std::string> reserved_;
  /// Names already warned about.
  std::set<std::string> refusedNames_;
  std::uint64_t topicsVersion_ = 0;
  std::atomic<std::uint64_t> readersVersion_ = 1;
  std::uint64_t knownReaders_ = 0;
  /// Whether ROS topics are read only while somebody in the simulation subscribes.
  bool hasLazyReaders_ = false;
  std::list<BridgedTopic> bridged_;
  Mismatches mismatches_;
};

}  // namespace pongsim::ros2
