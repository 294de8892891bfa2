#include "msgs/state/state_message.hh"

#include <ignition/msgs/actor.pb.h>
#include <ignition/msgs/axis.pb.h>
#include <ignition/msgs/double_v.pb.h>
#include <ignition/msgs/geometry.pb.h>
#include <ignition/msgs/inertial.pb.h>
#include <ignition/msgs/light.pb.h>
#include <ignition/msgs/material.pb.h>
#include <ignition/msgs/scene.pb.h>
#include <ignition/msgs/sensor.pb.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "msgs/fields/time.hh"
#include "msgs/scene/actor_message.hh"
#include "msgs/scene/geometry_message.hh"
#include "msgs/scene/light_message.hh"
#include "msgs/scene/material_message.hh"
#include "msgs/scene/sensor_message.hh"
#include "msgs/scene/surroundings_message.hh"
#include "msgs/state/component.hh"
#include "pongsim/messages/fields.hh"

namespace pongsim::msgs {

namespace {

namespace im = ignition::msgs;
using world::kNoSlot;
using world::Slot;

/// Adds components to one entity.
class EntityWriter {
 public:
  EntityWriter(std::uint64_t id, im::SerializedStateMap& state) : entity_((*state.mutable_entities())[id]) {
    entity_.set_id(id);
  }

  void add(std::string_view name, std::string bytes = {}) {
    const std::uint64_t type = componentType(name);
    im::SerializedComponent& component = (*entity_.mutable_components())[static_cast<std::int64_t>(type)];
    component.set_type(type);
    component.set_component(std::move(bytes));
  }
  void add(std::string_view name, const Message& message) { add(name, message.SerializeAsString()); }

  /// Adds what all entities but the world have.
  void addPlace(std::string_view kind, std::string_view name, std::uint64_t parent) {
    add(kind);
    add("Name", std::string(name));
    add("ParentEntity", std::to_string(parent));
  }

 private:
  im::SerializedEntityMap& entity_;
};

im::Inertial inertialMessage(const description::Inertial& inertial) {
  im::Inertial message;
  message.set_mass(inertial.mass);
  setPose(inertial.X_LinkCom, *message.mutable_pose());
  message.set_ixx(inertial.moments(0, 0));
  message.set_ixy(inertial.moments(0, 1));
  message.set_ixz(inertial.moments(0, 2));
  message.set_iyy(inertial.moments(1, 1));
  message.set_iyz(inertial.moments(1, 2));
  message.set_izz(inertial.moments(2, 2));
  return message;
}

im::Axis axisMessage(const description::JointAxis& axis) {
  im::Axis message;
  setVector(axis.xyz, *message.mutable_xyz());
  message.set_limit_lower(axis.lower);
  message.set_limit_upper(axis.upper);
  message.set_limit_effort(axis.effort);
  message.set_limit_velocity(axis.velocity);
  message.set_damping(axis.damping);
  message.set_friction(axis.friction);
  return message;
}

class StateWriter {
 public:
  StateWriter(const world::Entities& entities, const world::State& state, const ChangedProperties& changed,
              im::SerializedStateMap& message)
      : entities_(entities), state_(state), changed_(changed), message_(message) {}

  void writeAll() {
    EntityWriter worldEntity(entities_.worldId().value, message_);
    worldEntity.add("World");
    worldEntity.add("Name", entities_.description().name);
    worldEntity.add("Gravity", componentText(state_.gravity));
    im::Scene surroundings;
    setSurroundings(entities_.description().scene, surroundings);
    worldEntity.add("Scene", surroundings);
    for (const world::ModelRecord& model : world::present(entities_.models())) writeModel(model);
    for (const world::LinkRecord& link : world::present(entities_.links())) writeLink(link);
    for (const world::CollisionRecord& collision : world::present(entities_.collisions())) {
      EntityWriter entity(collision.id.value, message_);
      entity.addPlace("Collision", collision.description->name, entities_.links()[collision.link].id.value);
      entity.add("Pose", componentText(collision.description->X_LinkCollision));
      entity.add("Geometry", bytesOf(collision.description->geometry));
    }
    for (const world::JointRecord& joint : world::present(entities_.joints())) writeJoint(joint);
    for (const world::LightRecord& light : world::present(entities_.lights())) writeLight(light);
    for (const world::SensorRecord& sensor : world::present(entities_.sensors())) writeSensor(sensor);
    for (const world::ActorRecord& actor : world::present(entities_.actors())) writeActor(actor);
    for (const world::BatteryState& battery : state_.batteries) {
      if (entities_.slot(battery.model) == kNoSlot) continue;
      EntityWriter entity(battery.id.value, message_);
      entity.add("Name", battery.name);
      entity.add("ParentEntity", std::to_string(battery.model.value));
    }
  }

