#include "pongsim/handles.hh"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "description/limits.hh"
#include "sim/api/access.hh"
#include "sim/edits/editor.hh"
#include "sim/state/joint_reset.hh"
#include "sim/system_slot.hh"

namespace pongsim {

namespace {

using sim::slotOf;

const world::LinkRecord& record(const sim::Access& access, LinkId id) {
  return access.entities.links()[slotOf(access, id)];
}

const world::JointRecord& record(const sim::Access& access, JointId id) {
  return access.entities.joints()[slotOf(access, id)];
}

const world::ModelRecord& record(const sim::Access& access, ModelId id) {
  return access.entities.models()[slotOf(access, id)];
}

/// Checks a command to an axis of a joint, and reports an invalid one.
/// @param most Largest magnitude.
bool canCommand(sim::Access& access, const Joint& joint, double value, int axis, double most, const char* limits) {
  // asks the engine, whose joint gets the command anyway: the joint's description may be in no cache
  if (axis < 0 || !access.engine.hasAxis(slotOf(access, joint.id()), static_cast<std::size_t>(axis))) {
    access.refuse("joint '" + std::string(joint.name()) + "' has no axis " + std::to_string(axis) + " to command");
    return false;
  }
  if (!std::isfinite(value)) {
    access.refuse("joint '" + std::string(joint.name()) + "' was given a command that is not a finite number");
    return false;
  }
  if (std::abs(value) > most) {
    access.refuse("joint '" + std::string(joint.name()) + "' was given a command beyond " + limits);
    return false;
  }
  return true;
}

}  // namespace

bool Link::exists() const { return access_->entities.slot(id_) != world::kNoSlot; }

std::string_view Link::name() const { return record(*access_, id_).description->name; }

Pose Link::pose() const { return access_->state.links[slotOf(*access_, id_)].X_WorldLink; }

Pose Link::poseInModel() const { return world::poseInModel(access_->entities, access_->state, slotOf(*access_, id_)); }

Vector3 Link::linearVelocity() const { return access_->state.links[slotOf(*access_, id_)].v_WorldLink; }

Vector3 Link::angularVelocity() const { return access_->state.links[slotOf(*access_, id_)].w_WorldLink; }

void Link::addWrench(const Vector3& force, const Vector3& torque) {
  if (!sim::isWithin(force, sim::kMostForce) || !sim::isWithin(torque, sim::kMostForce)) {
    access_->refuse("link '" + std::string(name()) + "' was given a wrench that is not finite or beyond " +
                    sim::kMostForceText);
    return;
  }
  access_->engine.addLinkWrench(slotOf(*access_, id_), force, torque);
}

void Link::setVelocity(const Vector3& linear, const Vector3& angular) {
  if (!sim::isWithin(linear, sim::kMostVelocity) || !sim::isWithin(angular, sim::kMostVelocity)) {
    access_->refuse("link '" + std::string(name()) + "' was given a velocity that is not finite or beyond " +
                    sim::kMostVelocityText);
    return;
  }
  sim::Editor(*access_).setLinkVelocity(slotOf(*access_, id_), linear, angular);
  if (access_->outsider == nullptr) return;
  access_->outsider->note(
      {.kind = sim::OutsideChange::Kind::kSetLinkVelocity, .id = id_.value, .linear = linear, .angular = angular});
}

MassInfo Link::mass() const {
  const description::Inertial& inertial = record(*access_, id_).description->inertial;
  const Matrix3 axes = inertial.X_LinkCom.rotation.toRotationMatrix();
  const physics::Engine::Mass now = access_->engine.mass(slotOf(*access_, id_));
  // as in the file for a link that does not move
  const bool isChanged = now.mass > 0;
  Matrix3 inertia = axes * inertial.moments * axes.transpose();
  if (isChanged && now.stretch != Vector3::Ones()) {
    const physics::Engine::Inertia file = access_->engine.inertiaOfFile(slotOf(*access_, id_));
    const Matrix3 principal = file.q_LinkAxes.toRotationMatrix();
    inertia = principal * file.moments.cwiseProduct(now.stretch).asDiagonal() * principal.transpose();
  }
  return {isChanged ? now.mass : inertial.mass, inertial.X_LinkCom.position,
          isChanged && now.inertiaFactor != 1 ? Matrix3(inertia * now.inertiaFactor) : inertia,
          inertial.X_LinkCom.rotation};
}

Outcome<void> Link::setPose(const Pose& X_WorldLink, AfterMove after) {
  Outcome<void> set = sim::Editor(*access_).setLinkPose(slotOf(*access_, id_), X_WorldLink, after);
  if (set && access_->outsider != nullptr) {
    access_->outsider->note({.kind = sim::OutsideChange::Kind::kSetLinkPose,
                             .id = id_.value,
                             .pose = X_WorldLink,
                             .after = static_cast<std::uint8_t>(after)});
  }
  return set;
}

Model Link::model() const { return Model(*access_, access_->entities.models()[record(*access_, id_).model].id); }

std::string Link::scopedName() const { return model().scopedName() + "::" + std::string(name()); }

bool Link::isInWind() const {
  const world::LinkRecord& link = record(*access_, id_);
  return link.description->isInWind.value_or(false) || access_->entities.models()[link.model].description->isInWind;
}

bool Joint::exists() const { return access_->entities.slot(id_) != world::kNoSlot; }

std::string_view Joint::name() const { return record(*access_, id_).description->name; }

int Joint::axisCount() const { return static_cast<int>(record(*access_, id_).description->axes.size()); }

double Joint::position(int axis) const {
  const world::JointState& state = access_->state.joints[slotOf(*access_, id_)];
  return axis == 0 ? state.position : axis == 1 ? state.position2 : 0;
}

double Joint::velocity(int axis) const {
  const world::JointState& state = access_->state.joints[slotOf(*access_, id_)];
  return axis == 0 ? state.velocity : axis == 1 ? state.velocity2 : 0;
}

void Joint::setVelocityTarget(double velocity, int axis) {
  if (!canCommand(*access_, *this, velocity, axis, sim::kMostVelocity, sim::kMostVelocityText)) return;
  access_->engine.setJointVelocityTarget(slotOf(*access_, id_), velocity, static_cast<std::size_t>(axis));
}

void Joint::clearVelocityTarget(int axis) {
  if (!canCommand(*access_, *this, 0, axis, sim::kMostVelocity, sim::kMostVelocityText)) return;
  access_->engine.clearJointVelocityTarget(slotOf(*access_, id_), static_cast<std::size_t>(axis));
}

void Joint::addForce(double force, int axis) {
  if (!canCommand(*access_, *this, force, axis, sim::kMostForce, sim::kMostForceText)) return;
  access_->engine.addJointForce(slotOf(*access_, id_), force, static_cast<std::size_t>(axis));
}

Outcome<void> Joint::resetPosition(double position, int axis) {
  const world::Slot slot = slotOf(*access_, id_);
  if (axis < 0 || axis >= axisCount())
    return {"joint '" + std::string(name()) + "' has no axis " + std::to_string(axis)};
  return sim::resetJointPosition(*access_, slot, static_cast<std::size_t>(axis), position);
}

Outcome<void> Joint::resetVelocity(double velocity, int axis) {
  const world::Slot slot = slotOf(*access_, id_);
  if (axis < 0 || axis >= axisCount())
    return {"joint '" + std::string(name()) + "' has no axis " + std::to_string(axis)};
  return sim::resetJointVelocity(*access_, slot, static_cast<std::size_t>(axis), velocity);
}

std::string_view Joint::type() const { return description::name(record(*access_, id_).description->type); }

std::optional<Link> Joint::parent() const {
  const world::Slot slot = record(*access_, id_).parentLink;
  if (slot == world::kNoSlot) return std::nullopt;
  return Link(*access_, access_->entities.links()[slot].id);
}

Link Joint::child() const { return Link(*access_, access_->entities.links()[record(*access_, id_).childLink].id); }

Pose Joint::poseInChild() const { return record(*access_, id_).description->X_ChildJoint; }

Pose Joint::poseInParent() const { return record(*access_, id_).description->X_ParentJoint; }

Wrench Joint::reaction() const {
  const physics::Engine::Reaction reaction = access_->engine.jointReaction(slotOf(*access_, id_));
  return {reaction.force, reaction.torque};
}

bool Joint::isDriven() const { return access_->engine.isJointDriven(slotOf(*access_, id_)); }

JointAxisInfo Joint::axisInfo(int axis) const {
  const auto number = static_cast<std::size_t>(axis);
  const description::JointAxis& found = record(*access_, id_).description->axes.at(number);
  const world::Slot slot = slotOf(*access_, id_);
  const bool isAxis = access_->engine.hasAxis(slot, number);
  return {found.xyz,    found.lower,    found.upper,
          found.effort, found.velocity, isAxis ? access_->engine.resistance(slot, number).damping : found.damping};
}

double Joint::friction(int axis) const {
  const auto number = static_cast<std::size_t>(axis);
  const world::Slot slot = slotOf(*access_, id_);
  if (access_->engine.hasAxis(slot, number)) return access_->engine.resistance(slot, number).friction;
  return record(*access_, id_).description->axes.at(number).friction;
}

bool Model::exists() const { return access_->entities.slot(id_) != world::kNoSlot; }

std::string_view Model::name() const { return record(*access_, id_).description->name; }

std::string Model::scopedName() const { return record(*access_, id_).scopedName; }

Pose Model::pose() const { return world::modelPose(access_->entities, access_->state, slotOf(*access_, id_)); }

Pose Model::poseInParent() const {
  return world::poseInParent(access_->entities, access_->state, slotOf(*access_, id_));
}

bool Model::isStatic() const { return record(*access_, id_).isStatic; }

std::optional<Link> Model::canonicalLink() const {
  const world::Slot slot = record(*access_, id_).canonicalLink;
  if (slot == world::kNoSlot) return std::nullopt;
  return Link(*access_, access_->entities.links()[slot].id);
}

std::vector<Link> Model::links() const {
  std::vector<Link> handles;
  for (world::Slot slot : record(*access_, id_).links) {
    handles.push_back(Link(*access_, access_->entities.links()[slot].id));
  }
  return handles;
}

std::vector<Joint> Model::joints() const {
  std::vector<Joint> handles;
  for (world::Slot slot : record(*access_, id_).joints) {
    handles.push_back(Joint(*access_, access_->entities.joints()[slot].id));
  }
  return handles;
}

std::optional<Link> Model::link(std::string_view name) const {
  const world::Slot slot = access_->entities.findLink(slotOf(*access_, id_), name);
  if (slot == world::kNoSlot) return std::nullopt;
  return Link(*access_, access_->entities.links()[slot].id);
}

std::optional<Joint> Model::joint(std::string_view name) const {
  const world::Slot slot = access_->entities.findJoint(slotOf(*access_, id_), name);
  if (slot == world::kNoSlot) return std::nullopt;
  return Joint(*access_, access_->entities.joints()[slot].id);
}

std::vector<Model> Model::models() const {
  std::vector<Model> handles;
  for (world::Slot slot : record(*access_, id_).models) {
    handles.push_back(Model(*access_, access_->entities.models()[slot].id));
  }
  return handles;
}

std::optional<Model> Model::parent() const {
  const world::Slot slot = record(*access_, id_).parent;
  if (slot == world::kNoSlot) return std::nullopt;
  return Model(*access_, access_->entities.models()[slot].id);
}

void Model::setVelocity(const Vector3& linear, const Vector3& angular) {
  const std::optional<Link> canonical = canonicalLink();
  if (!canonical) return;
  if (!sim::isWithin(linear, sim::kMostVelocity) || !sim::isWithin(angular, sim::kMostVelocity)) {
    access_->refuse("model '" + scopedName() + "' was given a velocity that is not finite or beyond " +
                    sim::kMostVelocityText);
    return;
  }
  const Vector3 origin = pose().position;
  const Vector3 w_Now = canonical->angularVelocity();
  const Vector3 v_Now = canonical->linearVelocity() + w_Now.cross(origin - canonical->pose().position);
  changeVelocity(origin, linear - v_Now, angular - w_Now);
}

void Model::changeVelocity(const Vector3& origin, const Vector3& linear, const Vector3& angular) {
  // by slots: lists of handles would be allocated in each step
  const world::ModelRecord& model = record(*access_, id_);
  for (const world::Slot slot : model.links) {
    Link link(*access_, access_->entities.links()[slot].id);
    const Vector3 arm = link.pose().position - origin;
    link.setVelocity(link.linearVelocity() + linear + angular.cross(arm), link.angularVelocity() + angular);
  }
  for (const world::Slot slot : model.models) {
    Model(*access_, access_->entities.models()[slot].id).changeVelocity(origin, linear, angular);
  }
}

Outcome<void> Model::setPose(const Pose& X_WorldModel, AfterMove after) {
  Outcome<void> set = sim::Editor(*access_).setPose(slotOf(*access_, id_), X_WorldModel, after);
  if (set && access_->outsider != nullptr) {
    access_->outsider->note({.kind = sim::OutsideChange::Kind::kSetPose,
                             .id = id_.value,
                             .pose = X_WorldModel,
                             .after = static_cast<std::uint8_t>(after)});
  }
  return set;
}

const std::vector<double>* Model::actuators() const {
  const auto found = access_->state.actuators.find(id_);
  return found == access_->state.actuators.end() ? nullptr : &found->second;
}

void Model::setActuators(std::span<const double> values) {
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) {
    access_->refuse("the actuators of model '" + scopedName() + "' were given a value that is not finite");
    return;
  }
  slotOf(*access_, id_);
  access_->state.actuators[id_].assign(values.begin(), values.end());
}

