#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "msgs/edit_messages.hh"
#include "pongsim/handles.hh"
#include "pongsim/node.hh"
#include "pongsim/simulation.hh"

namespace pongsim::sim {

/// Lets others change a world that runs: `create`, `create_multiple`, `remove`, `set_pose`, `set_pose_vector`,
/// `set_spherical_coordinates`, `light_config`, `set_physics` and `wheel_slip` under `/world/W`. Requests are met from within
/// `Transport::dispatch`, which must be in between two steps, and answered when they have taken effect, or with the
/// reason why they have not. `light_config` is a topic, too, and so is `wheel_slip`, which the systems hear that let
/// wheels slip.
class EditServices {
 public:
  /// @param simulation Must outlive it.
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
  ServiceAnswer setPhysics(const Message& request);
  ServiceAnswer setWheelSlip(const Message& request);

  /// What came with one request, to be taken back if the rest of it can't be.
  struct Inserted {
    std::vector<Model> models;
    std::vector<std::string> lights;
  };
  /// @return Why not, or nothing.
  std::optional<std::string> insert(const msgs::EntityFactory& asked, Inserted& inserted);
  std::optional<std::string> insertModel(const msgs::EntityFactory& asked, const InsertOptions& options,
                                         Inserted& inserted);
  std::optional<std::string> insertLight(const msgs::EntityFactory& asked, const InsertOptions& options,
                                         Inserted& inserted);
  /// @return Where that is in the world, or nothing and `refusal`.
  std::optional<Vector3> positionOf(const msgs::PlaceOnEarth& place, std::string& refusal);
  /// @return Where it is to stand, or nothing, which with `refusal` means that it can't.
  std::optional<Pose> poseFor(const msgs::EntityFactory& asked, std::string& refusal);
  ServiceAnswer setPerformer(const Message& request);
  /// @return The model at the top level, or nothing and `error`.
  std::optional<Model> find(const msgs::EntityName& asked, std::string& error);
  /// @return The link or the model of any level, or nothing and `error`.
  std::optional<msgs::EntityName> findLinkOrModel(const msgs::EntityName& asked, std::string& error);

  Simulation& simulation_;
  std::vector<Service> services_;
  Subscription lights_;
  Publisher wheelSlips_;
};

}  // namespace pongsim::sim
