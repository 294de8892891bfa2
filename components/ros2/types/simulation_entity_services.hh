#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/simulation_interfaces.hh"
#include "ros2/types/simulation_interfaces_1.hh"

/// The services about entities.
namespace pongsim::ros2::simulation_interfaces {

namespace srv {

struct DeleteEntity {
  static constexpr const char* kName = "simulation_interfaces/srv/DeleteEntity";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/DeleteEntity_Request";
    std::string entity;
    static void visit(auto& self, auto&& field) { field("entity", self.entity); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/DeleteEntity_Response";
    simulation_interfaces::Result result;
    static void visit(auto& self, auto&& field) { field("result", self.result); }
    bool operator==(const Response&) const = default;
  };
};

struct GetEntities {
  static constexpr const char* kName = "simulation_interfaces/srv/GetEntities";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetEntities_Request";
    simulation_interfaces::EntityFilters filters;
    static void visit(auto& self, auto&& field) { field("filters", self.filters); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetEntities_Response";
    simulation_interfaces::Result result;
    std::vector<std::string> entities;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("entities", self.entities);
    }
    bool operator==(const Response&) const = default;
  };
};

struct GetEntitiesStates {
  static constexpr const char* kName = "simulation_interfaces/srv/GetEntitiesStates";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetEntitiesStates_Request";
    simulation_interfaces::EntityFilters filters;
    static void visit(auto& self, auto&& field) { field("filters", self.filters); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetEntitiesStates_Response";
    simulation_interfaces::Result result;
    std::vector<std::string> entities;
    std::vector<simulation_interfaces::EntityState> states;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("entities", self.entities);
      field("states", self.states);
    }
    bool operator==(const Response&) const = default;
  };
};

struct GetEntityBounds {
  static constexpr const char* kName = "simulation_interfaces/srv/GetEntityBounds";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetEntityBounds_Request";
    std::string entity;
    static void visit(auto& self, auto&& field) { field("entity", self.entity); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetEntityBounds_Response";
    simulation_interfaces::Result result;
    simulation_interfaces::Bounds bounds;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("bounds", self.bounds);
    }
    bool operator==(const Response&) const = default;
  };
};

struct GetEntityInfo {
  static constexpr const char* kName = "simulation_interfaces/srv/GetEntityInfo";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetEntityInfo_Request";
    std::string entity;
    static void visit(auto& self, auto&& field) { field("entity", self.entity); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetEntityInfo_Response";
    simulation_interfaces::Result result;
    simulation_interfaces::EntityInfo info;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("info", self.info);
    }
    bool operator==(const Response&) const = default;
  };
};

struct GetEntityState {
  static constexpr const char* kName = "simulation_interfaces/srv/GetEntityState";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetEntityState_Request";
    std::string entity;
    static void visit(auto& self, auto&& field) { field("entity", self.entity); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetEntityState_Response";
    simulation_interfaces::Result result;
    simulation_interfaces::EntityState state;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("state", self.state);
    }
    bool operator==(const Response&) const = default;
  };
};

struct GetNamedPoseBounds {
  static constexpr const char* kName = "simulation_interfaces/srv/GetNamedPoseBounds";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetNamedPoseBounds_Request";
    std::string name;
    static void visit(auto& self, auto&& field) { field("name", self.name); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetNamedPoseBounds_Response";
    simulation_interfaces::Result result;
    simulation_interfaces::Bounds bounds;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("bounds", self.bounds);
    }
    bool operator==(const Response&) const = default;
  };
};

struct GetNamedPoses {
  static constexpr const char* kName = "simulation_interfaces/srv/GetNamedPoses";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetNamedPoses_Request";
    simulation_interfaces::TagsFilter tags;
    static void visit(auto& self, auto&& field) { field("tags", self.tags); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetNamedPoses_Response";
    simulation_interfaces::Result result;
    std::vector<simulation_interfaces::NamedPose> poses;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("poses", self.poses);
    }
    bool operator==(const Response&) const = default;
  };
};

struct GetSpawnables {
  static constexpr const char* kName = "simulation_interfaces/srv/GetSpawnables";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/GetSpawnables_Request";
    std::vector<std::string> sources;
    static void visit(auto& self, auto&& field) { field("sources", self.sources); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/GetSpawnables_Response";
    simulation_interfaces::Result result;
    std::vector<simulation_interfaces::Spawnable> spawnables;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("spawnables", self.spawnables);
    }
    bool operator==(const Response&) const = default;
  };

  using OlderResponse = simulation_interfaces_1::GetSpawnablesResponse;
  static OlderResponse toOlder(const Response& response) {
    OlderResponse older{response.result, {}};
    for (const Spawnable& each : response.spawnables) {
      older.spawnables.push_back({each.entity_resource.uri, each.description, each.spawn_bounds});
    }
    return older;
  }
};

