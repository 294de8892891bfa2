#include "ros2/control/joint_driver.hh"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "pongsim/commands.hh"

namespace pongsim::ros2 {

JointDriver::JointDriver(const Model& model, std::vector<ControlledJoint> joints, const Settings& settings)
    : controlled_(std::move(joints)), settings_(settings) {
  for (const ControlledJoint& joint : controlled_) driven_.push_back({model.joint(joint.name).value()});
  for (std::size_t i = 0; i < controlled_.size(); ++i) {
    if (!controlled_[i].mimic) continue;
    const auto leader = std::ranges::find(controlled_, controlled_[i].mimic->joint, &ControlledJoint::name);
    if (leader != controlled_.end()) driven_[i].leader = static_cast<std::size_t>(leader - controlled_.begin());
  }
}

void JointDriver::command(const std::vector<JointCommand>& commands) {
  assert(commands.size() == driven_.size());
  for (std::size_t i = 0; i < driven_.size(); ++i) {
    Driven& driven = driven_[i];
    if (!driven.claimed.empty()) continue;
    // another interface takes over when its command changes, or with its first nonzero command
    const auto take = [&](const std::optional<double>& value, std::optional<double>& known, Interface interface) {
      if (!value) return;
      const bool isNew = known ? *known != *value : (driven.interface == Interface::kNone || *value != 0);
      known = value;
      if (isNew) driven.interface = interface;
    };
    take(commands[i].position, driven.position, Interface::kPosition);
    take(commands[i].velocity, driven.velocity, Interface::kVelocity);
    take(commands[i].effort, driven.effort, Interface::kEffort);
  }
}

const std::optional<double>& JointDriver::Driven::value(Interface of) const {
  return of == Interface::kPosition ? position : of == Interface::kVelocity ? velocity : effort;
}

void JointDriver::chooseInterface(Driven& driven) {
  driven.interface = Interface::kNone;
  for (const Interface each : {Interface::kEffort, Interface::kPosition, Interface::kVelocity}) {
    if (driven.claimed.contains(each)) driven.interface = each;
  }
}

void JointDriver::claim(std::size_t index, Interface interface) {
  Driven& driven = driven_[index];
  // those of topics end
  if (driven.claimed.empty()) driven.position = driven.velocity = driven.effort = std::nullopt;
  driven.claimed.insert(interface);
  driven.value(interface).reset();
  chooseInterface(driven);
}

void JointDriver::release(std::size_t index, Interface interface) {
  Driven& driven = driven_[index];
  driven.claimed.erase(interface);
  driven.value(interface).reset();
  chooseInterface(driven);
}

void JointDriver::set(std::size_t index, Interface interface, double value) {
  std::optional<double>& known = driven_[index].value(interface);
  const double largest = interface == Interface::kEffort ? kLargestForce : kLargestCommand;
  known = std::isnan(value) ? std::nullopt : std::optional(std::clamp(value, -largest, largest));
}

double JointDriver::get(std::size_t index, Interface interface) const {
  return driven_[index].value(interface).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::vector<std::string> JointDriver::begin() {
  std::vector<std::string> refused;
  for (std::size_t i = 0; i < driven_.size(); ++i) {
    const ControlledJoint& controlled = controlled_[i];
    const auto note = [&](const Outcome<void>& outcome) {
      if (outcome) return;
      refused.push_back("joint '" + controlled.name + "' does not start at its initial value: " + outcome.error);
    };
    if (controlled.initialPosition && *controlled.initialPosition != driven_[i].joint.position()) {
      note(driven_[i].joint.resetPosition(*controlled.initialPosition));
    }
    if (controlled.initialVelocity && *controlled.initialVelocity != driven_[i].joint.velocity()) {
      note(driven_[i].joint.resetVelocity(*controlled.initialVelocity));
    }
  }
  return refused;
}

void JointDriver::drive(Time dt) {
  // no farther than the target, even in a step longer than the controllers' period
  const double perSecond = 1 / toSeconds(dt);
  const double follow = std::min(settings_.updateRate, perSecond);
  const double approach = std::min(settings_.positionGain * settings_.updateRate, perSecond);
  const auto turn = [](Joint& joint, double velocity) {
    joint.setVelocityTarget(std::clamp(velocity, -kLargestCommand, kLargestCommand));
  };
  for (std::size_t i = 0; i < driven_.size(); ++i) {
    Driven& driven = driven_[i];
    if (driven.leader) {
      const ControlledJoint::Mimic& mimic = *controlled_[i].mimic;
      const double target = mimic.multiplier * driven_[*driven.leader].joint.position() + mimic.offset;
      turn(driven.joint, follow * (target - driven.joint.position()));
      continue;
    }
    switch (driven.interface) {
      case Interface::kPosition:
        turn(driven.joint, driven.position ? approach * (*driven.position - driven.joint.position()) : 0);
        break;
      case Interface::kVelocity:
        turn(driven.joint, driven.velocity.value_or(0));
        break;
      case Interface::kEffort:
        driven.joint.clearVelocityTarget();
        driven.joint.addForce(driven.effort.value_or(0));
        break;
      case Interface::kNone:
        if (settings_.holdsJoints && controlled_[i].isCommanded()) turn(driven.joint, 0);
        break;
    }
  }
}

void JointDriver::reset() {
  for (Driven& driven : driven_) {
    chooseInterface(driven);
    driven.position = driven.velocity = driven.effort = std::nullopt;
  }
}

void JointDriver::Driven::transfer(StateArchive& archive) {
  archive(interface, Interface::kEffort);
  archive(position);
  archive(velocity);
  archive(effort);
  // who claims what is not in the state: it must be that of the controllers
  archive.check(claimed.empty() || claimed.contains(interface));
}

void JointDriver::transfer(StateArchive& archive) {
  for (Driven& driven : driven_) archive(driven);
}

}  // namespace pongsim::ros2
