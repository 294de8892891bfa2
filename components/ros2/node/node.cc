#include "ros2/node/node.hh"

#include <stdexcept>
#include <utility>

#include "ros2/node/names.hh"

namespace pongsim::ros2 {

namespace {

Contract contractOf(RosNode& node, const std::string& topic, const TypeInfo& type, const Qos& qos) {
  const std::string name = node.resolve(topic);
  if (const auto error = rosNameError(name)) throw std::invalid_argument("topic '" + name + "' " + *error);
  node.use(type);
  return {topicOnWire(name), ddsTypeName(type.name), type.hash, qos};
}

Writer::IsFor filterOf(const Participant& participant, const RosPublisher::IsForType& isForType) {
  if (!isForType) return {};
  return [&participant, isForType](const Guid& reader, const SampleId&) {
    const auto found = participant.graph().find(reader);
    return found && isForType(found->contract.typeHash);
  };
}

}  // namespace

RosPublisher::RosPublisher(RosNode& node, const std::string& topic, const TypeInfo& type, const Qos& qos,
                           std::function<void()> readersChanged, const IsForType& isForType)
    : node_(node),
      writer_(node.participant().makeWriter(contractOf(node, topic, type, qos), std::move(readersChanged),
                                            filterOf(node.participant(), isForType))) {
  node_.addWriter(writer_->id());
}

RosPublisher::~RosPublisher() { node_.removeWriter(writer_->id()); }

RosSubscription::RosSubscription(RosNode& node, const std::string& topic, const TypeInfo& type, const Qos& qos,
                                 Reader::Received received)
    : node_(node), reader_(node.participant().makeReader(contractOf(node, topic, type, qos), std::move(received))) {
  node_.addReader(reader_->id());
}

RosSubscription::~RosSubscription() { node_.removeReader(reader_->id()); }

RosNode::RosNode(Participant& participant, std::shared_ptr<NodeAnnouncement> announcement, const Options& options)
    : participant_(participant), announcement_(std::move(announcement)), options_(options) {
  if (const auto error = rosNameError(fullName())) throw std::invalid_argument("node '" + fullName() + "' " + *error);
  announce();
}

RosNode::RosNode(Participant& participant, const Options& options)
    : RosNode(participant, std::make_shared<NodeAnnouncement>(participant), options) {}

RosNode::RosNode(RosNode& beside, const Options& options)
    : RosNode(beside.participant_, beside.announcement_, options) {}

RosNode::~RosNode() { announcement_->remove(this); }

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

void RosNode::announce() {
  if (quiet_ > 0) return;
  announcement_->announce(this, {options_.nameSpace, options_.name, readers_, writers_});
}

}  // namespace pongsim::ros2
