#pragma once

#include <ignition/msgs/pose_v.pb.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/node.hh"
#include "pongsim/parameters.hh"
#include "ros2/config/settings.hh"
#include "ros2/node/node.hh"
#include "ros2/robot/robot_list.hh"
#include "ros2/robot/stamps.hh"
#include "ros2/types/tf2_msgs.hh"

namespace pongsim::ros2 {

/// Publishes the frames of robots and sensors on /tf and /tf_static. Each frame has one parent:
///
/// - the root frame of a robot: the frame of its odometry, else the world;
/// - a link: the link that its joint connects it to, using the joint's position;
/// - a sensor: its link.
///
/// Frames that a rule bridges to /tf from a topic of the simulation are left to that topic. Nothing is computed while
/// nobody subscribes. For the simulation's thread.
class Transforms {
 public:
  Transforms(const Node& simulation, RosNode& ros, const Settings& settings, const RobotSettings& robotSettings);

  /// Handles added and removed robots. `robots` must exist until the next call.
  void follow(const std::list<Robot>& robots, const std::list<Fixture>& fixtures);
  /// Call in each step before the physics: handles topics and subscribers, and sends static frames to new subscribers.
  void preUpdate(Time now);
  /// Call in each step after the physics.
  void postUpdate(Time now);
  /// @return The frames whose parent is published here.
  const std::set<std::string>& children() const { return children_; }
  /// Call when time starts again.
  void reset() { schedule_.reset(); }

 private:
  using Message = ignition::msgs::Pose_V;
  /// What is known from a robot's odometry.
  struct RobotFrames {
    /// Identifies the robot: another one may get its place in memory.
    ModelId model{};
    const Robot* robot = nullptr;
    /// Topic in the simulation; empty if there is none.
    std::string odometry;
    /// Whether a rule already bridges that topic to /tf.
    bool isElsewhere = false;
    /// The frame in which its odometry is given; empty until it has published.
    std::string odometryFrame;
    /// The odometry's name for the robot's frame, if no link has that name.
    std::string alias;
    tf2_msgs::TFMessage message;
    Subscription subscription;
  };
  /// A transform on /tf that is computed each time.
  struct Moving {
    RobotFrames* frames = nullptr;
    /// TreeLink::kNone: the root's pose in the world.
    std::size_t link = 0;
  };
  /// Transforms that other sources provide on /tf.
  struct Foreign {
    std::string topic;
    bool isStatic = false;
    /// Whether it is published here, and not by a rule.
    bool isPublishedHere = false;
    Subscription subscription;
  };

  /// A topic with transforms, and the message for it.
  struct TransformTopic {
    std::unique_ptr<RosPublisher> publisher;
    tf2_msgs::TFMessage message;
  };

  void followTopics();
  void followForeign(const std::vector<OwnTopic>& topics);
  void subscribe();
  void rebuild();
  void addTree(RobotFrames& frames);
  void addStatic(const std::string& parent, const std::string& child, const Pose& X_ParentChild);
  bool claim(const std::string& child);
  void receiveOdometry(RobotFrames& frames, const Message& message);
  bool isOdometry(const std::string& topic, const geometry_msgs::TransformStamped& transform) const;
  bool isAbout(const RobotFrames& frames, const std::string& parent, const std::string& child) const;
  void receiveForeign(Foreign& foreign, const Message& message);
  void publishStatic(Time now);
  bool isRead() const { return moving_.publisher->hasReaders() || static_.publisher->hasReaders(); }

  Node simulation_;
  RosNode& ros_;
  Settings settings_;
  RobotSettings robotSettings_;
  Frames frames_;
  std::string world_;
  std::atomic<std::uint64_t> readersVersion_ = 1;
  TransformTopic moving_;
  TransformTopic static_;
  std::uint64_t knownReaders_ = 0;
  std::uint64_t topicsVersion_ = 0;
  bool mustRebuild_ = true;
  bool mustPublishStatic_ = false;
  std::list<RobotFrames> robots_;
  const std::list<Fixture>* fixtures_ = nullptr;
  std::list<Foreign> foreign_;
  /// Frames whose parent is published by others.
  std::set<std::string> foreignChildren_;
  /// Frames that have a parent.
  std::set<std::string> children_;
  std::map<std::string, geometry_msgs::TransformStamped> foreignStatic_;
  std::vector<Moving> movingFrames_;
  /// The simulation's thread.
  std::thread::id thread_;
  Schedule schedule_;
};

}  // namespace pongsim::ros2
