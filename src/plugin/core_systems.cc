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
  serves("set_physics", "ignition.msgs.Physics", "sets step size, gravity and real-time factor");
  serves("wheel_slip", "ignition.msgs.WheelSlipParametersCmd", "sets the slip compliances of WheelSlip's wheels");
  serves("level/set_performer", "ignition.msgs.StringMsg",
         "makes a top-level model a performer: levels are loaded around it");
  declaration.subscribes("/world/W/light_config", "ignition.msgs.Light", "the same as a topic");
  return system;
}

}  // namespace

const std::vector<CoreSystem>& coreSystems() {
  static const std::vector<CoreSystem> systems{physics(), userCommands()};
  return systems;
}

const CoreSystem* coreSystem(std::string_view filename) {
  const auto found = std::ranges::find(coreSystems(), systemName(filename), &CoreSystem::name);
  return found == coreSystems().end() ? nullptr : &*found;
}

}  // namespace pongsim::plugin
