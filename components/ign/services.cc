#include "ign/services.hh"

#include <ignition/msgs/empty.pb.h>

#include <atomic>
#include <functional>
#include <mutex>

#include "ign/library.hh"
#include "ign/names.hh"
#include "pongsim/log.hh"

namespace pongsim::ign {

namespace {

/// @return The node's id. The library assigns services to nodes by it but does not expose it, so it is read from a
/// temporary service that is visible in this process only.
std::string uuidOf(ignition::transport::Node& node) {
  // atomic, because nodes of several worlds may be created at the same time
  static std::atomic<int> count = 0;
  const std::string name = "/pongsim/node" + std::to_string(++count);
  ignition::transport::AdvertiseServiceOptions options;
  options.SetScope(ignition::transport::Scope_t::PROCESS);
  const std::function<bool(const ignition::msgs::Empty&, ignition::msgs::Empty&)> nothing = [](const auto&, auto&) {
    return false;
  };
  if (!node.Advertise(name, nothing, options)) return {};
  std::string uuid;
  {
    const std::lock_guard lock(library().mutex);
    std::map<std::string, std::map<std::string, std::shared_ptr<ignition::transport::IRepHandler>>> handlers;
    library().repliers.Handlers(wireName(name).value_or(""), handlers);
    for (const auto& [number, each] : handlers) uuid = number;
  }
  node.UnadvertiseSrv(name);
  return uuid;
}

}  // namespace

Services::Services() : nodeUuid_(uuidOf(node_)) {}

// Like `Node::Advertise`, for types that are not known at compile time.
void Services::advertise(const std::shared_ptr<OfferedService>& service) {
  const std::string& plainName = service->service().name;
  const std::optional<std::string> name = wireName(plainName);
  auto& shared = library();
  if (name) {
    const std::lock_guard lock(shared.mutex);
    shared.repliers.AddHandler(*name, nodeUuid_, service);
    const ignition::transport::ServicePublisher publisher(
        *name, shared.myReplierAddress, shared.replierId.ToString(), shared.pUuid, nodeUuid_, service->ReqTypeName(),
        service->RepTypeName(), ignition::transport::AdvertiseServiceOptions());
    if (shared.AdvertisePublisher(publisher)) return;
  }
  static const Logger log("ign");
  log.warning("service '" + plainName + "' can't be offered by ign-transport");
}

void Services::unadvertise(const OfferedService& service) { node_.UnadvertiseSrv(service.service().name); }

}  // namespace pongsim::ign
