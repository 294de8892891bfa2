#pragma once

#include "pongsim/node.hh"
#include "pongsim/simulation.hh"

namespace pongsim::sim {

/// Tells others where a run looks for the files that inserted models name, and lets them add folders:
/// `/gazebo/resource_paths/get`, `add` and `resolve`, and the topic `/gazebo/resource_paths`, which has all of them
/// when one is added.
class ResourceServices {
 public:
  /// @param simulation Must outlive it.
  explicit ResourceServices(Simulation& simulation);

 private:
  ServiceAnswer add(const Message& request);
  ServiceAnswer resolve(const Message& request, Message& reply);
  void fillIn(Message& stringMsgV) const;

  Simulation& simulation_;
  Publisher publisher_;
  Service get_;
  Service add_;
  Service resolve_;
};

}  // namespace pongsim::sim