bool Model::isInserted() const {
  world::Slot slot = slotOf(*access_, id_);
  const std::vector<world::ModelRecord>& models = access_->entities.models();
  while (models[slot].parent != world::kNoSlot) slot = models[slot].parent;
  return models[slot].owner != nullptr;
}

std::vector<const Element*> Model::plugins() const {
  std::vector<const Element*> elements;
  for (const description::Plugin& plugin : record(*access_, id_).description->plugins) elements.push_back(&plugin.sdf);
  return elements;
}

const UrdfSource* Model::urdf() const { return record(*access_, id_).description->urdf.source.get(); }

bool Model::isSetAside() const { return access_->entities.isSetAside(id_.value); }

std::string_view World::name() const { return access_->entities.description().name; }

WorldId World::id() const { return access_->entities.worldId(); }

Vector3 World::gravity() const { return access_->state.gravity; }

Outcome<void> World::setGravity(const Vector3& gravity) {
  if (!gravity.allFinite()) return {"gravity is not finite"};
  if (gravity.cwiseAbs().maxCoeff() > description::kLargestGravity) return {"gravity is beyond 1e6 m/s^2"};
  sim::Editor(*access_).setGravity(gravity);
  return {};
}

std::vector<Model> World::models() const {
  std::vector<Model> handles;
  for (world::Slot slot : access_->entities.topLevelModels()) {
    handles.push_back(Model(*access_, access_->entities.models()[slot].id));
  }
  return handles;
}

