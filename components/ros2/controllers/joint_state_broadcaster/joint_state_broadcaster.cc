#include "ros2/controllers/joint_state_broadcaster/joint_state_broadcaster.hh"

#include <algorithm>
#include <limits>
#include <set>

#include "pongsim/files/urdf_source.hh"
#include "ros2/robot/stamps.hh"

namespace pongsim::ros2 {

namespace {

constexpr double kNoState = std::numeric_limits<double>::quiet_NaN();

/// @return The moving joints of a robot from URDF, in the order of their names, in which the broadcaster publishes
/// them.
std::vector<std::string> movingJoints(const Model& model) {
  std::set<std::string> names;
  if (const UrdfSource* urdf = model.urdf()) {
    for (const Element* joint : urdf->robot.childrenNamed("joint")) {
      if (joint->attributeOr("type", "") != "fixed") names.insert(joint->attributeOr("name", ""));
    }
  }
  return {names.begin(), names.end()};
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

Outcome<void> JointStateBroadcaster::configure(const ControllerSetup& setup) {
  ControllerParameters& parameters = setup.parameters;
  joints_ = parameters.texts("joints");
  interfaces_ = parameters.texts("interfaces");
  if (joints_.empty() || interfaces_.empty()) {
    joints_.clear();
    interfaces_.clear();
  }
  extraJoints_ = parameters.texts("extra_joints");
  for (const std::string name : {"position", "velocity", "effort"}) {
    const std::string mapped = parameters.text("map_interface_to_joint_state." + name, name);
    mapped_[contains(interfaces_, name) ? name : mapped] = name;
  }
  if (parameters.flag("use_urdf_to_filter", true)) described_ = movingJoints(setup.model);
  frames_ = setup.frames;
  message_.header.frame_id = frames_.toRos(parameters.text("frame_id", "base_link"));
  dynamicMessage_.header.frame_id = message_.header.frame_id;
  const std::string prefix = parameters.flag("use_local_topics", false) ? "~/" : "";
  topic_ = setup.remaps.apply(setup.ros, prefix + "joint_states");
  plain_ = setup.advertise<sensor_msgs::JointState>(prefix + "joint_states");
  if (parameters.flag("publish_dynamic_joint_states", true)) {
    dynamic_ = setup.advertise<control_msgs::DynamicJointState>(prefix + "dynamic_joint_states");
  }
  return {};
}

Controller::Interfaces JointStateBroadcaster::interfaces() const {
  if (joints_.empty()) return {.allStates = true};
  Interfaces wanted;
  for (const std::string& joint : joints_) {
    for (const std::string& interface : interfaces_) wanted.states.push_back(joint + "/" + interface);
  }
  return wanted;
}

/// Those that have a position, a velocity or an effort.
void JointStateBroadcaster::nameJoints(const Loan& loan) {
  message_.name.clear();
  for (const HardwareInterfaces::State* state : loan.states) {
    const bool isListed = joints_.empty() && !described_.empty() ? contains(described_, state->prefix) : true;
    if (!isListed || !mapped_.contains(state->interface) || contains(message_.name, state->prefix)) continue;
    message_.name.push_back(state->prefix);
  }
  if (joints_.empty() && !described_.empty()) std::ranges::sort(message_.name);
}

Outcome<void> JointStateBroadcaster::activate(const Loan& loan, Time) {
  if (loan.states.empty()) return {"there are no state interfaces"};
  nameJoints(loan);
  std::map<std::string, std::map<std::string, double>> all;
  for (const HardwareInterfaces::State* state : loan.states) {
    const auto mapped = mapped_.find(state->interface);
    all[state->prefix][mapped == mapped_.end() ? state->interface : mapped->second] = kNoState;
  }
  std::vector<std::string> extra;
  for (const std::string& name : extraJoints_) {
    if (all.contains(name)) continue;
    all[name] = {{"position", 0}, {"velocity", 0}, {"effort", 0}};
    extra.push_back(name);
  }
  const std::size_t read = message_.name.size();
  message_.name.insert(message_.name.end(), extra.begin(), extra.end());
  for (auto* values : {&message_.position, &message_.velocity, &message_.effort}) {
    values->assign(read, kNoState);
    values->resize(message_.name.size(), 0.0);
  }
  dynamicMessage_.joint_names.clear();
  dynamicMessage_.interface_values.clear();
  for (const auto& [name, interfaces] : all) {
    dynamicMessage_.joint_names.push_back(name);
    auto& values = dynamicMessage_.interface_values.emplace_back();
    for (const auto& [interface, value] : interfaces) {
      values.interface_names.push_back(interface);
      values.values.push_back(value);
    }
  }
  targets_.clear();
  for (const HardwareInterfaces::State* state : loan.states) {
    Target& target = targets_.emplace_back();
    target.state = state;
    const auto mapped = mapped_.find(state->interface);
    const std::string interface = mapped == mapped_.end() ? state->interface : mapped->second;
    const auto joint = std::ranges::find(message_.name, state->prefix);
    auto* values = interface == "position"   ? &message_.position
                   : interface == "velocity" ? &message_.velocity
                   : interface == "effort"   ? &message_.effort
                                             : nullptr;
    if (joint != message_.name.end() && values != nullptr) {
      target.plain = &(*values)[static_cast<std::size_t>(joint - message_.name.begin())];
    }
    const auto place = std::ranges::find(dynamicMessage_.joint_names, state->prefix);
    auto& list =
        dynamicMessage_.interface_values[static_cast<std::size_t>(place - dynamicMessage_.joint_names.begin())];
    const auto named = std::ranges::find(list.interface_names, interface);
    target.dynamic = &list.values[static_cast<std::size_t>(named - list.interface_names.begin())];
  }
  return {};
}

void JointStateBroadcaster::deactivate() { targets_.clear(); }

void JointStateBroadcaster::update(Time now, double) {
  const bool isPlainRead = plain_->hasReaders(), isDynamicRead = dynamic_ && dynamic_->hasReaders();
  if (!isPlainRead && !isDynamicRead) return;
  for (const Target& target : targets_) {
    const double value = target.state->read();
    if (target.plain != nullptr) *target.plain = value;
    *target.dynamic = value;
  }
  message_.header.stamp = dynamicMessage_.header.stamp = stampOf(now, frames_);
  if (isPlainRead) plain_->publish(message_);
  if (isDynamicRead) dynamic_->publish(dynamicMessage_);
}

}  // namespace pongsim::ros2
