#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "web/gz/protocol.hh"
#include "web/rosbridge/ros_topics.hh"
#include "web/server/session.hh"
#include "web/world/worlds.hh"

namespace pongsim::web {

/// The protocol of clients that name no subprotocol: that of Gazebo's server, or that of rosbridge, as their first
/// message shows.
class PlainProtocol final : public Protocol {
 public:
  /// @param gz Must outlive it, as must the log.
  PlainProtocol(std::shared_ptr<Worlds> worlds, gz::GzProtocol& gz, RecentLog& log)
      : worlds_(std::move(worlds)), gz_(gz), rosTopics_(worlds_, log) {}

  std::vector<std::string> names() const override { return {""}; }
  std::unique_ptr<Session> open(const std::string& name, const std::shared_ptr<Client>& client) override;

 private:
  const std::shared_ptr<Worlds> worlds_;
  gz::GzProtocol& gz_;
  rosbridge::RosTopics rosTopics_;
};

}  // namespace pongsim::web
