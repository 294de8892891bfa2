#pragma once

#include <string>
#include <vector>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/simulation_interfaces.hh"

/// What differs in simulation_interfaces 1, which Humble (1.4), Jazzy (1.5) and Kilted (1.6) ship. The names of the
/// types are those of version 2; their hashes differ.
namespace pongsim::ros2::simulation_interfaces_1 {

struct Spawnable {
  static constexpr const char* kName = "simulation_interfaces/msg/Spawnable";
  std::string uri;
  std::string description;
  simulation_interfaces::Bounds spawn_bounds;
  static void visit(auto& self, auto&& field) {
    field("uri", self.uri);
    field("description", self.description);
    field("spawn_bounds", self.spawn_bounds);
  }
  bool operator==(const Spawnable&) const = default;
};

struct GetSpawnablesResponse {
  static constexpr const char* kName = "simulation_interfaces/srv/GetSpawnables_Response";
  simulation_interfaces::Result result;
  std::vector<Spawnable> spawnables;
  static void visit(auto& self, auto&& field) {
    field("result", self.result);
    field("spawnables", self.spawnables);
  }
  bool operator==(const GetSpawnablesResponse&) const = default;
};

struct SetEntityStateRequest {
  static constexpr const char* kName = "simulation_interfaces/srv/SetEntityState_Request";
  std::string entity;
  simulation_interfaces::EntityState state;
  static void visit(auto& self, auto&& field) {
    field("entity", self.entity);
    field("state", self.state);
  }
  bool operator==(const SetEntityStateRequest&) const = default;
};

struct SpawnEntityRequest {
  static constexpr const char* kName = "simulation_interfaces/srv/SpawnEntity_Request";
  std::string name;
  bool allow_renaming = false;
  std::string uri;
  std::string resource_string;
  std::string entity_namespace;
  geometry_msgs::PoseStamped initial_pose;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("allow_renaming", self.allow_renaming);
    field("uri", self.uri);
    field("resource_string", self.resource_string);
    field("entity_namespace", self.entity_namespace);
    field("initial_pose", self.initial_pose);
  }
  bool operator==(const SpawnEntityRequest&) const = default;
};

}  // namespace pongsim::ros2::simulation_interfaces_1
