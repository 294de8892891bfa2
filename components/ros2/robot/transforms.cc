#include "ros2/robot/transforms.hh"

#include <algorithm>
#include <utility>

#include "ros2/pairs/convert.hh"
#include "ros2/robot/odometry.hh"

namespace pongsim::ros2 {

namespace {

constexpr const char* kTransforms = "/tf";
constexpr const char* kStaticTransforms = "/tf_static";
constexpr Qos kTransformQos{.depth = 100};

void setTransform(const Pose& X_ParentChild, geometry_msgs::Transform& transform) {
  const Vector3& position = X_ParentChild.position;
  const Quaternion& rotation = X_ParentChild.rotation;
  transform.translation = {position.x(), position.y(), position.z()};
  transform.rotation = {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
}

Pose poseOf(const geometry_msgs::Transform& transform) {
  const auto& [x, y, z] = transform.translation;
  return {
      {x, y, z},
      Quaternion(transform.rotation.w, transform.rotation.x, transform.rotation.y, transform.rotation.z).normalized()};
}

geometry_msgs::TransformStamped between(const std::string& parent, const std::string& child,
                                        const Pose& X_ParentChild) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  setTransform(X_ParentChild, transform.transform);
  return transform;
}

}  // namespace

Transforms::Transforms(const Node& simulation, RosNode& ros, const Settings& settings,
                       const RobotSettings& robotSettings)
    : simulation_(simulation),
      ros_(ros),
      settings_(settings),
      robotSettings_(robotSettings),
      frames_(settings.frames),
      world_(frames_.toRos(robotSettings.worldFrame)),
      topicsVersion_(simulation_.ownTopicsVersion() - 1),
      schedule_(periodOf(robotSettings.transformRate)) {
  const auto changed = [this] { ++readersVersion_; };
  moving_.publisher = ros.advertise<tf2_msgs::TFMessage>(kTransforms, kTransformQos, changed);
  static_.publisher = ros.advertise<tf2_msgs::TFMessage>(kStaticTransforms, kLatchedQos, changed);
}

void Transforms::follow(const std::list<Robot>& robots, const std::list<Fixture>& fixtures) {
  fixtures_ = &fixtures;
  std::erase_if(robots_, [&robots](const RobotFrames& frames) {
    return std::ranges::none_of(robots, [&](const Robot& robot) { return robot.model.id() == frames.model; });
  });
  for (const Robot& robot : robots) {
    const auto known = std::ranges::find(robots_, robot.model.id(), &RobotFrames::model);
    RobotFrames& frames = known != robots_.end() ? *known : robots_.emplace_back();
    frames.model = robot.model.id();
    frames.robot = &robot;
  }
  topicsVersion_ = simulation_.ownTopicsVersion() - 1;
  mustRebuild_ = true;
}

void Transforms::preUpdate(Time now) {
  thread_ = std::this_thread::get_id();
  if (simulation_.ownTopicsVersion() != topicsVersion_) {
    topicsVersion_ = simulation_.ownTopicsVersion();
    followTopics();
  }
  if (readersVersion_.load(std::memory_order_relaxed) != knownReaders_) {
    knownReaders_ = readersVersion_;
    subscribe();
  }
  if (!mustRebuild_ && !mustPublishStatic_) return;
  if (!isRead()) return;
  if (mustRebuild_) rebuild();
  if (mustPublishStatic_ && static_.publisher->hasReaders()) publishStatic(now);
}

void Transforms::followTopics() {
  const std::vector<OwnTopic> topics = simulation_.ownTopics();
  followForeign(topics);
  for (RobotFrames& frames : robots_) {
    std::string topic = odometryTopic(frames.robot->model, topics);
    if (topic == frames.odometry) continue;
    frames.subscription = {};
    frames.odometry = std::move(topic);
    frames.odometryFrame.clear();
    frames.alias.clear();
    frames.isElsewhere = std::ranges::any_of(foreign_, [&frames](const Foreign& foreign) {
      return !foreign.isPublishedHere && foreign.topic == frames.odometry;
    });
    mustRebuild_ = true;
  }
  subscribe();
}

void Transforms::followForeign(const std::vector<OwnTopic>& topics) {
  const auto add = [this](const std::string& topic, bool isStatic, bool isPublishedHere) {
    const bool isKnown = std::ranges::any_of(foreign_, [&](const Foreign& known) {
      return known.topic == topic && known.isStatic == isStatic && known.isPublishedHere == isPublishedHere;
    });
    if (isKnown) return;
    Foreign& foreign = foreign_.emplace_back();
    foreign.topic = topic;
    foreign.isStatic = isStatic;
    foreign.isPublishedHere = isPublishedHere;
  };
  for (const TopicRule& rule : settings_.rules) {
    if (rule.pair == nullptr || rule.pair->ignition != "ignition.msgs.Pose_V") continue;
    if (rule.direction == Direction::kFromRos) continue;
    if (rule.ros == kTransforms || rule.ros == kStaticTransforms) {
      add(rule.ignition, rule.ros == kStaticTransforms, false);
    }
  }
  for (const OwnTopic& topic : topics) {
    const bool isStatic = topic.name == kStaticTransforms;
    if ((!isStatic && topic.name != kTransforms) || topic.type != "ignition.msgs.Pose_V") continue;
    // skips a topic that a rule bridges
    const bool hasRule = std::ranges::any_of(
        foreign_, [&topic](const Foreign& known) { return !known.isPublishedHere && known.topic == topic.name; });
    if (topic.publishers > 0 && !hasRule) add(topic.name, isStatic, true);
  }
}

void Transforms::subscribe() {
  const bool isWanted = isRead();
  for (RobotFrames& frames : robots_) {
    if (!isWanted || frames.odometry.empty()) {
      frames.subscription = {};
    } else if (!frames.subscription) {
      frames.subscription = simulation_.subscribeAtOnce(frames.odometry, "ignition.msgs.Pose_V",
                                                        [this, &frames](const pongsim::Message& message, const Bulk*) {
                                                          receiveOdometry(frames, static_cast<const Message&>(message));
                                                        },
                                                        {.relays = true});
    }
  }
  for (Foreign& foreign : foreign_) {
    // static transforms are published once: subscribes to them even without readers
    if (!isWanted && !foreign.isStatic) {
      foreign.subscription = {};
    } else if (!foreign.subscription) {
      foreign.subscription =
          simulation_.subscribeAtOnce(foreign.topic, "ignition.msgs.Pose_V",
                                      [this, &foreign](const pongsim::Message& message, const Bulk*) {
                                        receiveForeign(foreign, static_cast<const Message&>(message));
                                      },
                                      {.relays = true});
    }
  }
}

void Transforms::rebuild() {
  mustRebuild_ = false;
  mustPublishStatic_ = true;
  static_.message.transforms.clear();
  moving_.message.transforms.clear();
  movingFrames_.clear();
  children_.clear();
  for (const auto& [child, transform] : foreignStatic_) {
    children_.insert(child);
    static_.message.transforms.push_back(transform);
  }
  for (RobotFrames& frames : robots_) addTree(frames);
  if (fixtures_ == nullptr) return;
  for (const Fixture& fixture : *fixtures_) {
    for (const SensorFrame& frame : fixture.frames) addStatic(frame.parent, frame.frame, frame.X_ParentSensor);
  }
}

/// Marks the frame as one that has a parent.
/// @return Whether it had none before.
bool Transforms::claim(const std::string& child) {
  return !foreignChildren_.contains(child) && children_.insert(child).second;
}

void Transforms::addStatic(const std::string& parent, const std::string& child, const Pose& X_ParentChild) {
  if (claim(child)) static_.message.transforms.push_back(between(parent, child, X_ParentChild));
}

void Transforms::addTree(RobotFrames& frames) {
  const Robot& robot = *frames.robot;
  if (robot.tree.links.empty()) return;
  const std::string& root = robot.tree.links.front().frame;
  const bool hangsOnWorld = robotSettings_.groundTruth != "never" && frames.odometry.empty();
  if (!frames.odometry.empty() && !frames.isElsewhere) {
    // published with each odometry message
    claim(root);
  } else if (hangsOnWorld && root != world_ && claim(root)) {
    movingFrames_.push_back({&frames, TreeLink::kNone});
    moving_.message.transforms.push_back(between(world_, root, {}));
  }
  for (std::size_t i = 1; i < robot.tree.links.size() && robotSettings_.tellsLinks; ++i) {
    const TreeLink& link = robot.tree.links[i];
    const std::string& parent = robot.tree.links[link.parent].frame;
    if (link.motion == Motion::kFixed || (link.motion != Motion::kFree && !link.source)) {
      addStatic(parent, link.frame, link.X_ParentLink);
    } else if (claim(link.frame)) {
      movingFrames_.push_back({&frames, i});
      moving_.message.transforms.push_back(between(parent, link.frame, {}));
    }
  }
  for (const SensorFrame& sensor : robot.sensors) addStatic(sensor.parent, sensor.frame, sensor.X_ParentSensor);
  if (frames.alias.empty()) return;
  // odometry refers to the canonical link
  const std::optional<Link> canonical = robot.model.canonicalLink();
  const std::size_t base = (canonical ? robot.tree.find(canonical->id()) : std::nullopt).value_or(0);
  if (frames.isElsewhere) {
    addStatic(frames.alias, root, robot.tree.poseInRoot(base, robot.model).inverse());
  } else {
    addStatic(robot.tree.links[base].frame, frames.alias, {});
  }
}

bool Transforms::isAbout(const RobotFrames& frames, const std::string& parent, const std::string& child) const {
  const Robot& robot = *frames.robot;
  const std::string name = frames_.toRos(robot.name);
  if (parent.empty() || child.empty() || parent == name || robot.tree.find(parent)) return false;
  if (robot.tree.find(child) || child == name || child.starts_with(name + "/")) return true;
  // on a topic that only this robot uses, any name refers to it
  return std::ranges::count(robots_, frames.odometry, &RobotFrames::odometry) == 1;
}

void Transforms::receiveOdometry(RobotFrames& frames, const Message& message) {
  // other threads must not read the links' poses; the odometry of the world's systems is published on this one
  if (std::this_thread::get_id() != thread_) return;
  const Robot& robot = *frames.robot;
  // a robot attached to the world does not move: its odometry is ignored
  if (robot.tree.links.empty() || (!robot.tree.links.front().link && robot.model.urdf() == nullptr)) return;
  for (const auto& pose : message.pose()) {
    geometry_msgs::TransformStamped X_OdometryBase;
    convert(pose, X_OdometryBase, frames_);
    if (!isAbout(frames, X_OdometryBase.header.frame_id, X_OdometryBase.child_frame_id)) continue;
    std::optional<std::size_t> base = robot.tree.find(X_OdometryBase.child_frame_id);
    const std::string alias = base ? "" : X_OdometryBase.child_frame_id;
    if (frames.odometryFrame != X_OdometryBase.header.frame_id || frames.alias != alias) {
      frames.odometryFrame = X_OdometryBase.header.frame_id;
      frames.alias = alias;
      mustRebuild_ = true;
    }
    if (frames.isElsewhere) return;
    if (!base) {
      const std::optional<Link> canonical = robot.model.canonicalLink();
      base = (canonical ? robot.tree.find(canonical->id()) : std::nullopt).value_or(0);
    }
    const Pose X_OdometryRoot = poseOf(X_OdometryBase.transform) * robot.tree.poseInRoot(*base, robot.model).inverse();
    const bool isTrue = robotSettings_.groundTruth == "always" && X_OdometryBase.header.frame_id != world_;
    frames.message.transforms.resize(isTrue ? 2 : 1);
    if (isTrue) {
      geometry_msgs::TransformStamped& truth = frames.message.transforms[1];
      truth.header.stamp = X_OdometryBase.header.stamp;
      truth.header.frame_id = world_;
      truth.child_frame_id = X_OdometryBase.header.frame_id;
      setTransform(robot.tree.rootPose(robot.model) * X_OdometryRoot.inverse(), truth.transform);
    }
    X_OdometryBase.child_frame_id = robot.tree.links.front().frame;
    if (*base != 0) setTransform(X_OdometryRoot, X_OdometryBase.transform);
    frames.message.transforms[0] = std::move(X_OdometryBase);
    if (moving_.publisher->hasReaders()) moving_.publisher->publish(frames.message);
    return;
  }
}

bool Transforms::isOdometry(const std::string& topic, const geometry_msgs::TransformStamped& transform) const {
  return std::ranges::any_of(robots_, [&](const RobotFrames& frames) {
    return frames.odometry == topic && isAbout(frames, transform.header.frame_id, transform.child_frame_id);
  });
}

void Transforms::receiveForeign(Foreign& foreign, const Message& message) {
  if (std::this_thread::get_id() != thread_) return;
  tf2_msgs::TFMessage passedOn;
  for (const auto& pose : message.pose()) {
    geometry_msgs::TransformStamped transform;
    convert(pose, transform, frames_);
    if (transform.child_frame_id.empty()) continue;
    if (!foreign.isPublishedHere) {
      mustRebuild_ |= foreignChildren_.insert(transform.child_frame_id).second;
    } else if (foreign.isStatic) {
      geometry_msgs::TransformStamped& known = foreignStatic_[transform.child_frame_id];
      if (known == transform) continue;
      known = std::move(transform);
      mustRebuild_ = true;
    } else if (!children_.contains(transform.child_frame_id) && !isOdometry(foreign.topic, transform)) {
      passedOn.transforms.push_back(std::move(transform));
    }
  }
  if (!passedOn.transforms.empty() && moving_.publisher->hasReaders()) moving_.publisher->publish(passedOn);
}

void Transforms::publishStatic(Time now) {
  mustPublishStatic_ = false;
  // nodes keep static frames, so that an empty message has no effect
  if (static_.message.transforms.empty()) return;
  for (geometry_msgs::TransformStamped& transform : static_.message.transforms) {
    transform.header.stamp = stampOf(now, frames_);
  }
  static_.publisher->publish(static_.message);
}

void Transforms::postUpdate(Time now) {
  if (!moving_.publisher->hasReaders() || mustRebuild_ || movingFrames_.empty() || !schedule_.isDue(now)) return;
  const builtin_interfaces::Time stamp = stampOf(now, frames_);
  for (std::size_t i = 0; i < movingFrames_.size(); ++i) {
    const Moving& moving = movingFrames_[i];
    const Robot& robot = *moving.frames->robot;
    geometry_msgs::TransformStamped& transform = moving_.message.transforms[i];
    transform.header.stamp = stamp;
    setTransform(moving.link == TreeLink::kNone ? robot.tree.rootPose(robot.model)
                                                : robot.tree.poseInParent(moving.link, robot.model),
                 transform.transform);
  }
  moving_.publisher->publish(moving_.message);
}

}  // namespace pongsim::ros2
