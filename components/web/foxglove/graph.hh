#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "web/server/session.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// The publishers, subscribers and services of the worlds, reported to one client as long as it subscribes to them. For
/// the server's thread.
class Graph {
 public:
  Graph(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds);

  /// Starts or stops reporting; starts with the complete graph.
  void setWanted(bool wanted);
  /// Reports changes.
  void follow();

 private:
  /// Keyed by topic or service name: its endpoints, as "WORLD/1", "WORLD/2".
  using Ends = std::map<std::string, std::vector<std::string>>;

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  bool isWanted_ = false;
  bool hasSent_ = false;
  Ends publishers_;
  Ends subscribers_;
  Ends providers_;
};

}  // namespace pongsim::web::foxglove