std::optional<Model> World::model(std::string_view name) const {
  const world::Slot slot = access_->entities.findModel(name);
  if (slot == world::kNoSlot) return std::nullopt;
  return Model(*access_, access_->entities.models()[slot].id);
}

std::optional<Model> World::model(ModelId id) const {
  if (access_->entities.slot(id) == world::kNoSlot) return std::nullopt;
  return Model(*access_, id);
}

std::optional<Link> World::link(LinkId id) const {
  if (access_->entities.slot(id) == world::kNoSlot) return std::nullopt;
  return Link(*access_, id);
}

std::optional<Joint> World::joint(JointId id) const {
  if (access_->entities.slot(id) == world::kNoSlot) return std::nullopt;
  return Joint(*access_, id);
}

Outcome<Joint> World::attach(const Link& parent, const Link& child, std::string_view name) {
  for (const Link& link : {parent, child}) {
    if (!link.exists()) {
      return {std::nullopt, "the link with the id " + std::to_string(link.id().value) + " no longer exists"};
    }
  }
  if (parent.id() == child.id()) return {std::nullopt, "a link can't be attached to itself"};
  const world::Slot slot =
      sim::Editor(*access_).attach(slotOf(*access_, parent.id()), slotOf(*access_, child.id()), std::string(name));
  return {Joint(*access_, access_->entities.joints()[slot].id), {}};
}

