#include "ros2/control/joint_commands.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace pongsim::ros2 {

namespace {

using Axis = ignition::msgs::Axis;

/// Assigns the values of one of the three lists to its joints.
template <class Value, class Takes, class Target>
void deal(const ignition::msgs::Model& message, const std::vector<std::optional<std::size_t>>& indices,
          std::span<const ControlledJoint> joints, std::vector<JointCommand>& commands, const Value& valueOf,
          const Takes& takes, const Target& target) {
  std::vector<double> values;
  for (const auto& joint : message.joint()) {
    const double value = valueOf(joint.axis1());
    if (std::isnan(value)) break;
    values.push_back(value);
  }
  std::vector<std::size_t> takers;
  for (const auto& index : indices) {
    if (index && takes(joints[*index])) takers.push_back(*index);
  }
  const bool isShort = values.size() < indices.size() && values.size() == takers.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (isShort) {
      commands[takers[i]].*target = values[i];
    } else if (indices[i] && takes(joints[*indices[i]])) {
      commands[*indices[i]].*target = values[i];
    }
  }
}

std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::vector<JointCommand> readCommands(const ignition::msgs::Model& message, std::span<const ControlledJoint> joints,
                                       std::vector<std::string>& unknown) {
  unknown.clear();
  std::vector<std::optional<std::size_t>> indices;
  for (const auto& joint : message.joint()) {
    const auto found = std::ranges::find(joints, joint.name(), &ControlledJoint::name);
    if (found == joints.end()) {
      unknown.push_back(joint.name());
      indices.push_back(std::nullopt);
    } else {
      indices.push_back(static_cast<std::size_t>(found - joints.begin()));
    }
  }
  std::vector<JointCommand> commands(joints.size());
  deal(
      message, indices, joints, commands, [](const Axis& axis) { return axis.position(); },
      [](const ControlledJoint& joint) { return joint.takesPosition; }, &JointCommand::position);
  deal(
      message, indices, joints, commands, [](const Axis& axis) { return axis.velocity(); },
      [](const ControlledJoint& joint) { return joint.takesVelocity; }, &JointCommand::velocity);
  deal(
      message, indices, joints, commands, [](const Axis& axis) { return axis.force(); },
      [](const ControlledJoint& joint) { return joint.takesEffort; }, &JointCommand::effort);
  return commands;
}

std::string nearestName(const std::string& name, const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 100;
  std::string best;
  std::size_t least = std::min(name.size(), kLongest) / 2 + 1;
  for (const std::string& candidate : names) {
    if (name.size() > kLongest || candidate.size() > kLongest) continue;
    const std::size_t apart = distance(name, candidate);
    if (apart >= least) continue;
    least = apart;
    best = candidate;
  }
  return best;
}

}  // namespace pongsim::ros2