  /// @param isAll Includes those that do not move.
  void writeMoving(bool isAll) {
    for (Slot slot = 0; slot < entities_.models().size(); ++slot) {
      const world::ModelRecord& model = entities_.models()[slot];
      if (model.isSetAside || (!isAll && model.isStatic)) continue;
      EntityWriter(model.id.value, message_).add("Pose", componentText(world::poseInParent(entities_, state_, slot)));
    }
    for (Slot slot = 0; slot < entities_.links().size(); ++slot) {
      const world::LinkRecord& link = entities_.links()[slot];
      if (link.isSetAside || (!isAll && link.isStatic)) continue;
      EntityWriter(link.id.value, message_).add("Pose", componentText(world::poseInModel(entities_, state_, slot)));
    }
    for (Slot slot = 0; slot < entities_.joints().size(); ++slot) {
      const std::size_t axes = entities_.joints()[slot].description->axes.size();
      if (axes == 0 || entities_.joints()[slot].isSetAside) continue;
      const world::JointState& joint = state_.joints[slot];
      im::Double_V positions, velocities;
      positions.add_data(joint.position);
      velocities.add_data(joint.velocity);
      if (axes > 1) positions.add_data(joint.position2);
      if (axes > 1) velocities.add_data(joint.velocity2);
      EntityWriter entity(entities_.joints()[slot].id.value, message_);
      entity.add("JointPosition", positions);
      entity.add("JointVelocity", velocities);
    }
    for (const world::BatteryState& battery : state_.batteries) {
      if (entities_.slot(battery.model) == kNoSlot) continue;
      EntityWriter(battery.id.value, message_).add("BatterySoC", componentText(battery.charge));
    }
    for (const world::ActorRecord& actor : world::present(entities_.actors())) writeMotion(actor);
  }

 private:
  void writeModel(const world::ModelRecord& model) {
    const std::uint64_t parent =
        model.parent == kNoSlot ? entities_.worldId().value : entities_.models()[model.parent].id.value;
    EntityWriter entity(model.id.value, message_);
    entity.addPlace("Model", model.description->name, parent);
    entity.add("Static", model.isStatic ? "1" : "0");
    entity.add("SelfCollide", model.description->selfCollide ? "1" : "0");
  }

  void writeLink(const world::LinkRecord& link) {
    EntityWriter entity(link.id.value, message_);
    const world::ModelRecord& model = entities_.models()[link.model];
    entity.addPlace("Link", link.description->name, model.id.value);
    entity.add("Inertial", inertialMessage(inertialNow(link)));
    if (model.canonicalLink != kNoSlot && &entities_.links()[model.canonicalLink] == &link) entity.add("CanonicalLink");
    for (std::size_t i = 0; i < link.description->visuals.size(); ++i) {
      writeVisual(link.description->visuals[i], visualId(link, i), link.id.value);
    }
  }

  description::Inertial inertialNow(const world::LinkRecord& link) const {
    description::Inertial inertial = link.description->inertial;
    const auto found = changed_.masses.find(link.id);
    if (found == changed_.masses.end()) return inertial;
    inertial.mass = found->second.mass;
    inertial.moments *= found->second.inertiaFactor;
    return inertial;
  }

  /// The script in the message tells how the actor moves.
  void writeActor(const world::ActorRecord& actor) {
    EntityWriter entity(actor.id.value, message_);
    im::Actor settings;
    setActor(*actor.description, settings);
    entity.add("Actor", settings);
    entity.add("Name", actor.description->name);
    entity.add("ParentEntity", std::to_string(entities_.worldId().value));
    entity.add("Pose", componentText(actor.description->X_WorldActor));
    for (std::size_t i = 0; i < actor.description->visuals.size(); ++i) {
      writeVisual(actor.description->visuals[i], visualId(actor, i), actor.id.value);
    }
  }

