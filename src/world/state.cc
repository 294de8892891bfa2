#include "world/state.hh"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/hash.hh"
#include "description/limits.hh"
#include "pongsim/handles.hh"

namespace pongsim::world {

namespace {

void add(base::Hash& hash, const Vector3& vector) {
  for (const double value : {vector.x(), vector.y(), vector.z()}) hash.add(value);
}

void add(base::Hash& hash, const Quaternion& rotation) {
  for (const double value : {rotation.w(), rotation.x(), rotation.y(), rotation.z()}) hash.add(value);
}

bool isWithin(const Vector3& vector, double bound) { return vector.cwiseAbs().maxCoeff() <= bound; }

Place placeOf(const description::SphericalCoordinates& place) {
  return {place.isGiven, {place.latitude, place.longitude, place.elevation}, place.heading};
}

}  // namespace

State::State(const Entities& entities)
    : gravity(entities.description().gravity),
      stepSize(entities.description().physics.maxStepSize),
      realTimeFactor(entities.description().physics.realTimeFactor),
      place(placeOf(entities.description().environment.sphericalCoordinates)),
      wind(entities.description().environment.wind) {
  grow(entities);
}

void State::grow(const Entities& entities) {
  for (Slot link = links.size(); link < entities.links().size(); ++link) {
    links.emplace_back().X_WorldLink = entities.links()[link].X_WorldLinkStart;
  }
  joints.resize(entities.joints().size());
}

void State::undoInsertions(const Entities& entities) noexcept {
  links.resize(std::min(links.size(), entities.links().size()));
  joints.resize(std::min(joints.size(), entities.joints().size()));
}

void State::remove(const Removal& removal) {
  eraseSlots(links, removal.links);
  eraseSlots(joints, removal.joints);
  for (const ModelId model : removal.models) actuators.erase(model);
  std::erase_if(batteries,
                [&](const BatteryState& battery) { return std::ranges::binary_search(removal.models, battery.model); });
}

namespace {

void transferActuators(StateArchive& archive, std::map<ModelId, std::vector<double>>& actuators) {
  std::size_t count = actuators.size();
  archive(count);
  if (!archive.isGiving()) {
    for (auto& [model, values] : actuators) {
      ModelId id = model;
      archive(id.value);
      archive(values);
    }
    return;
  }
  actuators.clear();
  archive.check(count <= archive.rest().size());
  for (std::size_t i = 0; i < count; ++i) {
    ModelId model;
    archive(model.value);
    archive(actuators[model]);
  }
}

}  // namespace

void transfer(StateArchive& archive, State& state) {
  archive(state.time);
  archive(state.iterations);
  archive(state.gravity);
  archive(state.stepSize);
  archive(state.realTimeFactor);
  // far from the last time, so that what follows can be saved, too
  archive.check(state.time >= Time::zero() && state.time <= StateArchive::kLastTime / 2 &&
                isWithin(state.gravity, description::kLargestGravity) && state.stepSize > Time::zero() &&
                toSeconds(state.stepSize) <= description::kLongestSavedStep && state.realTimeFactor >= 0);
  archive(state.place.isKnown);
  for (double* value : {&state.place.origin.latitude, &state.place.origin.longitude, &state.place.origin.altitude,
                        &state.place.heading}) {
    archive(*value);
  }
  archive(state.wind);
  archive.check(state.wind.stableNorm() <= kFastestWind);
  for (LinkState& link : state.links) {
    archive(link.X_WorldLink);
    archive(link.v_WorldLink);
    archive(link.w_WorldLink);
    archive.check(isWithin(link.X_WorldLink.position, description::kFarthestSaved) &&
                  isWithin(link.v_WorldLink, description::kFastestSaved) &&
                  isWithin(link.w_WorldLink, description::kFastestSaved));
  }
  for (JointState& joint : state.joints) {
    for (double* value : {&joint.position, &joint.velocity, &joint.position2, &joint.velocity2}) archive(*value);
  }
  transferActuators(archive, state.actuators);
}

bool isOutOfPower(const State& state, ModelId model) {
  bool has = false;
  for (const BatteryState& battery : state.batteries) {
    if (battery.model != model) continue;
    if (battery.charge > 0) return false;
    has = true;
  }
  return has;
}

Pose modelPose(const Entities& entities, const State& state, Slot model) {
  const ModelRecord& record = entities.models()[model];
  if (record.canonicalLink == kNoSlot) return record.X_CanonicalModel;
  return state.links[record.canonicalLink].X_WorldLink * record.X_CanonicalModel;
}

Pose poseInParent(const Entities& entities, const State& state, Slot model) {
  const Slot parent = entities.models()[model].parent;
  const Pose X_WorldModel = modelPose(entities, state, model);
  return parent == kNoSlot ? X_WorldModel : modelPose(entities, state, parent).inverse() * X_WorldModel;
}

Pose poseInModel(const Entities& entities, const State& state, Slot link) {
  // the model moves with this one: no rounding
  const LinkRecord& record = entities.links()[link];
  if (entities.models()[record.model].canonicalLink == link) return record.description->X_ModelLink;
  return modelPose(entities, state, entities.links()[link].model).inverse() * state.links[link].X_WorldLink;
}

std::uint64_t stateHash(const State& state) {
  base::Hash hash;
  hash.add(static_cast<std::uint64_t>(state.time.count()));
  hash.add(state.iterations);
  hash.add(static_cast<std::uint64_t>(state.links.size()));
  for (const LinkState& link : state.links) {
    add(hash, link.X_WorldLink.position);
    add(hash, link.X_WorldLink.rotation);
    add(hash, link.v_WorldLink);
    add(hash, link.w_WorldLink);
  }
  hash.add(static_cast<std::uint64_t>(state.joints.size()));
  for (const JointState& joint : state.joints) {
    for (const double value : {joint.position, joint.velocity, joint.position2, joint.velocity2}) hash.add(value);
  }
  return hash.value();
}

}  // namespace pongsim::world
