#include "plugin/core_systems.hh"

#include <algorithm>

#include "plugin/system_name.hh"

namespace pongsim::plugin {

namespace {

CoreSystem physics() {
  CoreSystem system{"physics", "ignition::gazebo::systems::Physics", {}};
  system.declaration.is("Runs the physics. Nothing moves in a world that lists systems but not this one.",
                        Declaration::Place::kWorld);
  return system;
}

CoreSystem userCommands() {
  CoreSystem system{"user-commands", "ignition::gazebo::systems::UserCommands", {}};
  Declaration& declaration = system.declaration;
  declaration.is("Changes the world while it runs. Every world has these services, whether it lists the system or not.",
                 Declaration::Place::kWorld);
  const auto serves = [&declaration](const char* name, const char* type, const char* text) {
    declaration.serves(std::string("/world/W/") + name, type, "ignition.msgs.Boolean", text);
  };
  serves("create", "ignition.msgs.EntityFactory", "inserts a model or a light, from text, from a file or as a copy");
  serves("create_multiple", "ignition.msgs.EntityFactory_V", "inserts several, all or none");
  serves("remove", "ignition.msgs.Entity", "removes a model or a light, by name or id");
  serves("set_pose", "ignition.msgs.Pose", "moves a top-level model");
  serves("set_pose_vector", "ignition.msgs.Pose_V", "the same for several models, all or none");
  serves("set_spherical_coordinates", "ignition.msgs.SphericalCoordinates",
         "sets the position on the earth of the world or of a top-level model");
  serves("light_config", "ignition.msgs.Light", "changes a light");
  serves("visual_config", "ignition.msgs.Visual", "changes the colours of a visual");
  serves("set_mass", "ignition.msgs.Link", "sets the mass of a link");
  serves("set_joint_position", "ignition.msgs.Joint", "moves the axes of a joint");
  serves("set_physics", "ignition.msgs.Physics", "sets step size, gravity and real-time factor");
  serves("wheel_slip", "ignition.msgs.WheelSlipParametersCmd", "sets the slip compliances of WheelSlip's wheels");
  serves("level/set_performer", "ignition.msgs.StringMsg",
         "makes a top-level model a performer: levels are loaded around it");
  declaration.subscribes("/world/W/light_config", "ignition.msgs.Light", "the same as a topic");
  return system;
}

CoreSystem label() {
  CoreSystem system{"label", "ignition::gazebo::systems::Label", {}, "a <model>, a <visual> or an <actor>"};
  system.declaration.is(
      "Labels what it is in for segmentation and bounding-box cameras. In a model it labels all visuals, also those of "
      "nested models, that have no label of their own.",
      Declaration::Place::kAnywhere);
  system.declaration
      .element("label",
               "whole number from 0 to 255; 0 is the background for segmentation cameras, 255 for bounding-box cameras")
      .required();
  return system;
}

CoreSystem thermal() {
  CoreSystem system{"thermal", "ignition::gazebo::systems::Thermal", {}, "a <visual>"};
  Declaration& declaration = system.declaration;
  declaration.is("Gives a visual a temperature of its own for thermal cameras.", Declaration::Place::kAnywhere);
  declaration.element("temperature", "the same everywhere [K]");
  declaration.element("heat_signature", "instead of that, an image: black is the coldest, full red the hottest");
  declaration.element("min_temp", "temperature of black [K]").otherwise("that of the atmosphere");
  declaration.element("max_temp", "temperature of full red [K]").otherwise("that of the atmosphere");
  return system;
}

CoreSystem thermalSensor() {
  CoreSystem system{
      "thermal-sensor", "ignition::gazebo::systems::ThermalSensor", {}, "the <sensor> of a thermal camera"};
  Declaration& declaration = system.declaration;
  declaration.is("Sets how a thermal camera shows temperatures.", Declaration::Place::kAnywhere);
  declaration.element("resolution", "temperature per unit of the image [K]").otherwise("0.01 for L16, 3 for L8");
  declaration.element("min_temp", "what is colder is shown like this [K]").otherwise("0");
  declaration.element("max_temp", "what is hotter is shown like this [K]").otherwise("none");
  return system;
}

CoreSystem shaderParam() {
  CoreSystem system{"shader-param", "ignition::gazebo::systems::ShaderParam", {}, "a <visual>"};
  system.limit = "cameras run no shader programs, and draw the visual in its <material>";
  Declaration& declaration = system.declaration;
  declaration.is(
      "Has no effect, with one warning: it runs a visual's own shader programs, in the language of one of Gazebo's "
      "renderers. Cameras draw the visual in its material.",
      Declaration::Place::kAnywhere);
  declaration.element("shader", "files of the programs: has no effect");
  declaration.element("param", "parameter of a program: has no effect");
  return system;
}

CoreSystem entitySemantics() {
  CoreSystem system{"entity-semantics", "gz::sim::systems::EntitySemantics", {}, "the <world>"};
  system.declaration.is(
      "Tells what models stand for, to ROS's simulation_interfaces. `<gz:semantics>` in a model has a `<category>` "
      "(object, robot, human, dynamic_object, static_object), a `<description>` and `<tag>`s. Every world reads them, "
      "whether it lists the system or not.",
      Declaration::Place::kWorld);
  return system;
}

}  // namespace

const std::vector<CoreSystem>& coreSystems() {
  static const std::vector<CoreSystem> systems{physics(),       userCommands(), label(),          thermal(),
                                               thermalSensor(), shaderParam(),  entitySemantics()};
  return systems;
}

const CoreSystem* coreSystem(std::string_view filename) {
  const auto found = std::ranges::find(coreSystems(), systemName(filename), &CoreSystem::name);
  return found == coreSystems().end() ? nullptr : &*found;
}

}  // namespace pongsim::plugin
