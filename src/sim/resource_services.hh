#pragma once

#include <filesystem>
#include <functional>

#include "pongsim/node.hh"
#include "pongsim/simulation.hh"

namespace pongsim::sim {

/// Tells others where a run looks for the files that inserted models name, and lets them add folders:
/// `/gazebo/resource_paths/get`, `add` and `resolve`, and the topic `/gazebo/resource_paths`, which has all of them
/// when one is added.
class ResourceServices {
 public:
  using FolderAdded = std::function<void(const std::filesystem::path& folder)>;

  /// @param simulation Must outlive it.
  /// @param folderAdded Told of each folder that others add.
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
