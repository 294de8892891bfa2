#include "ros2/control/hardware_component.hh"

namespace pongsim::ros2 {

namespace {

HardwareComponent::Part hardwarePart(const Element& element) {
  HardwareComponent::Part part{element.attributeOr("name", ""), {}, {}};
  for (const Element& child : element.children) {
    if (child.name == "command_interface") part.commands.push_back(child.attributeOr("name", ""));
    if (child.name == "state_interface") part.states.push_back(child.attributeOr("name", ""));
  }
  return part;
}

}  // namespace

std::vector<HardwareComponent> hardwareComponents(const Element& holder) {
  std::vector<HardwareComponent> components;
  for (const Element* element : holder.childrenNamed("ros2_control")) {
    HardwareComponent& component = components.emplace_back();
    component.name = element->attributeOr("name", "");
    component.type = element->attributeOr("type", "");
    if (const Element* hardware = element->child("hardware")) {
      if (const Element* plugin = hardware->child("plugin")) component.plugin = plugin->text;
    }
    for (const Element* joint : element->childrenNamed("joint")) component.joints.push_back(hardwarePart(*joint));
    for (const Element* sensor : element->childrenNamed("sensor")) component.sensors.push_back(hardwarePart(*sensor));
  }
  return components;
}

}  // namespace pongsim::ros2
