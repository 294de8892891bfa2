#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>

#include <ignition/transport/RepHandler.hh>

#include "pongsim/node.hh"

namespace pongsim::ign {

/// Handles ign-transport requests to a service of the world, whatever its types. The library calls it on its thread,
/// which then waits for the simulation's answer, as Fortress's threads do.
class OfferedService final : public ignition::transport::IRepHandler {
 public:
  /// @param simulation A copy of it is used on the library's thread.
  OfferedService(const Node& simulation, OwnService service);

  const OwnService& service() const { return service_; }

  /// Releases the waiting requests: the simulation will not answer any more. Returns when none is left. For the
  /// simulation's thread.
  void end();

  bool RunLocalCallback(const ignition::transport::ProtoMsg& request, ignition::transport::ProtoMsg& reply) override;
  bool RunCallback(const std::string& request, std::string& reply) override;
  std::string ReqTypeName() const override { return service_.requestType; }
  std::string RepTypeName() const override { return service_.replyType; }

 private:
  bool ask(const Message& request, std::string& reply);

  Node simulation_;
  const OwnService service_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool hasEnded_ = false;
  int asking_ = 0;
};

}  // namespace pongsim::ign
