#pragma once

#include <memory>
#include <string>
#include <vector>

#include "web/gz/settings.hh"
#include "web/server/session.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::gz {

/// The protocol of ign-launch's WebSocket server, for clients that name no subprotocol: the library gzweb, and Gazebo's
/// web viewer.
class GzProtocol final : public Protocol {
 public:
  /// @param assets Must outlive it.
  GzProtocol(std::shared_ptr<Worlds> worlds, const AssetSource& assets, GzSettings settings = {});
  ~GzProtocol() override;

  std::vector<std::string> names() const override { return {""}; }
  std::unique_ptr<Session> open(const std::string& name, const std::shared_ptr<Client>& client) override;

 private:
  const std::shared_ptr<Worlds> worlds_;
  const AssetSource& assets_;
  const GzSettings settings_;
  /// Counts the current sessions.
  std::shared_ptr<int> sessions_ = std::make_shared<int>(0);
};

}  // namespace pongsim::web::gz
