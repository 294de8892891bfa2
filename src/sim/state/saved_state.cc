#include "sim/state/saved_state.hh"

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/hash.hh"
#include "description/limits.hh"
#include "description/particle_emitter.hh"
#include "msgs/scene/emitter_message.hh"
#include "sim/edits/editor.hh"
#include "sim/edits/size_edits.hh"
#include "sim/state/saved_joints.hh"

namespace pongsim::sim {

namespace {

constexpr std::string_view kMark = "pongsim8";

void add(base::Hash& hash, const Pose& pose) {
  for (const double value : pose.position) hash.add(value);
  for (const double value : pose.rotation.coeffs()) hash.add(value);
}

/// @return A hash of the world's entities, except joints, their initial poses, and its systems. A state can only be
/// restored into a world with the same hash.
std::uint64_t structureOf(const Access& access, const SystemSet& systems) {
  base::Hash hash;
  hash.add(access.entities.description().name);
  for (const world::ModelRecord& model : access.entities.models()) {
    hash.add(model.scopedName);
    hash.add(std::uint64_t{model.isStatic});
  }
  for (const world::LinkRecord& link : access.entities.links()) {
    hash.add(link.description->name);
    hash.add(link.description->inertial.mass);
    hash.add(std::uint64_t{link.description->collisions.size()});
    for (const description::ParticleEmitter& emitter : link.description->emitters) hash.add(emitter.name);
    add(hash, link.X_WorldLinkStart);
  }
  for (const auto& [level, isLoaded] : access.levels.list()) hash.add(level);
  systems.addTo(hash);
  return hash.value();
}

std::uint64_t checksumOf(std::span<const std::byte> bytes) {
  base::Hash hash;
  hash.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  return hash.value();
}

/// Settings and particles of the emitters.
void transferParticles(StateArchive& archive, world::Particles& particles) {
  for (world::Emitter& emitter : particles.emitters()) {
    archive(emitter.changes);
    if (!archive.isGiving()) continue;
    const auto now = msgs::emitterAfter(emitter.atStart, emitter.changes);
    archive.check(now && description::faultOf(*now).empty());
    emitter.now = *now;
  }
  particles.transfer(archive);
}

void transfer(StateArchive& archive, Access& access) {
  access.levels.transfer(archive);
  world::transfer(archive, access.state);
  transferSizes(archive, access);
  access.engine.transfer(archive);
  if (archive.isGiving()) access.engine.setGravity(access.state.gravity);
  transferParticles(archive, access.particlesNow());
  for (world::Slot slot = 0; slot < access.entities.models().size(); ++slot) {
    const world::ModelRecord& model = access.entities.models()[slot];
    if (model.canonicalLink != world::kNoSlot) continue;
    Pose pose = model.X_CanonicalModel;
    archive(pose);
    archive.check(pose.position.cwiseAbs().maxCoeff() <= description::kFarthestSaved);
    access.entities.setPose(slot, pose);
  }
}

/// Calls `use(name, record)` for each top-level model, light and actor. Names are preceded by the kind, because a model
/// and a light may have the same name.
template <class Use>
void forEachTopLevel(const world::Entities& entities, Use use) {
  for (const world::ModelRecord& model : entities.models()) {
    if (model.parent == world::kNoSlot) use("model " + model.scopedName, model);
  }
  for (const world::LightRecord& light : entities.lights()) {
    if (light.link == world::kNoSlot) use("light " + light.description->name, light);
  }
  for (const world::ActorRecord& actor : entities.actors()) use("actor " + actor.description->name, actor);
}

/// The entities set aside, the joints, and the states of the systems in a saved state.
struct SavedContent {
  /// Sorted names, because ids may differ in another run.
  std::vector<std::string> setAside;
  std::vector<SavedJoint> joints;
  std::vector<std::string> systems;

