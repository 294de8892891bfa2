#include "ros2/control/control_block.hh"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pongsim::ros2 {

namespace {

/// @return The text of the `<param name="...">` in the element; null if there is none.
const Element* paramOf(const Element& holder, std::string_view name) {
  for (const Element& child : holder.children) {
    if (child.name == "param" && child.attributeOr("name", "") == name) return &child;
  }
  return nullptr;
}

std::optional<double> numberOf(const Element& element, Diagnostics& diagnostics) {
  try {
    const double value = element.as<double>();
    if (std::isfinite(value)) return value;
  } catch (const std::exception&) {
  }
  diagnostics.error(element.position, "'" + element.text + "' is not a finite number");
  return std::nullopt;
}

std::optional<double> numberOf(const Element& element, std::string_view attribute, Diagnostics& diagnostics) {
  const Element::Attribute* found = element.attribute(attribute);
  if (found == nullptr) return std::nullopt;
  Element text;
  text.text = found->value;
  text.position = found->position;
  return numberOf(text, diagnostics);
}

void readCommand(const Element& interface, ControlledJoint& joint, Diagnostics& diagnostics) {
  const std::string name = interface.attributeOr("name", "");
  bool* takes = name == "position"   ? &joint.takesPosition
                : name == "velocity" ? &joint.takesVelocity
                : name == "effort"   ? &joint.takesEffort
                                     : nullptr;
  if (takes != nullptr) {
    *takes = true;
    return;
  }
  diagnostics.warning(interface.position,
                      "joint '" + joint.name + "' can't be commanded by '" + name + "': it is ignored",
                      "use position, velocity or effort");
}

void readState(const Element& interface, ControlledJoint& joint, Diagnostics& diagnostics) {
  const Element* initial = paramOf(interface, "initial_value");
  if (initial == nullptr || initial->text.empty()) return;
  const std::string name = interface.attributeOr("name", "");
  if (name == "position") joint.initialPosition = numberOf(*initial, diagnostics);
  if (name == "velocity") joint.initialVelocity = numberOf(*initial, diagnostics);
}

/// From Humble's `<param name="mimic">`, else from the `<mimic>` of the robot's own `<joint>`.
std::optional<ControlledJoint::Mimic> mimicOf(const Element& element, const Element& holder, const std::string& name,
                                              Diagnostics& diagnostics) {
  if (const Element* param = paramOf(element, "mimic")) {
    ControlledJoint::Mimic mimic{param->text};
    if (const Element* multiplier = paramOf(element, "multiplier")) {
      mimic.multiplier = numberOf(*multiplier, diagnostics).value_or(1);
    }
    if (const Element* offset = paramOf(element, "offset")) {
      mimic.offset = numberOf(*offset, diagnostics).value_or(0);
    }
    return mimic;
  }
  // as in ros2_control, the word that disables it
  if (element.attributeOr("mimic", "true") == "false") return std::nullopt;
  for (const Element* joint : holder.childrenNamed("joint")) {
    const Element* mimic = joint->child("mimic");
    if (mimic == nullptr || joint->attributeOr("name", "") != name) continue;
    return ControlledJoint::Mimic{mimic->attributeOr("joint", ""),
                                  numberOf(*mimic, "multiplier", diagnostics).value_or(1),
                                  numberOf(*mimic, "offset", diagnostics).value_or(0)};
  }
  return std::nullopt;
}

ControlledJoint readJoint(const Element& element, const Element& holder, Diagnostics& diagnostics) {
  ControlledJoint joint;
  joint.name = element.attributeOr("name", "");
  joint.position = element.position;
  for (const Element& child : element.children) {
    if (child.name == "command_interface") readCommand(child, joint, diagnostics);
    if (child.name == "state_interface") readState(child, joint, diagnostics);
  }
  joint.mimic = mimicOf(element, holder, joint.name, diagnostics);
  return joint;
}

std::string topicOf(const Element* hardware, std::string_view param) {
  const Element* found = hardware != nullptr ? paramOf(*hardware, param) : nullptr;
  return found != nullptr ? found->text : "";
}

}  // namespace

std::vector<ControlBlock> controlBlocks(const Element& holder, Diagnostics& diagnostics) {
  std::vector<ControlBlock> blocks;
  for (const Element* element : holder.childrenNamed("ros2_control")) {
    const Element* hardware = element->child("hardware");
    ControlBlock read{topicOf(hardware, "joint_commands_topic"), topicOf(hardware, "joint_states_topic"), {}};
    const auto same = std::ranges::find_if(blocks, [&read](const ControlBlock& other) {
      return other.commandsTopic == read.commandsTopic && other.statesTopic == read.statesTopic;
    });
    ControlBlock& block = same != blocks.end() ? *same : blocks.emplace_back(std::move(read));
    for (const Element* joint : element->childrenNamed("joint")) {
      block.joints.push_back(readJoint(*joint, holder, diagnostics));
    }
  }
  return blocks;
}

}  // namespace pongsim::ros2
