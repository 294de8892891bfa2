#include <ignition/msgs/model.pb.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/files/urdf_source.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"
#include "ros2/control/control_block.hh"
#include "ros2/control/controller_file.hh"
#include "ros2/control/joint_commands.hh"
#include "ros2/control/joint_driver.hh"
#include "ros2/controllers/robot_controllers.hh"
#include "ros2/controllers/ros_home.hh"
#include "ros2/robot/joint_effort.hh"

namespace pongsim::ros2 {

namespace {

constexpr const char* kModelType = "ignition.msgs.Model";

/// Replaces the plugin of gz_ros2_control. Where the simulation is a ROS node and <parameters> names a file, the
/// controllers run inside, as there. Otherwise, and where their classes are not known, the joints are commanded through
/// topics by controllers that run outside.
class Ros2Control final : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is(
        "Runs the controllers of a robot's <ros2_control>, or offers its joints on topics, for controllers that run "
        "outside of the simulation.",
        Declaration::Place::kModel);
    declaration.parameter("parameters", &files_, "", "parameter file of the controller manager and its controllers");
    declaration
        .parameter("controllers", &place_, "",
                   "where the controllers run: inside the simulation, outside of it and on topics, or inside if "
                   "<parameters> and ROS are there and the hardware isn't topic_based_ros2_control's (auto)")
        .oneOf({"auto", "inside", "outside"});
    declaration.parameter("controller_manager_name", &managerName_, "", "name of the controller manager's node");
    declaration.element("ros2_control", "joints with their interfaces, for a model that is not from a URDF");
    declaration.parameter("joint_commands_topic", &commandsTopic_, "", "command topic")
        .otherwise("/robot_joint_commands");
    declaration.parameter("joint_states_topic", &statesTopic_, "", "state topic").otherwise("/robot_joint_states");
    declaration.parameter("update_rate", &updateRate_, "Hz", "rate of the controllers and of the states")
        .above(0)
        .otherwise("what <parameters> says, else 100");
    declaration
        .parameter("position_proportional_gain", &positionGain_, "",
                   "fraction of the position error that a position command corrects per update")
        .above(0)
        .otherwise("what <parameters> says, else 0.1");
    declaration.parameter("hold_joints", &holdsJoints_, "",
                          "whether joints stay where they are before the first command");
    declaration.element("ros",
                        "its <namespace> is that of the controllers, and the prefix of topics that are not named here; "
                        "each <remapping>, \"FROM:=TO\", gives a topic of the controllers another name");
    for (const char* name : {"controller_manager_prefix_node_name", "robot_param", "robot_param_node"}) {
      declaration.element(name, "no effect: the controllers know the robot");
    }
    declaration.subscribes("<joint_commands_topic>", kModelType,
                           "positions, velocities and forces by joint; not a number where nothing is commanded");
    declaration.publishes("<joint_states_topic>", kModelType, "positions, velocities and forces by joint");
  }

  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    const Model& model = *context.model;
    model_ = std::string(model.name());
    node_ = context.node;
    const UrdfSource* urdf = model.urdf();
    const Element& holder = sdf.child("ros2_control") == nullptr && urdf != nullptr ? urdf->robot : sdf;
    const JointDriver::Settings settings = readSettings(context);
    for (ControlBlock& block : controlBlocks(holder, context.diagnostics)) {
      std::vector<ControlledJoint> joints = jointsOf(block, model, context.diagnostics);
      if (joints.empty()) continue;
      Group& group = groups_.emplace_back(JointDriver(model, std::move(joints), settings));
      nameTopics(block, group, sdf);
    }
    if (groups_.empty()) {
      refuse(sdf, "there is no <ros2_control> that lists joints of model '" + model_ + "'",
             urdf != nullptr ? "put it in the <robot> of the URDF" : "for an SDF model, put it in this <plugin>");
    }
    schedule_ = Schedule(periodOf(settings.updateRate));
    runInside(context, hardwareComponents(holder), settings.updateRate);
    if (!offersTopics_) return;
    for (Group& group : groups_) open(group);
  }

  void preUpdate(const StepInfo& info) override {
    if (!hasSpoken_) speak();
    if (inside_) inside_->preUpdate();
    if (info.paused) return;
    for (Group& group : groups_) {
      if (!hasBegun_) {
        for (const std::string& why : group.driver.begin()) log_.warning(why);
      }
      group.driver.drive(info.dt);
    }
    hasBegun_ = true;
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    if (inside_) inside_->postUpdate(info.time);
    if (!offersTopics_ || !schedule_.isDue(info.time)) return;
    for (Group& group : groups_) {
      if (group.states.hasSubscribers()) publish(group, info.time);
    }
  }

  void reset() override {
    hasBegun_ = false;
    schedule_.reset();
    for (Group& group : groups_) group.driver.reset();
    if (inside_) inside_->reset();
  }

  void transfer(StateArchive& archive) override {
    archive(hasBegun_);
    archive(schedule_);
    for (Group& group : groups_) archive(group.driver);
    if (inside_) archive(*inside_);
  }

 private:
  /// The joints of one pair of topics.
  struct Group {
    explicit Group(JointDriver joints) : driver(std::move(joints)) {}
    JointDriver driver;
    std::string commandsTopic;
    std::string statesTopic;
    Publisher states;
    ignition::msgs::Model message;
    std::vector<std::string> unknown;
    Subscription commands;
  };

  /// Relative paths begin at the file with the element.
  static std::filesystem::path pathOf(const Element& element) {
    const std::filesystem::path file = element.text;
    if (file.is_absolute() || element.position.file == nullptr) return file;
    return std::filesystem::path(*element.position.file).parent_path() / file;
  }

  /// Starts the controller manager, unless the controllers run outside.
  void runInside(const SystemContext& context, std::vector<HardwareComponent> components, double rate) {
    std::shared_ptr<RosHome> home;
    for (System* other : context.before) {
      if (const auto* host = dynamic_cast<RosHost*>(other)) home = host->home();
    }
    const bool isElsewhere = std::ranges::any_of(components, [](const HardwareComponent& component) {
      return component.plugin.starts_with("topic_based_ros2_control/");
    });
    RobotControllers::Options options{managerName_, spaceOf(context.sdf), {}, {}, rate};
    bool hasFile = false;
    // what is wrong with a file has been said
    for (const Element* element : context.sdf.childrenNamed("parameters")) {
      if (!element->text.empty() && options.files.read(pathOf(*element)).empty()) hasFile = true;
    }
    if (!home || place_ == "outside" || (place_ == "auto" && (isElsewhere || !hasFile))) return;
    if (options.nameSpace.empty()) options.nameSpace = "/";
    const std::string manager = absoluteName(options.nameSpace, options.name);
    if (const auto error = rosNameError(manager)) {
      refuse(context.sdf, "the controller manager's name '" + manager + "' " + *error);
    }
    if (const Element* ros = context.sdf.child("ros")) {
      for (const Element* remap : ros->childrenNamed("remapping")) {
        if (options.remaps.add(remap->text)) continue;
        context.diagnostics.warning(remap->position, "'" + remap->text + "' is not a remapping", "write FROM:=TO");
      }
    }
    std::vector<JointDriver*> drivers;
    for (Group& group : groups_) drivers.push_back(&group.driver);
    inside_.emplace(std::move(home), context, drivers, std::move(components), log_, std::move(options));
    std::string unknown;
    for (const auto& [name, type] : inside_->manager().unknownTypes()) {
      unknown += (unknown.empty() ? "" : ", ") + ("'" + name + "' (" + type + ")");
    }
    offersTopics_ = !unknown.empty();
    if (!offersTopics_) return;
    context.diagnostics.warning(context.sdf.position,
                                "controllers of '" + model_ + "' can't run inside the simulation: " + unknown,
                                "run them outside, with the topics of its joints");
  }

  /// @return "/robot" for the namespace "robot", empty without one.
  static std::string spaceOf(const Element& sdf) {
    std::string space;
    if (const Element* ros = sdf.child("ros")) space = ros->get<std::string>("namespace", "");
    if (!space.empty() && !space.starts_with('/')) space.insert(0, "/");
    while (space.ends_with('/')) space.pop_back();
    return space;
  }

  JointDriver::Settings readSettings(const SystemContext& context) {
    JointDriver::Settings settings;
    for (const Element* element : context.sdf.childrenNamed("parameters")) {
      constexpr const char* kAssumed =
          "the controllers' rate is assumed to be 100 Hz; set <update_rate> here if it differs";
      if (element->text.empty()) {
        context.diagnostics.warning(element->position, "<parameters> is empty", kAssumed);
        continue;
      }
      const std::filesystem::path file = pathOf(*element);
      const ControllerFile read = readControllerFile(file);
      if (!read.error.empty()) {
        context.diagnostics.warning(element->position, "parameters '" + element->text + "': " + read.error, kAssumed);
      }
      settings.updateRate = read.updateRate.value_or(settings.updateRate);
      settings.positionGain = read.positionGain.value_or(settings.positionGain);
      settings.holdsJoints = read.holdsJoints.value_or(settings.holdsJoints);
    }
    // elements in the world take precedence over those in a file
    if (context.sdf.child("hold_joints") != nullptr) settings.holdsJoints = holdsJoints_;
    settings.updateRate = updateRate_.value_or(settings.updateRate);
    settings.positionGain = positionGain_.value_or(settings.positionGain);
    return settings;
  }

  /// @return The listed joints that the model has, with an axis.
  static std::vector<ControlledJoint> jointsOf(ControlBlock& block, const Model& model, Diagnostics& diagnostics) {
    std::vector<std::string> names;
    for (const Joint& joint : model.joints()) {
      if (joint.axisCount() == 1) names.emplace_back(joint.name());
    }
    std::vector<ControlledJoint> joints;
    for (ControlledJoint& joint : block.joints) {
      if (std::ranges::find(names, joint.name) == names.end()) {
        const std::string nearest = nearestName(joint.name, names);
        diagnostics.warning(joint.position,
                            "<ros2_control> lists joint '" + joint.name + "', which is not a joint of model '" +
                                std::string(model.name()) + "' with one axis: it is left out",
                            nearest.empty() ? "" : "did you mean '" + nearest + "'?");
      } else if (std::ranges::find(joints, joint.name, &ControlledJoint::name) == joints.end()) {
        joints.push_back(std::move(joint));
      }
    }
    for (ControlledJoint& joint : joints) {
      if (!joint.mimic) continue;
      const bool isThere = std::ranges::find(joints, joint.mimic->joint, &ControlledJoint::name) != joints.end();
      if (isThere && joint.mimic->joint != joint.name) continue;
      diagnostics.warning(joint.position, "joint '" + joint.name + "' follows joint '" + joint.mimic->joint +
                                              "', which <ros2_control> does not list: it does not follow");
      joint.mimic.reset();
    }
    return joints;
  }

  void nameTopics(const ControlBlock& block, Group& group, const Element& sdf) const {
    const auto firstOf = [](const std::string& first, const std::string& second, const std::string& third) {
      return !first.empty() ? first : !second.empty() ? second : third;
    };
    std::string space = spaceOf(sdf);
    // of several robots without names, all but the first have topics of their own
    const std::vector<OwnTopic> topics = node_->ownTopics();
    const auto isTaken = [&topics](const std::string& name) {
      return std::ranges::any_of(topics,
                                 [&name](const OwnTopic& topic) { return topic.name == name && topic.publishers > 0; });
    };
    if (isTaken(space + "/robot_joint_states")) space += "/" + model_;
    group.commandsTopic =
        topicOr(firstOf(block.commandsTopic, commandsTopic_, space + "/robot_joint_commands"), "/robot_joint_commands");
    group.statesTopic =
        topicOr(firstOf(block.statesTopic, statesTopic_, space + "/robot_joint_states"), "/robot_joint_states");
  }

  void open(Group& group) {
    group.states = node_->advertise<ignition::msgs::Model>(group.statesTopic);
    group.commands = node_->subscribe<ignition::msgs::Model>(
        group.commandsTopic, [this, &group](const ignition::msgs::Model& message) { applyCommands(message, group); });
    for (const ControlledJoint& joint : group.driver.joints()) {
      auto& state = *group.message.add_joint();
      state.set_name(joint.name);
      state.mutable_axis1();
    }
    group.message.set_name(model_);
  }

  void applyCommands(const ignition::msgs::Model& message, Group& group) {
    const std::vector<JointCommand> commands = readCommands(message, group.driver.joints(), group.unknown);
    for (const std::string& name : group.unknown) {
      if (warned_.size() >= kMostWarned || !warned_.insert(name).second) continue;
      std::vector<std::string> names;
      for (const ControlledJoint& joint : group.driver.joints()) names.push_back(joint.name);
      const std::string nearest = nearestName(name, names);
      log_.warning("topic '" + group.commandsTopic + "' commands joint '" + name +
                   "', which <ros2_control> does not list" +
                   (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
    }
    for (std::size_t i = 0; i < commands.size(); ++i) {
      const bool isSound = isWithin(commands[i].position, kLargestCommand) &&
                           isWithin(commands[i].velocity, kLargestCommand) &&
                           isWithin(commands[i].effort, kLargestForce);
      if (isSound) continue;
      if (!isRefusing_) {
        log_.warning("topic '" + group.commandsTopic + "': a message was refused: it commands joint '" +
                     group.driver.joints()[i].name + "' with an infinite or very large value");
      }
      isRefusing_ = true;
      return;
    }
    isRefusing_ = false;
    group.driver.command(commands);
  }

  static bool isWithin(const std::optional<double>& value, double bound) { return !value || std::abs(*value) <= bound; }

  void speak() {
    hasSpoken_ = true;
    if (!offersTopics_) {
      const std::string name = inside_->manager().nodeName();
      log_.info("the controllers of '" + model_ + "' run inside the simulation; spawners reach them at '" + name + "'");
      return;
    }
    const std::vector<OwnTopic> topics = node_->ownTopics();
    for (const Group& group : groups_) {
      std::string names;
      for (const ControlledJoint& joint : group.driver.joints()) names += (names.empty() ? "" : ", ") + joint.name;
      const bool isBridged = std::ranges::any_of(topics, [&group](const OwnTopic& topic) {
        return topic.name == group.commandsTopic && topic.type == kModelType &&
               topic.publishers + topic.relayingPublishers > 0;
      });
      log_.warning("the controllers of '" + model_ + "' run outside of the simulation: commands for " + names +
                   " are read from '" + group.commandsTopic + "', states are published on '" + group.statesTopic + "'" +
                   (isBridged ? "" : "; run with --ros2 so that ROS nodes can reach these topics") +
                   ". In the URDF that ros2_control_node reads: <hardware><plugin>topic_based_ros2_control/"
                   "TopicBasedSystem</plugin><param name=\"joint_commands_topic\">" +
                   group.commandsTopic + "</param><param name=\"joint_states_topic\">" + group.statesTopic +
                   "</param></hardware>");
    }
  }

  static void publish(Group& group, Time now) {
    setStamp(now, *group.message.mutable_header());
    for (int i = 0; i < group.message.joint_size(); ++i) {
      const Joint& joint = group.driver.joint(static_cast<std::size_t>(i));
      auto& axis = *group.message.mutable_joint(i)->mutable_axis1();
      axis.set_position(joint.position());
      axis.set_velocity(joint.velocity());
      axis.set_force(jointEffort(joint));
    }
    group.states.publish(group.message);
  }

  static constexpr std::size_t kMostWarned = 100;

  std::vector<std::string> files_;
  std::string commandsTopic_;
  std::string statesTopic_;
  std::optional<double> updateRate_;
  std::optional<double> positionGain_;
  bool holdsJoints_ = true;
  std::string place_ = "auto";
  std::string managerName_ = "controller_manager";
  Logger log_{"ros2_control"};
  std::string model_;
  std::optional<Node> node_;
  std::list<Group> groups_;
  std::optional<RobotControllers> inside_;
  bool offersTopics_ = true;
  /// Unknown joints, each reported once.
  std::set<std::string> warned_;
  bool isRefusing_ = false;
  bool hasSpoken_ = false;
  bool hasBegun_ = false;
  Schedule schedule_;
};

}  // namespace

}  // namespace pongsim::ros2

PONGSIM_EXPORT_SYSTEM(pongsim::ros2::Ros2Control, "gz_ros2_control::GazeboSimROS2ControlPlugin",
                      "ign_ros2_control::IgnitionROS2ControlPlugin");
