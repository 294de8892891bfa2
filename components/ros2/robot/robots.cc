#include "ros2/robot/robots.hh"

#include <algorithm>
#include <utility>

namespace pongsim::ros2 {

namespace {

constexpr const char* kDescription = "robot_description";
constexpr const char* kJointStates = "joint_states";

}  // namespace

Robots::Robots(const World& world, const Node& simulation, RosNode& ros, Bridge& bridge, const Settings& settings,
               const RobotSettings& robotSettings)
    : ros_(ros),
      settings_(settings),
      robotSettings_(robotSettings),
      list_(world, settings.frames, robotSettings),
      jointStates_(ros, settings.frames, robotSettings.jointStateRate),
      descriptions_(world, ros),
      rivals_(ros) {
  if (robotSettings.tellsTransforms) {
    bridge.reserve("/tf");
    bridge.reserve("/tf_static");
    transforms_.emplace(simulation, ros, settings, robotSettings);
    rivals_.watchTransforms();
  }
  if (robotSettings.tellsDescription) bridge.reserve(plainName(kDescription));
  if (robotSettings.tellsJointStates) bridge.reserve(plainName(kJointStates));
}

std::string Robots::plainName(const char* topic) const { return absoluteName(settings_.nameSpace, topic); }

std::string Robots::nameOf(const Robot& robot, const char* topic) const {
  return absoluteName(settings_.nameSpace, rosNameFor("/" + robot.name + "/" + topic).substr(1));
}

bool Robots::isRuled(const std::string& rosName) const {
  return left_.contains(rosName) || std::ranges::any_of(settings_.rules, [&rosName](const TopicRule& rule) {
           return rule.pair != nullptr && rule.ros == rosName && rule.direction != Direction::kFromRos;
         });
}

void Robots::leave(std::set<std::string> topics) {
  left_ = std::move(topics);
  hasChanged_ = mustRename_ = true;
}

void Robots::preUpdate(Time now) {
  if (hasChanged_) follow();
  lookForOthers(now);
  descriptions_.preUpdate();
  if (transforms_) transforms_->preUpdate(now);
}

/// Two publishers of the same frames or joints, and readers jump between them.
void Robots::lookForOthers(Time now) {
  if (!looks_.isDue(now)) return;
  if (transforms_) rivals_.checkTransforms(transforms_->children());
  const Graph& graph = ros_.participant().graph();
  if (graph.version() == knownGraph_) return;
  knownGraph_ = graph.version();
  if (robotSettings_.tellsDescription) {
    rivals_.checkTopic(plainName(kDescription), "--ros2-no-robot-description", "a robot has two descriptions");
  }
  for (const std::string& topic : jointStates_.topics()) {
    rivals_.checkTopic(topic, "--ros2-no-joint-states", "joints have two sources");
  }
}

void Robots::follow() {
  hasChanged_ = false;
  const bool areOthers = list_.update();
  if (!areOthers && !mustRename_) return;
  mustRename_ = false;
  const RosNode::Quiet quiet(ros_);
  if (areOthers && transforms_) transforms_->follow(list_.robots(), list_.fixtures());
  nameTopics();
}

void Robots::nameTopics() {
  std::vector<RobotDescriptions::Topic> descriptions;
  std::vector<JointStates::RobotJoints> all;
  jointStates_.clear();
  const bool areSeveral = list_.robots().size() > 1;
  const auto describe = [&](const std::string& topic, const Robot& robot) {
    if (robotSettings_.tellsDescription && !isRuled(topic)) descriptions.push_back({topic, &robot});
  };
  const auto addJointStates = [&](const std::string& topic, const std::vector<JointStates::RobotJoints>& robots) {
    if (robotSettings_.tellsJointStates && !isRuled(topic)) jointStates_.add(topic, robots);
  };
  for (const Robot& robot : list_.robots()) {
    all.push_back({&robot, areSeveral ? robot.name + "/" : ""});
    describe(areSeveral ? nameOf(robot, kDescription) : plainName(kDescription), robot);
    if (areSeveral) addJointStates(nameOf(robot, kJointStates), {{&robot}});
  }
  if (!all.empty()) addJointStates(plainName(kJointStates), all);
  descriptions_.follow(descriptions);
  if (areSeveral && robotSettings_.tellsDescription) {
    ros_.log().info("there are " + std::to_string(all.size()) + " robots: '" + plainName(kDescription) +
                    "' is of none of them, '" + nameOf(list_.robots().front(), kDescription) +
                    "' of the first; <robot>NAME</robot> says which models are robots");
  }
}

void Robots::reset() {
  looks_.reset();
  jointStates_.reset();
  if (transforms_) transforms_->reset();
}

void Robots::postUpdate(Time now) {
  jointStates_.postUpdate(now);
  if (transforms_) transforms_->postUpdate(now);
}

}  // namespace pongsim::ros2