Outcome<void> World::detach(const Joint& joint) {
  if (!joint.exists()) return {"the joint no longer exists"};
  sim::Editor(*access_).detach(slotOf(*access_, joint.id()));
  return {};
}

void World::contacts(std::vector<Contact>& contacts) const { access_->engine.contacts(contacts); }

std::vector<WorldFrame> World::frames() const {
  std::vector<WorldFrame> frames;
  const world::Entities& entities = access_->entities;
  for (const description::Frame& frame : entities.description().frames) {
    if (frame.attachedLink == "world" || frame.attachedLink.empty()) {
      frames.push_back({frame.name, frame.X_ModelFrame});
      continue;
    }
    const world::Slot link = entities.findLink(frame.attachedLink);
    // an inserted model of that name is not the one to which the file attaches the frame
    if (link == world::kNoSlot || Model(*access_, entities.models()[entities.links()[link].model].id).isInserted()) {
      continue;
    }
    const Pose X_LinkFrame = entities.links()[link].X_WorldLinkStart.inverse() * frame.X_ModelFrame;
    frames.push_back({frame.name, access_->state.links[link].X_WorldLink * X_LinkFrame});
  }
  return frames;
}

bool World::isNameFree(std::string_view name) const { return sim::Editor(*access_).isFree(name); }

