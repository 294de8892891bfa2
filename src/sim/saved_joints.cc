#include "sim/saved_joints.hh"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/hash.hh"
#include "description/joint.hh"
#include "sim/editor.hh"

namespace pongsim::sim {

namespace {

void addPose(base::Hash& hash, const Pose& pose) {
  for (const double value : pose.position) hash.add(value);
  for (const double value : pose.rotation.coeffs()) hash.add(value);
}

/// Entities that are there, or a group that is set aside.
struct Holder {
  const std::vector<world::ModelRecord>& models;
  const std::vector<world::LinkRecord>& links;
  const std::vector<world::JointRecord>& joints;
};

std::string linkName(const Holder& holder, world::Slot link) {
  if (link == world::kNoSlot) return {};
  return holder.models[holder.links[link].model].scopedName + "::" + holder.links[link].description->name;
}

SavedJoint savedJoint(const Holder& holder, const world::JointRecord& joint) {
  const description::Joint& description = *joint.description;
  SavedJoint saved;
  saved.isMade = joint.owner != nullptr;
  if (saved.isMade) {
    saved.id = joint.id;
    saved.name = description.name;
    saved.parent = description.parent;
    saved.child = description.child;
    saved.X_ParentJoint = description.X_ParentJoint;
  }
  base::Hash hash;
  hash.add(joint.model == world::kNoSlot ? std::string() : holder.models[joint.model].scopedName);
  hash.add(description.name);
  hash.add(static_cast<std::uint64_t>(description.type));
  for (const world::Slot link : {joint.parentLink, joint.childLink, joint.referenceLink}) {
    hash.add(linkName(holder, link));
  }
  addPose(hash, description.X_ParentJoint);
  hash.add(saved.id.value);
  saved.key = hash.value();
  return saved;
}

using Joints = std::vector<std::pair<JointId, SavedJoint>>;

void addJoints(const Holder& holder, Joints& joints) {
  for (const world::JointRecord& joint : holder.joints) joints.emplace_back(joint.id, savedJoint(holder, joint));
}

/// @return In the order of their ids.
std::vector<SavedJoint> inOrder(Joints joints) {
  std::ranges::sort(joints, {}, &Joints::value_type::first);
  std::vector<SavedJoint> sorted;
  for (auto& [id, joint] : joints) sorted.push_back(std::move(joint));
  return sorted;
}

std::vector<SavedJoint> jointsOf(const world::Entities& entities) {
  Joints joints;
  addJoints({entities.models(), entities.links(), entities.joints()}, joints);
  return inOrder(std::move(joints));
}

bool isSame(const SavedJoint& a, const SavedJoint& b) { return a.key == b.key; }

/// @return Whether `wanted` is some of the file's joints in `present`, in their order, and then what was made.
bool canBecome(const std::vector<SavedJoint>& present, const std::vector<SavedJoint>& wanted) {
  auto next = wanted.begin();
  for (const SavedJoint& joint : present) {
    if (next != wanted.end() && !next->isMade && !joint.isMade && isSame(joint, *next)) ++next;
  }
  return std::all_of(next, wanted.end(), [](const SavedJoint& joint) { return joint.isMade; });
}

bool hasModelsOfTheStart(const world::Entities& entities, const world::Entities& start) {
  return std::ranges::equal(
      entities.models(), start.models(), [](const world::ModelRecord& a, const world::ModelRecord& b) {
        return a.scopedName == b.scopedName && a.owner == nullptr && a.description == b.description;
      });
}

}  // namespace

void SavedJoint::transfer(StateArchive& archive) {
  archive(key);
  archive(isMade);
  archive(id.value);
  for (std::string* text : {&name, &parent, &child}) archive(*text);
  archive(X_ParentJoint);
}

std::vector<SavedJoint> listJoints(const Access& access) {
  const world::Entities& entities = access.entities;
  Joints joints;
  addJoints({entities.models(), entities.links(), entities.joints()}, joints);
  for (const Shelved& shelved : access.shelf) {
    addJoints({shelved.entities.models, shelved.entities.links, shelved.entities.joints}, joints);
  }
  return inOrder(std::move(joints));
}

std::optional<std::string> restoreJoints(Access& access, const std::vector<SavedJoint>& wanted) {
  const std::vector<SavedJoint> present = listJoints(access);
  if (std::ranges::equal(present, wanted, isSame)) return std::nullopt;
  if (!canBecome(present, wanted)) {
    const world::Entities start(access.entities.description());
    if (!hasModelsOfTheStart(access.entities, start) || !canBecome(jointsOf(start), wanted)) {
      return "the saved state has joints that can't be made again here";
    }
    Editor(access).reset();
  }
  const auto isWanted = [&](const SavedJoint& joint) {
    return !joint.isMade && std::ranges::any_of(wanted, [&](const SavedJoint& each) { return isSame(each, joint); });
  };
  const std::vector<SavedJoint> before = listJoints(access);
  for (world::Slot slot = before.size(); slot-- > 0;) {
    if (!isWanted(before[slot])) Editor(access).detach(slot);
  }
  for (const SavedJoint& joint : wanted) {
    if (!joint.isMade) continue;
    auto made = std::make_shared<description::Joint>();
    made->name = joint.name;
    made->type = description::JointType::kFixed;
    made->parent = joint.parent;
    made->child = joint.child;
    made->X_ParentJoint = joint.X_ParentJoint;
    Editor(access).insertJoint(std::move(made), joint.id);
  }
  return std::nullopt;
}

}  // namespace pongsim::sim
