#pragma once

#include <atomic>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pongsim/node.hh"
#include "ros2/bridge/mismatches.hh"
#include "ros2/config/settings.hh"
#include "ros2/node/node.hh"

namespace pongsim::ros2 {

/// Carries messages between the topics of the simulation and those of ROS: the ones that rules name as they say, all
/// others that have a pair under their own names, each in the directions in which the simulation uses it. Nothing is
/// listened to in the simulation before a node of ROS listens, so that nothing is made for nobody, unless a rule says
/// otherwise.
///
/// Messages to ROS are written to the wire from within the simulation's `publish`; those from ROS are read on DDS's
/// thread and published from there. It is otherwise for the simulation's thread, and must not outlive the nodes.
class Bridge {
 public:
  /// What is bridged, for who asks.
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

  /// A name of ROS that somebody else serves, so that no topic of the simulation is bridged to it unless a rule says
  /// so.
  void reserve(const std::string& rosName) { reserved_.insert(rosName); }

  /// To be called in each step: follows topics and readers that have come or gone, and warns of nodes that never meet
  /// what is bridged.
  void update();

  std::vector<Topic> topics() const;

  // Settings that may change while it runs, from the next `update` on.

  /// Whether topics without a rule are bridged.
  void setBridgesAll(bool all);
  /// Whether messages to ROS are stamped with the time of the wall. What is latched is told again.
  void setWallTime(bool isUsed);

 private:
  struct Entry;
  struct Wanted {
    bool toRos = false;
    bool fromRos = false;
    bool isLatched = false;
  };

  void followTopics();
  void followRules(const std::vector<OwnTopic>& topics);
  void followReaders();
  void followListeners();
  void warnOfOtherTypes(const TopicRule& rule, const std::vector<OwnTopic>& topics);
  bool isTakenByRule(const TopicRule& automatic);
  Entry* entryFor(const TopicRule& rule);
  void want(Entry& entry, const Wanted& wanted);
  void openToRos(Entry& entry, bool isLatched);
  void openFromRos(Entry& entry);
  void read(Entry& entry);
  void listen(Entry& entry);
  std::vector<Offer> offers() const;
  Frames framesOf(const TopicRule& rule) const;

  Node simulation_;
  RosNode& ros_;
  Settings settings_;
  std::set<std::string> reserved_;
  /// Complained of once.
  std::set<std::string> refusedNames_;
  std::uint64_t topicsVersion_ = 0;
  std::atomic<std::uint64_t> readersVersion_ = 1;
  std::uint64_t knownReaders_ = 0;
  /// Whether topics of ROS are read only while somebody listens in the simulation.
  bool hasLazyReaders_ = false;
  std::list<Entry> entries_;
  Mismatches mismatches_;
};

}  // namespace pongsim::ros2
