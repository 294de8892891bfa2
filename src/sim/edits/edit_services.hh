#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "msgs/control/edit_messages.hh"
#include "pongsim/handles.hh"
#include "pongsim/node.hh"
#include "pongsim/simulation.hh"

namespace pongsim::sim {

/// Services that change a running world: `create`, `create_multiple`, `remove`, `set_pose`, `set_pose_vector`,
/// `set_spherical_coordinates`, `light_config`, `visual_config`, `set_mass`, `set_joint_position`, `set_physics` and
/// `wheel_slip` under `/world/W`. Requests are handled
/// within `Transport::dispatch`, which must be called between two steps. The response is sent when the change is done,
/// or has the reason of a refusal. `light_config` and `wheel_slip` are also topics; the latter is received by
/// wheel-slip systems.
class EditServices {
 public:
  /// @param simulation Must outlive this.
  explicit EditServices(Simulation& simulation);

 private:
  using Answer = ServiceAnswer (EditServices::*)(const Message& request);

  /// @return "/world/W/NAME"
  std::string nameOf(const char* name);
  void serve(const char* name, const char* requestType, Answer answer);
  ServiceAnswer create(const Message& request);
  ServiceAnswer createMultiple(const Message& request);
  ServiceAnswer remove(const Message& request);
  ServiceAnswer setPose(const Message& request);
  ServiceAnswer setPoses(const Message& request);
  ServiceAnswer setPlace(const Message& request);
  ServiceAnswer setLight(const Message& request);
  ServiceAnswer setVisual(const Message& request);
  ServiceAnswer setMass(const Message& request);
  ServiceAnswer setJointPosition(const Message& request);
  ServiceAnswer setPhysics(const Message& request);
  ServiceAnswer setWheelSlip(const Message& request);

  /// What a request has inserted so far, removed again if the rest of it fails.
  struct Inserted {
    std::vector<Model> models;
    std::vector<std::string> lights;
  };
  Outcome<void> insert(const msgs::EntityFactory& asked, Inserted& inserted);
  /// Inserts a model or light from text or a file.
  Outcome<void> insertModelOrLight(const msgs::EntityFactory& asked, const InsertOptions& options, Inserted& inserted);
  Outcome<void> insertCopy(const msgs::EntityFactory& asked, const InsertOptions& options, Inserted& inserted);
  Outcome<void> insertLight(const msgs::EntityFactory& asked, const InsertOptions& options, Inserted& inserted);
  /// @return The position in the world.
  Outcome<Vector3> positionOf(const msgs::PlaceOnEarth& place);
  ServiceAnswer setPerformer(const Message& request);
  /// @return The top-level model.
  Outcome<Model> find(const msgs::EntityName& asked);
  Outcome<Link> findLink(const msgs::EntityName& asked);
  Outcome<Joint> findJoint(const msgs::EntityName& asked);
  Outcome<VisualId> findVisual(const msgs::VisualLook& asked);
  /// @return The link or model at any level.
  Outcome<msgs::EntityName> findLinkOrModel(const msgs::EntityName& asked);

  Simulation& simulation_;
  std::vector<Service> services_;
  Subscription lights_;
  Publisher wheelSlips_;
};

}  // namespace pongsim::sim
