#include "ign/outgoing_topic.hh"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "ign/library.hh"
#include "ign/names.hh"

namespace pongsim::ign {

OutgoingTopic::OutgoingTopic(std::string topic, std::string messageType)
    : name(std::move(topic)), type(std::move(messageType)), wireName_(wireName(name).value_or("")) {}

bool OutgoingTopic::advertise() {
  publisher_ = node_.Advertise(name, type);
  return publisher_.Valid();
}

void OutgoingTopic::unadvertise() {
  publisher_ = {};
  isHeard = false;
}

bool OutgoingTopic::look(const Heartbeats& heartbeats) {
  const bool isHeardNow = publisher_.Valid() && hasListeners(heartbeats);
  return isHeard.exchange(isHeardNow) != isHeardNow;
}

/// Unlike `Publisher::HasConnections`, ignores subscribers in this process, and those of processes that have ended.
bool OutgoingTopic::hasListeners(const Heartbeats& heartbeats) const {
  auto& shared = library();
  const std::lock_guard lock(shared.mutex);
  if (!shared.remoteSubscribers.HasTopic(wireName_, type)) return false;
  std::map<std::string, std::vector<ignition::transport::MessagePublisher>> byProcess;
  shared.remoteSubscribers.Publishers(wireName_, byProcess);
  return std::ranges::any_of(byProcess, [&](const auto& process) {
    const auto takes = [this](const auto& listener) {
      return listener.MsgTypeName() == type || listener.MsgTypeName() == ignition::transport::kGenericMessageType;
    };
    return heartbeats.isAlive(process.first) && std::ranges::any_of(process.second, takes);
  });
}

void OutgoingTopic::send(Payload payload) {
  const std::size_t size = payload.size();
  library().Publish(wireName_, payload.release(), size, &Payload::free, type);
}

}  // namespace pongsim::ign
