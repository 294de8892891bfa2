#include "sim/state/saved_state.hh"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/hash.hh"
#include "sim/state/saved_groups.hh"
#include "sim/state/saved_joints.hh"

namespace pongsim::sim {

namespace {

constexpr std::string_view kMark = "pongsim4";

void add(base::Hash& hash, const Pose& pose) {
  for (const double value : pose.position) hash.add(value);
  for (const double value : pose.rotation.coeffs()) hash.add(value);
}

/// @return Pointers to records that are there or set aside, in the order of their ids.
template <class Record>
std::vector<const Record*> allOf(const Access& access, const std::vector<Record>& there,
                                 std::vector<Record> world::Records::*member) {
  std::vector<const Record*> all;
  for (const Record& record : there) all.push_back(&record);
  for (const Shelved& shelved : access.shelf) {
    for (const Record& record : shelved.entities.*member) all.push_back(&record);
  }
  std::ranges::sort(all, {}, [](const Record* record) { return record->id; });
  return all;
}

/// @return A number made of who is in the world and how it began, but for joints: a state fits where it is the same.
std::uint64_t structureOf(const Access& access, const SystemSet& systems) {
  base::Hash hash;
  hash.add(access.entities.description().name);
  for (const world::ModelRecord* model : allOf(access, access.entities.models(), &world::Records::models)) {
    hash.add(model->scopedName);
    hash.add(std::uint64_t{model->isStatic});
  }
  for (const world::LinkRecord* link : allOf(access, access.entities.links(), &world::Records::links)) {
    hash.add(link->description->name);
    hash.add(link->description->inertial.mass);
    hash.add(std::uint64_t{link->description->collisions.size()});
    add(hash, link->X_WorldLinkStart);
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

void transferShelf(StateArchive& archive, Access& access) {
  std::vector<LinkId> links;
  for (const world::LinkRecord* link : allOf(access, access.entities.links(), &world::Records::links)) {
    links.push_back(link->id);
  }
  for (Shelved& shelved : access.shelf) {
    world::transfer(archive, shelved.state);
    shelved.bodies.transfer(archive, links);
    for (world::ModelRecord& model : shelved.entities.models) {
      if (model.canonicalLink == world::kNoSlot) archive(model.X_CanonicalModel);
    }
  }
}

void transfer(StateArchive& archive, Access& access) {
  access.levels.transfer(archive, access);
  world::transfer(archive, access.state);
  access.engine.transfer(archive);
  if (archive.isGiving()) access.engine.setGravity(access.state.gravity);
  for (world::Slot slot = 0; slot < access.entities.models().size(); ++slot) {
    const world::ModelRecord& model = access.entities.models()[slot];
    if (model.canonicalLink != world::kNoSlot) continue;
    Pose pose = model.X_CanonicalModel;
    archive(pose);
    access.entities.setPose(slot, pose);
  }
  transferShelf(archive, access);
}

/// Who is there in a saved state, and what the systems remember.
struct SavedWho {
  std::vector<SavedGroup> groups;
  std::vector<SavedJoint> joints;
  std::vector<std::string> systems;

  void transfer(StateArchive& archive) {
    archive(groups);
    archive(joints);
    archive(systems);
  }
};

/// Lets those be set aside that are in the saved state.
/// @return Why that can't be, and nothing is changed then.
std::optional<std::string> restoreWho(const SavedWho& who, Access& access, SystemSet& systems) {
  const std::vector<SavedGroup> before = listGroups(access);
  bringAllBack(access);
  if (auto error = restoreJoints(access, who.joints)) {
    setAside(before, access);
    return error;
  }
  if (!who.groups.empty()) {
    // what is set aside is not made anew with the others
    access.engine.reset();
    // nor can its systems look for anything then
    systems.restore(who.systems, false);
  }
  setAside(who.groups, access);
  if (who.groups == before) return std::nullopt;
  // who holds sensors that have come or gone must know it before those are restored
  systems.updateWhoRests();
  systems.announceChanges();
  return std::nullopt;
}

}  // namespace

std::vector<std::byte> saveState(Access& access, SystemSet& systems) {
  StateArchive content;
  SavedWho who{listGroups(access), listJoints(access), {}};
  who.systems = systems.save();
  content(who);
  transfer(content, access);
  const std::vector<std::byte> rest = content.take();

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

std::optional<std::string> restoreState(std::span<const std::byte> bytes, Access& access, SystemSet& systems) {
  constexpr std::size_t kHeader = kMark.size() + 2 * sizeof(std::uint64_t);
  std::array<char, kMark.size()> mark{};
  std::uint64_t structure = 0;
  std::uint64_t checksum = 0;
  if (bytes.size() < kHeader) return "this is not a saved state";
  StateArchive header(bytes);
  for (char& letter : mark) header(letter);
  header(structure);
  header(checksum);
  if (!std::ranges::equal(mark, kMark)) return "the saved state is from another version of pongsim";
  if (checksum != checksumOf(header.rest())) return "the saved state is damaged";
  if (structure != structureOf(access, systems)) {
    return "the saved state is of another world, or of other models, joints or systems";
  }
  StateArchive content(header.rest());
  SavedWho who;
  content(who);
  if (const auto error = restoreWho(who, access, systems)) return error;
  transfer(content, access);
  systems.restore(who.systems, true);
  return std::nullopt;
}

}  // namespace pongsim::sim