  /// For an actor moved by a system: the height is in its pose, the rest in its trajectory's pose, as in Fortress's
  /// FollowActor.
  void writeMotion(const world::ActorRecord& actor) {
    const auto moved = std::ranges::find(state_.actors, actor.description, &world::ActorState::description);
    if (moved == state_.actors.end()) return;
    EntityWriter entity(actor.id.value, message_);
    Pose height;
    height.position.z() = moved->X_WorldActor.position.z();
    entity.add("Pose", componentText(height));
    entity.add("TrajectoryPose", componentText(height.inverse() * moved->X_WorldActor));
    entity.add("AnimationName", moved->animation);
    entity.add("AnimationTime", std::to_string(moved->animationTime.count()));
  }

  void writeVisual(const description::Visual& visual, VisualId id, std::uint64_t parent) {
    EntityWriter entity(id.value, message_);
    entity.addPlace("Visual", visual.name, parent);
    entity.add("Pose", componentText(visual.X_LinkVisual));
    entity.add("CastShadows", visual.castsShadows ? "1" : "0");
    entity.add("Transparency", componentText(visual.transparency));
    entity.add("VisibilityFlags", std::to_string(visual.visibilityFlags));
    if (visual.laserRetro != 0) entity.add("LaserRetro", componentText(visual.laserRetro));
    entity.add("Geometry", bytesOf(visual.geometry));
    const std::optional<description::Material> now = materialNow(visual, id, changed_);
    if (!now) return;
    im::Material material;
    setMaterial(*now, material);
    entity.add("Material", material);
  }

  void writeJoint(const world::JointRecord& joint) {
    EntityWriter entity(joint.id.value, message_);
    const description::Joint& description = *joint.description;
    entity.addPlace("Joint", description.name,
                    joint.model == kNoSlot ? entities_.worldId().value : entities_.models()[joint.model].id.value);
    entity.add("Pose", componentText(description.X_ChildJoint));
    entity.add("JointType", std::to_string(jointTypeNumber(description::name(description.type))));
    entity.add("ParentLinkName", description.parent);
    entity.add("ChildLinkName", description.child);
    if (!description.axes.empty()) entity.add("JointAxis", axisMessage(description.axes[0]));
    if (description.axes.size() > 1) entity.add("JointAxis2", axisMessage(description.axes[1]));
  }

  void writeLight(const world::LightRecord& light) {
    const std::uint64_t parent =
        light.link == kNoSlot ? entities_.worldId().value : entities_.links()[light.link].id.value;
    EntityWriter entity(light.id.value, message_);
    im::Light settings;
    setLight(*light.description, settings);
    entity.add("Light", settings);
    entity.add("Name", light.description->name);
    entity.add("ParentEntity", std::to_string(parent));
    entity.add("Pose", componentText(light.description->X_ParentLight));
  }

  void writeSensor(const world::SensorRecord& sensor) {
    const std::uint64_t parent =
        sensor.link == kNoSlot ? entities_.joints()[sensor.joint].id.value : entities_.links()[sensor.link].id.value;
    EntityWriter entity(sensor.id.value, message_);
    entity.addPlace("Sensor", sensor.description->name, parent);
    entity.add("Pose", componentText(sensor.description->X_ParentSensor));
    const std::string_view component = sensorComponent(sensor.description->type);
    if (component.empty()) return;
    im::Sensor settings;
    setSensor(*sensor.description, settings);
    entity.add(component, settings);
  }

  static std::string bytesOf(const description::Geometry& geometry) {
    im::Geometry message;
    setGeometry(geometry, message);
    return message.SerializeAsString();
  }

  const world::Entities& entities_;
  const world::State& state_;
  const ChangedProperties& changed_;
  im::SerializedStateMap& message_;
};

}  // namespace

void setState(const world::Entities& entities, const world::State& state, StateContent content, bool isPaused,
              Message& step, const ChangedProperties& changed) {
  auto& message = static_cast<im::SerializedStepMap&>(step);
  message.Clear();
  setTime(state.time, *message.mutable_stats()->mutable_sim_time());
  setTime(state.stepSize, *message.mutable_stats()->mutable_step_size());
  message.mutable_stats()->set_iterations(state.iterations);
  message.mutable_stats()->set_paused(isPaused);
  setTime(state.time, *message.mutable_state()->mutable_header()->mutable_stamp());
  try {
    StateWriter writer(entities, state, changed, *message.mutable_state());
    if (content == StateContent::kAll) writer.writeAll();
    writer.writeMoving(content == StateContent::kAll);
  } catch (...) {
    // a protobuf map that could not get memory to grow crashes when it is destroyed or cleared
    static_cast<void>(message.unsafe_arena_release_state());
    throw;
  }
}

}  // namespace pongsim::msgs
