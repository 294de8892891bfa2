#include "msgs/control/edit_messages.hh"

#include <ignition/msgs/entity.pb.h>
#include <ignition/msgs/entity_factory_v.pb.h>
#include <ignition/msgs/joint.pb.h>
#include <ignition/msgs/link.pb.h>
#include <ignition/msgs/physics.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/spherical_coordinates.pb.h>
#include <ignition/msgs/visual.pb.h>
#include <ignition/msgs/wheel_slip_parameters_cmd.pb.h>

#include <numbers>

#include "msgs/scene/pose_message.hh"

namespace pongsim::msgs {

namespace {

namespace im = ignition::msgs;

PlaceOnEarth placeFrom(const im::SphericalCoordinates& message) {
  constexpr double kDegree = std::numbers::pi / 180;
  return {{message.latitude_deg() * kDegree, message.longitude_deg() * kDegree, message.elevation()},
          message.heading_deg() * kDegree};
}

EntityFactory factoryFrom(const im::EntityFactory& message) {
  EntityFactory factory;
  factory.text = message.sdf();
  factory.file = message.sdf_filename();
  factory.name = message.name();
  factory.allowRenaming = message.allow_renaming();
  if (message.has_pose()) factory.pose = poseFrom(message.pose());
  if (message.has_model()) factory.unknownField = "model";
  if (message.has_light()) factory.light = &message.light();
  factory.original = message.clone_name();
  if (message.has_spherical_coordinates()) factory.place = placeFrom(message.spherical_coordinates());
  if (!message.relative_to().empty()) factory.unknownField = "relative_to";
  return factory;
}

EntityName nameFrom(const im::Entity& message) {
  return {message.id(), message.name(), im::Entity::Type_Name(message.type())};
}

PoseOfEntity poseOf(const im::Pose& message) { return {{message.id(), message.name(), {}}, poseFrom(message)}; }

}  // namespace

EntityFactory entityFactory(const Message& message) {
  return factoryFrom(static_cast<const im::EntityFactory&>(message));
}

std::vector<EntityFactory> entityFactories(const Message& message) {
  std::vector<EntityFactory> all;
  for (const im::EntityFactory& each : static_cast<const im::EntityFactory_V&>(message).data()) {
    all.push_back(factoryFrom(each));
  }
  return all;
}

EntityName entityName(const Message& message) { return nameFrom(static_cast<const im::Entity&>(message)); }

PoseOfEntity poseOfEntity(const Message& message) { return poseOf(static_cast<const im::Pose&>(message)); }

std::vector<PoseOfEntity> posesOfEntities(const Message& message) {
  std::vector<PoseOfEntity> all;
  for (const im::Pose& each : static_cast<const im::Pose_V&>(message).pose()) all.push_back(poseOf(each));
  return all;
}

PlaceOfEntity placeOfEntity(const Message& message) {
  const auto& asked = static_cast<const im::SphericalCoordinates&>(message);
  PlaceOfEntity place{{}, placeFrom(asked)};
  if (asked.has_entity()) place.entity = nameFrom(asked.entity());
  return place;
}

PhysicsSettings physicsSettings(const Message& message) {
  const auto& physics = static_cast<const im::Physics&>(message);
  PhysicsSettings settings{physics.max_step_size(), physics.real_time_factor(), {}};
  if (physics.has_gravity()) settings.gravity = vectorFrom(physics.gravity());
  return settings;
}

WheelSlip wheelSlip(const Message& message) {
  const auto& asked = static_cast<const im::WheelSlipParametersCmd&>(message);
  return {nameFrom(asked.entity()), asked.slip_compliance_lateral(), asked.slip_compliance_longitudinal()};
}

VisualLook visualLook(const Message& message) {
  const auto& asked = static_cast<const im::Visual&>(message);
  VisualLook look{asked.id(), asked.name(), asked.parent_name(), asked.parent_id(), {}};
  const im::Material& material = asked.material();
  const auto rgb = [](const im::Color& color) { return Vector3(color.r(), color.g(), color.b()); };
  if (material.has_diffuse()) look.colors.diffuse = rgb(material.diffuse());
  if (material.has_ambient()) look.colors.ambient = rgb(material.ambient());
  if (material.has_specular()) look.colors.specular = rgb(material.specular());
  if (material.has_emissive()) look.colors.emissive = rgb(material.emissive());
  return look;
}

LinkMass linkMass(const Message& message) {
  const auto& asked = static_cast<const im::Link&>(message);
  LinkMass mass{{asked.id(), asked.name(), {}}, {}};
  if (asked.has_inertial()) mass.mass = asked.inertial().mass();
  return mass;
}

JointPositions jointPositions(const Message& message) {
  const auto& asked = static_cast<const im::Joint&>(message);
  JointPositions positions{{asked.id(), asked.name(), {}}, {}};
  if (asked.has_axis1()) positions.positions[0] = asked.axis1().position();
  if (asked.has_axis2()) positions.positions[1] = asked.axis2().position();
  return positions;
}

void setWheelSlip(const WheelSlip& slip, Message& message) {
  auto& command = static_cast<im::WheelSlipParametersCmd&>(message);
  command.mutable_entity()->set_id(slip.entity.id);
  command.mutable_entity()->set_name(slip.entity.name);
  im::Entity::Type type = im::Entity::NONE;
  if (im::Entity::Type_Parse(slip.entity.type, &type)) command.mutable_entity()->set_type(type);
  command.set_slip_compliance_lateral(slip.lateral);
  command.set_slip_compliance_longitudinal(slip.longitudinal);
}

}  // namespace pongsim::msgs
