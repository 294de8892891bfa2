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

/// Tells /tf and /tf_static where the frames of robots and sensors are. Each frame has one parent:
///
/// - of a robot's topmost frame that of its odometry, else the world;
/// - of a link what its joint hangs on, by the joint's position;
/// - of a sensor its link.
///
/// Frames that topics of the simulation bring to /tf because a rule says so are left to those. Nothing is worked out
/// where nobody reads. For the simulation's thread.
class Transforms {
 public:
  Transforms(const Node& simulation, RosNode& ros, const Settings& settings, const RobotSettings& robotSettings);

  /// Follows robots that have come or gone. `robots` must be there until the next call.
  void follow(std::list<Robot>& robots, const std::list<Fixture>& fixtures);
  /// In each step before the physics: follows topics and readers, and tells the static frames to who has come.
  void preUpdate(Time now);
  /// In each step after the physics.
  void postUpdate(Time now);
  /// Time begins anew.
  void reset() { schedule_.reset(); }

 private:
  using Message = ignition::msgs::Pose_V;
  /// What a robot's odometry has told.
  struct RobotFrames {
    Robot* robot = nullptr;
    /// In the simulation; empty where there is none.
    std::string odometry;
    /// Whether a rule brings that topic to /tf by itself.
    bool isElsewhere = false;
    /// Where its odometry says that it starts; empty as long as it has said nothing.
    std::string odometryFrame;
    /// What its odometry calls it, where no link has that name.
    std::string alias;
    tf2_msgs::TFMessage message;
    Subscription heard;
  };
  /// A transform of /tf that is made anew each time.
  struct Moving {
    RobotFrames* frames = nullptr;
    /// TreeLink::kNone: of the root in the world.
    std::size_t link = 0;
  };
  /// What others bring to /tf.
  struct Foreign {
    std::string topic;
    bool isStatic = false;
    /// Whether it is told here, and not by a rule.
    bool isTold = false;
    Subscription heard;
  };

  /// A topic of ROS.
  struct Way {
    std::unique_ptr<RosPublisher> publisher;
    tf2_msgs::TFMessage message;
  };

  void followTopics();
  void followForeign(const std::vector<OwnTopic>& topics);
  void listen();
  void rebuild();
  void addTree(RobotFrames& frames);
  void addStatic(const std::string& parent, const std::string& child, const Pose& X_ParentChild);
  bool claim(const std::string& child);
  void hearOdometry(RobotFrames& frames, const Message& message);
  bool isOdometry(const std::string& topic, const geometry_msgs::TransformStamped& transform) const;
  bool isAbout(const RobotFrames& frames, const std::string& parent, const std::string& child) const;
  void hearForeign(Foreign& foreign, const Message& message);
  void tellStatic(Time now);
  bool isRead() const { return moving_.publisher->hasReaders() || static_.publisher->hasReaders(); }

  Node simulation_;
  RosNode& ros_;
  Settings settings_;
  RobotSettings robotSettings_;
  Frames frames_;
  std::string world_;
  std::atomic<std::uint64_t> readersVersion_ = 1;
  Way moving_;
  Way static_;
  std::uint64_t knownReaders_ = 0;
  std::uint64_t topicsVersion_ = 0;
  bool mustRebuild_ = true;
  bool mustTellStatic_ = false;
  std::list<RobotFrames> robots_;
  const std::list<Fixture>* fixtures_ = nullptr;
  std::list<Foreign> foreign_;
  /// Frames whose parent others tell.
  std::set<std::string> foreignChildren_;
  /// Frames that have a parent.
  std::set<std::string> children_;
  std::map<std::string, geometry_msgs::TransformStamped> foreignStatic_;
  std::vector<Moving> movingFrames_;
  /// The simulation's.
  std::thread::id thread_;
  Schedule schedule_;
};

}  // namespace pongsim::ros2
