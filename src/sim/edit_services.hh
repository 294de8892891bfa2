#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "msgs/edit_messages.hh"
#include "pongsim/handles.hh"
#include "pongsim/node.hh"

namespace pongsim {
class Simulation;
}

namespace pongsim::sim {

/// Lets others change a world that runs: `create`, `create_multiple`, `remove`, `set_pose`, `set_pose_vector` and
/// `set_physics` under `/world/W`. Requests are met from within `Transport::dispatch`, which must be in between two
/// steps, and answered when they have taken effect, or with the reason why they have not.
class EditServices {
 public:
  /// @param simulation Must outlive it.
  explicit EditServices(Simulation& simulation);

 private:
  using Answer = ServiceAnswer (EditServices::*)(const Message& request);

  void serve(const char* name, const char* requestType, Answer answer);
  ServiceAnswer create(const Message& request);
  ServiceAnswer createMultiple(const Message& request);
  ServiceAnswer removeModel(const Message& request);
  ServiceAnswer setPose(const Message& request);
  ServiceAnswer setPoses(const Message& request);
  ServiceAnswer setPhysics(const Message& request);

  /// @return Why not, or nothing.
  std::optional<std::string> insert(const msgs::EntityFactory& asked, std::vector<Model>& inserted);
  /// @return The model at the top level, or nothing and `error`.
  std::optional<Model> find(const msgs::EntityName& asked, std::string& error);

  Simulation& simulation_;
  std::vector<Service> services_;
};

}  // namespace pongsim::sim