SourcePosition World::sourcePosition() const { return access_->entities.description().position; }

Vector3 World::magneticField() const { return access_->entities.description().environment.magneticField; }

double World::heading() const { return access_->state.place.heading; }

std::optional<TangentPlane> World::tangentPlane() const {
  const world::Place& place = access_->state.place;
  if (!place.isKnown) return std::nullopt;
  return TangentPlane(place.origin, place.heading);
}

Outcome<void> World::setPlace(const GeodeticPosition& origin, double heading) {
  if (!std::isfinite(origin.longitude) || !std::isfinite(origin.altitude) || !std::isfinite(heading)) {
    return {"the position is not finite"};
  }
  if (!(std::abs(origin.latitude) <= std::numbers::pi / 2)) return {"the latitude is not between -90 and 90 degrees"};
  access_->state.place = {true, origin, heading};
  return {};
}

Vector3 World::wind() const { return access_->state.wind; }

Outcome<void> World::setWind(const Vector3& wind) {
  // stableNorm, because the squares of finite components can overflow
  if (!wind.allFinite() || !(wind.stableNorm() <= kFastestWind)) {
    return {"the wind can't be faster than " + std::to_string(static_cast<int>(kFastestWind)) + " m/s"};
  }
  access_->state.wind = wind;
  return {};
}

double World::realTimeFactor() const { return access_->state.realTimeFactor; }

Outcome<void> World::setRealTimeFactor(double factor) {
  if (!(factor >= 0) || !std::isfinite(factor)) return {"a real-time factor must be zero or more"};
  access_->state.realTimeFactor = factor;
  return {};
}

void World::performers(std::vector<Performer>& performers) const { access_->levels.listPerformers(performers); }

Outcome<void> World::addPerformer(const Model& model, const Vector3& size, std::string_view name) {
  return access_->levels.add(model.id(), std::string(name), size);
}

}  // namespace pongsim
