#include "ros2/node/node.hh"

#include <algorithm>
#include <stdexcept>

#include "ros2/node/names.hh"
#include "ros2/types/rmw_dds_common.hh"

namespace pongsim::ros2 {

namespace {

using rmw_dds_common::kHumbleGid;
using rmw_dds_common::kJazzyGid;

Contract contractOf(RosNode& node, const std::string& topic, const TypeInfo& type, const Qos& qos) {
  const std::string name = node.resolve(topic);
  if (const auto error = rosNameError(name)) throw std::invalid_argument("topic '" + name + "' " + *error);
  node.use(type);
  return {topicOnWire(name), ddsTypeName(type.name), type.hash, qos};
}

/// @param isToHumble For the readers that announce no hash, and without one itself, from which readers see its layout.
std::unique_ptr<Writer> discoveryWriter(Participant& participant, bool isToHumble) {
  const TypeInfo type = typeInfo<rmw_dds_common::ParticipantEntitiesInfo<kJazzyGid>>();
  const Contract contract{kDiscoveryTopic, ddsTypeName(type.name), isToHumble ? "" : type.hash, kLatchedQos};
  return participant.makeWriter(contract, {}, [&participant, isToHumble](const Guid& reader, const SampleId&) {
    const auto found = participant.graph().find(reader);
    return found && found->contract.typeHash.empty() == isToHumble;
  });
}

template <std::size_t GidSize>
rmw_dds_common::Gid<GidSize> gidOf(const Guid& guid) {
  rmw_dds_common::Gid<GidSize> gid;
  std::ranges::copy(guid.bytes, gid.data.begin());
  return gid;
}

}  // namespace

RosPublisher::RosPublisher(RosNode& node, const std::string& topic, const TypeInfo& type, const Qos& qos,
                           std::function<void()> readersChanged)
    : node_(node),
      writer_(node.participant().makeWriter(contractOf(node, topic, type, qos), std::move(readersChanged))) {
  node_.addWriter(writer_->id());
}

RosPublisher::~RosPublisher() { node_.removeWriter(writer_->id()); }

RosSubscription::RosSubscription(RosNode& node, const std::string& topic, const TypeInfo& type, const Qos& qos,
                                 Reader::Received received)
    : node_(node), reader_(node.participant().makeReader(contractOf(node, topic, type, qos), std::move(received))) {
  node_.addReader(reader_->id());
}

RosSubscription::~RosSubscription() { node_.removeReader(reader_->id()); }

RosNode::RosNode(Participant& participant, const Options& options) : participant_(participant), options_(options) {
  if (const auto error = rosNameError(fullName())) throw std::invalid_argument("node '" + fullName() + "' " + *error);
  discoveryToHumble_ = discoveryWriter(participant, true);
  discovery_ = discoveryWriter(participant, false);
  announce();
}

RosNode::~RosNode() = default;

std::string RosNode::resolve(std::string_view name) const {
  if (name.starts_with("~/")) return fullName() + std::string(name.substr(1));
  return absoluteName(options_.nameSpace, name);
}

void RosNode::complainOf(std::string_view topic, std::string_view error) {
  ++malformed_;
  complaints_.warn(log_, "a message on '" + resolve(topic) + "' is damaged: " + std::string(error) + "; dropped");
}

void RosNode::use(const TypeInfo& type) {
  const std::lock_guard lock(mutex_);
  types_.try_emplace(type.name, type);
}

std::optional<TypeInfo> RosNode::usedType(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = types_.find(name);
  return found == types_.end() ? std::nullopt : std::optional(found->second);
}

void RosNode::addWriter(const Guid& id) {
  const std::lock_guard lock(mutex_);
  writers_.push_back(id);
  announce();
}
void RosNode::removeWriter(const Guid& id) {
  const std::lock_guard lock(mutex_);
  std::erase(writers_, id);
  announce();
}
void RosNode::addReader(const Guid& id) {
  const std::lock_guard lock(mutex_);
  readers_.push_back(id);
  announce();
}
void RosNode::removeReader(const Guid& id) {
  const std::lock_guard lock(mutex_);
  std::erase(readers_, id);
  announce();
}

RosNode::Quiet::Quiet(RosNode& node) : node_(node) {
  const std::lock_guard lock(node_.mutex_);
  ++node_.quiet_;
}

RosNode::Quiet::~Quiet() {
  const std::lock_guard lock(node_.mutex_);
  --node_.quiet_;
  node_.announce();
}

template <std::size_t GidSize>
void RosNode::announceBy(Writer& writer) {
  rmw_dds_common::ParticipantEntitiesInfo<GidSize> info;
  info.gid = gidOf<GidSize>(participant_.id());
  auto& node = info.node_entities_info_seq.emplace_back();
  node.node_namespace = options_.nameSpace;
  node.node_name = options_.name;
  for (const Guid& id : readers_) node.reader_gid_seq.push_back(gidOf<GidSize>(id));
  for (const Guid& id : writers_) node.writer_gid_seq.push_back(gidOf<GidSize>(id));
  writer.write(cdrSize(info), [&info](std::span<std::byte> place) { writeCdr(info, place); });
}

void RosNode::announce() {
  if (quiet_ > 0) return;
  announceBy<kHumbleGid>(*discoveryToHumble_);
  announceBy<kJazzyGid>(*discovery_);
}

}  // namespace pongsim::ros2
