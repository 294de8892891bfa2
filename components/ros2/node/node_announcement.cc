#include "ros2/node/node_announcement.hh"

#include <algorithm>

#include "ros2/node/names.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/rmw_dds_common.hh"
#include "ros2/types/type_info.hh"

namespace pongsim::ros2 {

namespace {

using rmw_dds_common::kHumbleGid;
using rmw_dds_common::kJazzyGid;

/// @param isToHumble For the readers that announce no hash, and without one itself, from which readers see its layout.
std::unique_ptr<Writer> announcementWriter(Participant& participant, bool isToHumble) {
  const TypeInfo type = typeInfo<rmw_dds_common::ParticipantEntitiesInfo<kJazzyGid>>();
  const Contract contract{kDiscoveryTopic, ddsTypeName(type.name), isToHumble ? "" : type.hash, kLatchedQos};
  return participant.makeWriter(contract, {}, [&participant, isToHumble](const Guid& reader, const SampleId&) {
    const auto found = participant.graph().find(reader);
    return found && found->contract.typeHash.empty() == isToHumble;
  });
}

template <std::size_t GidSize>
rmw_dds_common::Gid<GidSize> announcedGid(const Guid& guid) {
  rmw_dds_common::Gid<GidSize> gid;
  std::ranges::copy(guid.bytes, gid.data.begin());
  return gid;
}

}  // namespace

NodeAnnouncement::NodeAnnouncement(Participant& participant)
    : participant_(participant),
      toHumble_(announcementWriter(participant, true)),
      toOthers_(announcementWriter(participant, false)) {}

void NodeAnnouncement::announce(const void* node, Entry entry) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(entries_, node, &std::pair<const void*, Entry>::first);
  if (found == entries_.end()) {
    entries_.emplace_back(node, std::move(entry));
  } else {
    found->second = std::move(entry);
  }
  write();
}

void NodeAnnouncement::remove(const void* node) {
  const std::lock_guard lock(mutex_);
  std::erase_if(entries_, [node](const auto& each) { return each.first == node; });
  if (!entries_.empty()) write();
}

template <std::size_t GidSize>
void NodeAnnouncement::writeBy(Writer& writer) const {
  rmw_dds_common::ParticipantEntitiesInfo<GidSize> info;
  info.gid = announcedGid<GidSize>(participant_.id());
  for (const auto& [key, entry] : entries_) {
    auto& node = info.node_entities_info_seq.emplace_back();
    node.node_namespace = entry.nameSpace;
    node.node_name = entry.name;
    for (const Guid& id : entry.readers) node.reader_gid_seq.push_back(announcedGid<GidSize>(id));
    for (const Guid& id : entry.writers) node.writer_gid_seq.push_back(announcedGid<GidSize>(id));
  }
  writer.write(cdrSize(info), [&info](std::span<std::byte> place) { writeCdr(info, place); });
}

void NodeAnnouncement::write() {
  writeBy<kHumbleGid>(*toHumble_);
  writeBy<kJazzyGid>(*toOthers_);
}

}  // namespace pongsim::ros2
