#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pongsim/node.hh"

namespace pongsim::sim {

/// Services of a run as a whole: `/gazebo/worlds` and `/server_control`. Requests are handled within the transport's
/// `dispatch`.
class ServerServices {
 public:
  /// @param worlds Their names, in the order of the file.
  /// @param stop Ends the run. All references must outlive this.
  ServerServices(Transport& transport, std::vector<std::string> worlds, std::function<void()> stop);

 private:
  ServiceAnswer control(const Message& request) const;

  std::vector<std::string> names_;
  std::function<void()> stop_;
  Service worlds_;
  Service control_;
};

}  // namespace pongsim::sim