struct SetEntityInfo {
  static constexpr const char* kName = "simulation_interfaces/srv/SetEntityInfo";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/SetEntityInfo_Request";
    std::string entity;
    simulation_interfaces::EntityInfo info;
    static void visit(auto& self, auto&& field) {
      field("entity", self.entity);
      field("info", self.info);
    }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/SetEntityInfo_Response";
    simulation_interfaces::Result result;
    static void visit(auto& self, auto&& field) { field("result", self.result); }
    bool operator==(const Response&) const = default;
  };
};

struct SetEntityState {
  static constexpr const char* kName = "simulation_interfaces/srv/SetEntityState";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/SetEntityState_Request";
    std::string entity;
    simulation_interfaces::EntityState state;
    bool set_pose = false;
    bool set_twist = false;
    bool set_acceleration = false;
    static void visit(auto& self, auto&& field) {
      field("entity", self.entity);
      field("state", self.state);
      field("set_pose", self.set_pose);
      field("set_twist", self.set_twist);
      field("set_acceleration", self.set_acceleration);
    }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/SetEntityState_Response";
    static constexpr std::uint8_t kInvalidPose = 101;
    simulation_interfaces::Result result;
    static void visit(auto& self, auto&& field) { field("result", self.result); }
    bool operator==(const Response&) const = default;
  };

  /// Sets everything that it contains.
  using OlderRequest = simulation_interfaces_1::SetEntityStateRequest;
  static Request fromOlder(const OlderRequest& older) { return {older.entity, older.state, true, true, true}; }
};

struct SpawnEntities {
  static constexpr const char* kName = "simulation_interfaces/srv/SpawnEntities";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/SpawnEntities_Request";
    std::vector<simulation_interfaces::SpawnEntity> spawn_requests;
    static void visit(auto& self, auto&& field) { field("spawn_requests", self.spawn_requests); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/SpawnEntities_Response";
    static constexpr std::uint8_t kEntitiesSpawnFailed = 150;
    simulation_interfaces::Result result;
    std::vector<simulation_interfaces::SpawnResult> results;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("results", self.results);
    }
    bool operator==(const Response&) const = default;
  };
};

struct SpawnEntity {
  static constexpr const char* kName = "simulation_interfaces/srv/SpawnEntity";
  struct Request {
    static constexpr const char* kName = "simulation_interfaces/srv/SpawnEntity_Request";
    std::string name;
    bool allow_renaming = false;
    simulation_interfaces::Resource entity_resource;
    std::string entity_namespace;
    geometry_msgs::PoseStamped initial_pose;
    static void visit(auto& self, auto&& field) {
      field("name", self.name);
      field("allow_renaming", self.allow_renaming);
      field("entity_resource", self.entity_resource);
      field("entity_namespace", self.entity_namespace);
      field("initial_pose", self.initial_pose);
    }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "simulation_interfaces/srv/SpawnEntity_Response";
    static constexpr std::uint8_t kNameNotUnique = 101;
    static constexpr std::uint8_t kNameInvalid = 102;
    static constexpr std::uint8_t kUnsupportedFormat = 103;
    static constexpr std::uint8_t kNoResource = 104;
    static constexpr std::uint8_t kNamespaceInvalid = 105;
    static constexpr std::uint8_t kResourceParseError = 106;
    static constexpr std::uint8_t kMissingAssets = 107;
    static constexpr std::uint8_t kUnsupportedAssets = 108;
    static constexpr std::uint8_t kInvalidPose = 109;
    simulation_interfaces::Result result;
    std::string entity_name;
    static void visit(auto& self, auto&& field) {
      field("result", self.result);
      field("entity_name", self.entity_name);
    }
    bool operator==(const Response&) const = default;
  };

  using OlderRequest = simulation_interfaces_1::SpawnEntityRequest;
  static Request fromOlder(const OlderRequest& older) {
    return {older.name,
            older.allow_renaming,
            {older.uri, older.resource_string},
            older.entity_namespace,
            older.initial_pose};
  }
};

}  // namespace srv

}  // namespace pongsim::ros2::simulation_interfaces
