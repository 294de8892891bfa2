#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "web/server/session.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// Who publishes, listens and serves in the worlds, as one client is told while it wants to be. For the server's
/// thread.
class Graph {
 public:
  Graph(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds);

  /// Begins or ends to tell; begins with all that there is.
  void setWanted(bool wanted);
  /// Tells what has changed.
  void follow();

 private:
  /// By the name of a topic or service: who is there, as "WORLD/1", "WORLD/2".
  using Ends = std::map<std::string, std::vector<std::string>>;

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  bool isWanted_ = false;
  bool hasTold_ = false;
  Ends publishers_;
  Ends subscribers_;
  Ends providers_;
};

}  // namespace pongsim::web::foxglove
