#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pongsim/node.hh"

namespace pongsim::sim {

/// What others may ask of a run whatever its worlds are: `/gazebo/worlds` and `/server_control`. Requests are met from
/// within the transport's `dispatch`.
class ServerServices {
 public:
  /// @param worlds Their names, in the order of the file.
  /// @param stop Ends the run. All references must outlive it.
  ServerServices(Transport& transport, std::vector<std::string> worlds, std::function<void()> stop);

 private:
  ServiceAnswer control(const Message& request) const;

  std::vector<std::string> names_;
  std::function<void()> stop_;
  Service worlds_;
  Service control_;
};

}  // namespace pongsim::sim