  void transfer(StateArchive& archive) {
    archive(setAside);
    archive(joints);
    archive(systems);
  }
};

/// @param ids Sorted ids of top-level entities.
/// @return Whether for each joint all connected models are among them, or none is.
bool keepTogether(const world::Entities& entities, const std::vector<std::uint64_t>& ids) {
  const auto isAmong = [&](world::Slot link) {
    const world::ModelRecord* model = &entities.models()[entities.links()[link].model];
    while (model->parent != world::kNoSlot) model = &entities.models()[model->parent];
    return std::ranges::binary_search(ids, model->id.value);
  };
  return std::ranges::all_of(entities.joints(), [&](const world::JointRecord& joint) {
    std::vector<bool> sides;
    for (const world::Slot link : {joint.parentLink, joint.childLink, joint.referenceLink}) {
      if (link != world::kNoSlot) sides.push_back(isAmong(link));
    }
    return std::ranges::adjacent_find(sides, std::ranges::not_equal_to()) == sides.end();
  });
}

/// Sets the same entities aside as in the saved state, and makes and removes joints.
/// @throws std::exception if the state is not of this world.
Outcome<void> restoreContent(const SavedContent& saved, Access& access, SystemSet& systems) {
  const std::vector<std::uint64_t> before = access.entities.listSetAside();
  Editor(access).setAside({});
  if (Outcome<void> restored = restoreJoints(access, saved.joints); !restored) return restored;
  // first, because systems of entities that are set aside can't look up entities afterwards
  if (!saved.setAside.empty()) systems.restore(saved.systems, false);
  std::vector<std::uint64_t> ids;
  forEachTopLevel(access.entities, [&](const std::string& name, const auto& record) {
    if (std::ranges::binary_search(saved.setAside, name)) ids.push_back(record.id.value);
  });
  std::ranges::sort(ids);
  const bool mayBe = ids.size() == saved.setAside.size() && (ids.empty() || access.levels.areUsed());
  if (!mayBe || !keepTogether(access.entities, ids)) return {"the saved state has unloaded levels that can't be here"};
  Editor(access).setAside(ids);
  if (ids == before) return {};
  // systems have to know which sensors exist before the states of these are restored
  systems.updateWhoRests();
  systems.announceChanges();
  return {};
}

/// @param bytes Content after the header. On a refusal, a part of it may have been restored.
Outcome<void> restoreAll(std::span<const std::byte> bytes, Access& access, SystemSet& systems) {
  try {
    StateArchive content(bytes);
    SavedContent saved;
    content(saved);
    if (Outcome<void> restored = restoreContent(saved, access, systems); !restored) return restored;
    transfer(content, access);
    // sizes of shapes
    systems.announceChanges();
    if (!content.rest().empty()) return {"the saved state is invalid: it is too long"};
    systems.restore(saved.systems, true);
    return {};
  } catch (const std::exception& error) {
    return {std::string("the saved state is invalid: ") + error.what()};
  }
}

/// @return Content after the header.
std::vector<std::byte> saveAll(Access& access, SystemSet& systems) {
  StateArchive content;
  SavedContent saved{{}, listJoints(access), systems.save()};
  forEachTopLevel(access.entities, [&](std::string name, const auto& record) {
    if (record.isSetAside) saved.setAside.push_back(std::move(name));
  });
  std::ranges::sort(saved.setAside);
  content(saved);
  transfer(content, access);
  return content.take();
}

}  // namespace

std::vector<std::byte> saveState(Access& access, SystemSet& systems) {
  const std::vector<std::byte> rest = saveAll(access, systems);
  StateArchive archive;
  for (char letter : kMark) archive(letter);
  std::uint64_t structure = structureOf(access, systems);
  std::uint64_t checksum = checksumOf(rest);
  archive(structure);
  archive(checksum);
  std::vector<std::byte> bytes = archive.take();
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  return bytes;
}

Outcome<void> restoreState(std::span<const std::byte> bytes, Access& access, SystemSet& systems) {
  constexpr std::size_t kHeader = kMark.size() + 2 * sizeof(std::uint64_t);
  std::array<char, kMark.size()> mark{};
  std::uint64_t structure = 0;
  std::uint64_t checksum = 0;
  if (bytes.size() < kHeader) return {"this is not a saved state"};
  StateArchive header(bytes);
  for (char& letter : mark) header(letter);
  header(structure);
  header(checksum);
  if (!std::ranges::equal(mark, kMark)) return {"the saved state is from another version of pongsim"};
  if (checksum != checksumOf(header.rest())) return {"the saved state is damaged"};
  if (structure != structureOf(access, systems)) {
    return {"the saved state is of another world, or of other models, joints or systems"};
  }
  // a correct checksum does not prove that the state is valid: keep the current state, to undo a partial restoration
  std::vector<std::byte> before;
  try {
    before = saveAll(access, systems);
  } catch (const std::exception& error) {
    return {std::string("the present state can't be saved, to be put back: ") + error.what()};
  }
  Outcome<void> restored = restoreAll(header.rest(), access, systems);
  if (restored) return {};
  const Outcome<void> undone = restoreAll(before, access, systems);
  if (!undone) restored.error += "; what has been restored of it stays, because " + undone.error;
  return restored;
}

}  // namespace pongsim::sim
