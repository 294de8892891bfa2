#include "msgs/state/state_reader.hh"

#include <ignition/msgs/axis.pb.h>
#include <ignition/msgs/inertial.pb.h>
#include <ignition/msgs/sensor.pb.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <algorithm>
#include <string_view>

#include "msgs/scene/pose_message.hh"
#include "msgs/scene/sensor_message.hh"
#include "msgs/state/component_reader.hh"

namespace pongsim::msgs {

namespace {

namespace im = ignition::msgs;

description::Inertial inertialOf(const im::Inertial& message) {
  description::Inertial inertial;
  inertial.mass = message.mass();
  inertial.X_LinkCom = poseFrom(message.pose());
  inertial.moments << message.ixx(), message.ixy(), message.ixz(), message.ixy(), message.iyy(), message.iyz(),
      message.ixz(), message.iyz(), message.izz();
  return inertial;
}

EntityState::Kind kindOf(const ComponentReader& components) {
  if (components.has("World")) return EntityState::Kind::kWorld;
  if (components.has("Model")) return EntityState::Kind::kModel;
  if (components.has("Link")) return EntityState::Kind::kLink;
  if (components.has("Joint")) return EntityState::Kind::kJoint;
  if (components.has("Light")) return EntityState::Kind::kLight;
  return components.has("Sensor") ? EntityState::Kind::kSensor : EntityState::Kind::kOther;
}

void readJoint(const ComponentReader& components, EntityState& joint) {
  joint.jointType = jointTypeOfNumber(static_cast<int>(components.number("JointType").value_or(0)));
  joint.parentLink = components.text("ParentLinkName");
  joint.childLink = components.text("ChildLinkName");
  for (const char* name : {"JointAxis", "JointAxis2"}) {
    const auto axis = components.message<im::Axis>(name);
    if (axis) joint.axes.emplace_back(axis->xyz().x(), axis->xyz().y(), axis->xyz().z());
  }
  joint.positions = components.numbers("JointPosition");
  joint.velocities = components.numbers("JointVelocity");
}

void readSensor(const ComponentReader& components, EntityState& entity) {
  for (const std::string_view name : sensorComponents()) {
    const auto sensor = components.message<im::Sensor>(name);
    if (sensor) entity.sensor = sensorOf(*sensor);
  }
}

EntityState entityOf(std::uint64_t id, const im::SerializedEntityMap& message) {
  const ComponentReader components(message);
  EntityState entity;
  entity.id = id;
  entity.kind = kindOf(components);
  entity.name = components.text("Name");
  entity.parent = static_cast<std::uint64_t>(std::max(components.number("ParentEntity").value_or(0), 0LL));
  entity.pose = poseOfComponent(components.text("Pose"));
  entity.isStatic = components.number("Static").value_or(0) != 0;
  if (entity.kind == EntityState::Kind::kWorld) entity.gravity = vectorOfComponent(components.text("Gravity"));
  if (const auto inertial = components.message<im::Inertial>("Inertial")) entity.inertial = inertialOf(*inertial);
  if (entity.kind == EntityState::Kind::kJoint) readJoint(components, entity);
  if (entity.kind == EntityState::Kind::kSensor) readSensor(components, entity);
  return entity;
}

}  // namespace

std::vector<EntityState> entitiesOf(const Message& step) {
  std::vector<EntityState> entities;
  for (const auto& [id, entity] : static_cast<const im::SerializedStepMap&>(step).state().entities()) {
    entities.push_back(entityOf(id, entity));
  }
  std::ranges::sort(entities, {}, &EntityState::id);
  return entities;
}

}  // namespace pongsim::msgs
