#include "sim/saved_state.hh"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "base/hash.hh"
#include "sim/saved_joints.hh"

namespace pongsim::sim {

namespace {

constexpr std::string_view kMark = "pongsim3";

void add(base::Hash& hash, const Pose& pose) {
  for (const double value : pose.position) hash.add(value);
  for (const double value : pose.rotation.coeffs()) hash.add(value);
}

/// @return A number made of who is in the world and how it began, but for joints: a state fits where it is the same.
std::uint64_t structureOf(const Access& access, const SystemSet* systems) {
  base::Hash hash;
  const world::Entities& entities = access.entities;
  for (const world::ModelRecord& model : entities.models()) {
    hash.add(model.scopedName);
    hash.add(std::uint64_t{model.isStatic});
  }
  for (const world::LinkRecord& link : entities.links()) {
    hash.add(link.description->name);
    hash.add(link.description->inertial.mass);
    hash.add(std::uint64_t{link.description->collisions.size()});
    add(hash, link.X_WorldLinkStart);
  }
  if (systems != nullptr) systems->addTo(hash);
  return hash.value();
}

std::uint64_t checksumOf(std::span<const std::byte> bytes) {
  base::Hash hash;
  hash.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  return hash.value();
}

void transfer(StateArchive& archive, Access& access, SystemSet* systems) {
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
  if (systems != nullptr) systems->transfer(archive);
}

}  // namespace

std::vector<std::byte> saveState(Access& access, SystemSet* systems) {
  StateArchive content;
  std::vector<SavedJoint> joints = listJoints(access);
  content(joints);
  transfer(content, access, systems);
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

std::optional<std::string> restoreState(std::span<const std::byte> bytes, Access& access, SystemSet* systems) {
  constexpr std::size_t kHeader = kMark.size() + 2 * sizeof(std::uint64_t);
  std::array<char, kMark.size()> mark{};
  std::uint64_t structure = 0;
  std::uint64_t checksum = 0;
  if (bytes.size() < kHeader) return "that is no saved state";
  StateArchive header(bytes);
  for (char& letter : mark) header(letter);
  header(structure);
  header(checksum);
  if (!std::ranges::equal(mark, kMark)) return "that is no saved state of this version of pongsim";
  if (checksum != checksumOf(header.rest())) return "the saved state is damaged";
  if (structure != structureOf(access, systems)) {
    return "the saved state is one of another world, or other models, joints or systems were there";
  }
  StateArchive content(header.rest());
  std::vector<SavedJoint> joints;
  content(joints);
  if (const auto error = restoreJoints(access, joints)) return error;
  transfer(content, access, systems);
  return std::nullopt;
}

}  // namespace pongsim::sim
