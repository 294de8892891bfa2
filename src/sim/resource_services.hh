#pragma once

#include <filesystem>
#include <functional>

#include "pongsim/node.hh"
#include "pongsim/simulation.hh"

namespace pongsim::sim {

/// Services for the folders in which a run searches files of inserted models: `/gazebo/resource_paths/get`, `add` and
/// `resolve`, and the topic `/gazebo/resource_paths`, which publishes all folders when one is added.
class ResourceServices {
 public:
  using FolderAdded = std::function<void(const std::filesystem::path& folder)>;

  /// @param simulation Must outlive this.
  /// @param folderAdded Called with each folder added by a request.
  ResourceServices(Simulation& simulation, FolderAdded folderAdded);

 private:
  ServiceAnswer add(const Message& request);
  ServiceAnswer resolve(const Message& request, Message& reply);
  void fillIn(Message& stringMsgV) const;

  Simulation& simulation_;
  FolderAdded folderAdded_;
  Publisher publisher_;
  Service get_;
  Service add_;
  Service resolve_;
};

}  // namespace pongsim::sim
