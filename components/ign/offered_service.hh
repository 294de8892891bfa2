#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>

#include <ignition/transport/RepHandler.hh>

#include "ign/names.hh"
#include "pongsim/node.hh"

namespace pongsim::ign {

/// Handles ign-transport requests to a service of the world, whatever its types. The library calls it on a thread of
/// its own, which waits for the simulation's answer, as in Fortress.
class OfferedService final : public ignition::transport::IRepHandler {
 public:
  /// @param simulation Copied, for use on the library's thread.
  OfferedService(const Node& simulation, OwnService service, Generation generation);

  const OwnService& service() const { return service_; }

  /// Ends the waits for answers, which will not come any more, and returns when no thread waits. For the simulation's
  /// thread.
  void end();

  bool RunLocalCallback(const ignition::transport::ProtoMsg& request, ignition::transport::ProtoMsg& reply) override;
  bool RunCallback(const std::string& request, std::string& reply) override;
  std::string ReqTypeName() const override { return wireType(service_.requestType, generation_); }
  std::string RepTypeName() const override { return wireType(service_.replyType, generation_); }

 private:
  bool ask(const Message& request, std::string& reply);

  Node simulation_;
  const OwnService service_;
  const Generation generation_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool hasEnded_ = false;
  int asking_ = 0;
};

}  // namespace pongsim::ign
