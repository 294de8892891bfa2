#include "ros2/node/node.hh"

#include <algorithm>
#include <stdexcept>

#include "ros2/node/names.hh"
#include "ros2/types/rmw_dds_common.hh"

namespace pongsim::ros2 {

namespace {

constexpr std::size_t kHumbleGid = 24, kJazzyGid = 16;

Contract contractOf(const RosNode& node, const std::string& topic, const TypeInfo& type, const Qos& qos) {
  const std::string name = node.resolve(topic);
  if (const auto error = rosNameError(name)) throw std::invalid_argument("topic '" + name + "' " + *error);
  return {topicOnWire(name), ddsTypeName(type.name), type.hash, qos};
}

template <std::size_t GidSize>
Contract discoveryContract() {
  const TypeInfo type = typeInfo<rmw_dds_common::ParticipantEntitiesInfo<GidSize>>();
  return {kDiscoveryTopic, ddsTypeName(type.name), type.hash, kLatchedQos};
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
  discovery_ = participant.makeWriter(participant.distro() == Distro::kHumble ? discoveryContract<kHumbleGid>()
                                                                              : discoveryContract<kJazzyGid>());
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
void RosNode::announceAs() {
  rmw_dds_common::ParticipantEntitiesInfo<GidSize> info;
  info.gid = gidOf<GidSize>(participant_.id());
  auto& node = info.node_entities_info_seq.emplace_back();
  node.node_namespace = options_.nameSpace;
  node.node_name = options_.name;
  for (const Guid& id : readers_) node.reader_gid_seq.push_back(gidOf<GidSize>(id));
  for (const Guid& id : writers_) node.writer_gid_seq.push_back(gidOf<GidSize>(id));
  discovery_->write(cdrSize(info), [&info](std::span<std::byte> place) { writeCdr(info, place); });
}

void RosNode::announce() {
  if (quiet_ > 0) return;
  participant_.distro() == Distro::kHumble ? announceAs<kHumbleGid>() : announceAs<kJazzyGid>();
}

}  // namespace pongsim::ros2
