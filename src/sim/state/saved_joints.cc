#include "sim/state/saved_joints.hh"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include "base/hash.hh"
#include "description/joint.hh"
#include "description/limits.hh"
#include "sim/edits/editor.hh"

namespace pongsim::sim {

namespace {

void addPose(base::Hash& hash, const Pose& pose) {
  for (const double value : pose.position) hash.add(value);
  for (const double value : pose.rotation.coeffs()) hash.add(value);
}

std::string linkName(const world::Entities& entities, world::Slot link) {
  if (link == world::kNoSlot) return {};
  return entities.models()[entities.links()[link].model].scopedName + "::" + entities.links()[link].description->name;
}

SavedJoint savedJoint(const world::Entities& entities, const world::JointRecord& joint) {
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
  hash.add(joint.model == world::kNoSlot ? std::string() : entities.models()[joint.model].scopedName);
  hash.add(description.name);
  hash.add(static_cast<std::uint64_t>(description.type));
  for (const world::Slot link : {joint.parentLink, joint.childLink, joint.referenceLink}) {
    hash.add(linkName(entities, link));
  }
  addPose(hash, description.X_ParentJoint);
  hash.add(saved.id.value);
  saved.key = hash.value();
  return saved;
}

std::vector<SavedJoint> jointsOf(const world::Entities& entities) {
  std::vector<SavedJoint> joints;
  for (const world::JointRecord& joint : entities.joints()) joints.push_back(savedJoint(entities, joint));
  return joints;
}

bool isSame(const SavedJoint& a, const SavedJoint& b) { return a.key == b.key; }

/// @return Whether `wanted` consists of some of the file's joints in `present`, in their order, followed by joints made
/// at run time.
bool canBecome(const std::vector<SavedJoint>& present, const std::vector<SavedJoint>& wanted) {
  auto next = wanted.begin();
  for (const SavedJoint& joint : present) {
    if (next != wanted.end() && !next->isMade && !joint.isMade && isSame(joint, *next)) ++next;
  }
  return std::all_of(next, wanted.end(), [](const SavedJoint& joint) { return joint.isMade; });
}

/// @param next The first id after those of the file.
/// @return Whether the joints made at run time have ascending, unique ids from `next` on.
bool followTheFile(const std::vector<SavedJoint>& wanted, std::uint64_t next) {
  constexpr std::uint64_t kLargestId = std::uint64_t{1} << 30U;
  for (const SavedJoint& joint : wanted) {
    if (!joint.isMade) continue;
    if (joint.id.value < next || joint.id.value > kLargestId) return false;
    next = joint.id.value + 1;
  }
  return true;
}

/// @return Whether the ids of the joints to be made are not in use, and larger than those of all joints that stay. Both
/// may fail if models were inserted in another order than in the saved run.
bool haveFreeIds(const std::vector<SavedJoint>& wanted, const world::Entities& entities) {
  const auto isTaken = [&](const SavedJoint& joint) {
    const std::uint64_t id = joint.id.value;
    return std::ranges::any_of(
               entities.models(),
               [id](const world::ModelRecord& model) { return model.id.value <= id && id <= model.lastId; }) ||
           std::ranges::any_of(entities.lights(),
                               [id](const world::LightRecord& light) { return light.id.value == id; }) ||
           std::ranges::any_of(entities.joints(), [id](const world::JointRecord& other) {
             return other.owner == nullptr && other.id.value >= id;
           });
  };
  return std::ranges::none_of(wanted, [&](const SavedJoint& joint) { return joint.isMade && isTaken(joint); });
}

/// @return Whether each joint to be made connects two existing links, or an existing link and the world.
bool haveLinks(const std::vector<SavedJoint>& wanted, const world::Entities& entities) {
  const auto linkOf = [&](const std::string& name) { return entities.findLink(world::kNoSlot, name); };
  const auto isThere = [&](const std::string& name) { return name == "world" || linkOf(name) != world::kNoSlot; };
  return std::ranges::all_of(wanted, [&](const SavedJoint& joint) {
    if (!joint.isMade) return true;
    return isThere(joint.parent) && isThere(joint.child) && linkOf(joint.parent) != linkOf(joint.child);
  });
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
  archive.check(X_ParentJoint.position.cwiseAbs().maxCoeff() <= description::kFarthestSaved);
}

std::vector<SavedJoint> listJoints(const Access& access) { return jointsOf(access.entities); }

Outcome<void> restoreJoints(Access& access, const std::vector<SavedJoint>& wanted) {
  const std::vector<SavedJoint> present = listJoints(access);
  if (std::ranges::equal(present, wanted, isSame)) return {};
  const std::string refusal = "the saved state has joints that can't be recreated here";
  world::Entities start(access.entities.description());
  if (!followTheFile(wanted, start.nextId()) || !haveLinks(wanted, access.entities)) return {refusal};
  if (!canBecome(present, wanted)) {
    if (!hasModelsOfTheStart(access.entities, start) || !canBecome(jointsOf(start), wanted)) {
      return {refusal};
    }
    Editor(access).reset();
  } else if (!haveFreeIds(wanted, access.entities)) {
    return {refusal};
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
  return {};
}

}  // namespace pongsim::sim
