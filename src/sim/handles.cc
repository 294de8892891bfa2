#include "pongsim/handles.hh"

#include <cmath>

#include "sim/access.hh"

namespace pongsim {

namespace {

const world::LinkRecord& record(const sim::Access& access, LinkId id) {
  return access.entities.links()[access.entities.slot(id)];
}

const world::JointRecord& record(const sim::Access& access, JointId id) {
  return access.entities.joints()[access.entities.slot(id)];
}

const world::ModelRecord& record(const sim::Access& access, ModelId id) {
  return access.entities.models()[access.entities.slot(id)];
}

/// @return Whether the joint can take `value` for the axis; else it has warned.
bool canCommand(const sim::Access& access, const Joint& joint, double value, int axis) {
  if (axis < 0 || axis >= joint.axisCount()) {
    access.log.warning("joint '" + std::string(joint.name()) + "' has no axis " + std::to_string(axis) + " to command");
    return false;
  }
  if (!std::isfinite(value)) {
    access.log.warning("joint '" + std::string(joint.name()) + "' was given a command that is not a finite number");
    return false;
  }
  return true;
}

}  // namespace

std::string_view Link::name() const { return record(*access_, id_).description->name; }

Pose Link::pose() const { return access_->state.links[access_->entities.slot(id_)].X_WorldLink; }

Vector3 Link::linearVelocity() const { return access_->state.links[access_->entities.slot(id_)].v_WorldLink; }

Vector3 Link::angularVelocity() const { return access_->state.links[access_->entities.slot(id_)].w_WorldLink; }

void Link::addWrench(const Vector3& force, const Vector3& torque) {
  if (!force.allFinite() || !torque.allFinite()) {
    access_->log.warning("link '" + std::string(name()) + "' was given a wrench that is not finite");
    return;
  }
  access_->engine.addLinkWrench(access_->entities.slot(id_), force, torque);
}

std::string_view Joint::name() const { return record(*access_, id_).description->name; }

int Joint::axisCount() const { return static_cast<int>(record(*access_, id_).description->axes.size()); }

double Joint::position(int axis) const {
  return axis == 0 ? access_->state.joints[access_->entities.slot(id_)].position : 0;
}

double Joint::velocity(int axis) const {
  return axis == 0 ? access_->state.joints[access_->entities.slot(id_)].velocity : 0;
}

void Joint::setVelocityTarget(double velocity, int axis) {
  if (!canCommand(*access_, *this, velocity, axis)) return;
  access_->engine.setJointVelocityTarget(access_->entities.slot(id_), velocity);
}

void Joint::addForce(double force, int axis) {
  if (!canCommand(*access_, *this, force, axis)) return;
  access_->engine.addJointForce(access_->entities.slot(id_), force);
}

std::string_view Model::name() const { return record(*access_, id_).description->name; }

std::string Model::scopedName() const { return record(*access_, id_).scopedName; }

Pose Model::pose() const { return world::modelPose(access_->entities, access_->state, access_->entities.slot(id_)); }

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
  const world::Slot slot = access_->entities.findLink(access_->entities.slot(id_), name);
  if (slot == world::kNoSlot) return std::nullopt;
  return Link(*access_, access_->entities.links()[slot].id);
}

std::optional<Joint> Model::joint(std::string_view name) const {
  const world::Slot slot = access_->entities.findJoint(access_->entities.slot(id_), name);
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

std::string_view World::name() const { return access_->entities.description().name; }

WorldId World::id() const { return access_->entities.worldId(); }

Vector3 World::gravity() const { return access_->entities.description().gravity; }

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

}  // namespace pongsim
